/** The languages that the page speaks, and which of them it begins with. */

import { ENGLISH, type Language, speak } from "../language";
import type { Catalogue } from "./catalogue";

/** What each language but English says, by its tag (BCP 47), fetched when it is chosen: `de: () => import("./de").then(({ de }) => de)`. */
type Catalogues = Readonly<Record<string, () => Promise<Catalogue>>>;

const CATALOGUES: Catalogues = {};

/** The tag by which tests ask for English with every letter of its words changed (see `pseudo.ts`). No person's browser asks for it. */
const PSEUDO = "en-XA";

/** The first of the tags that are wanted for which there are words, in the order of their owner's wish: "de-AT" is content with "de". */
export function tagFor(wanted: readonly string[], known: readonly string[]): string {
  for (const tag of wanted) {
    for (let shorter = tag; shorter !== ""; shorter = shorter.slice(0, Math.max(0, shorter.lastIndexOf("-")))) {
      const found = [ENGLISH.tag, ...known].find((each) => each.toLowerCase() === shorter.toLowerCase());
      if (found !== undefined) return found;
    }
  }
  return ENGLISH.tag;
}

/** A language that says what is in its catalogue. */
export function languageOf(tag: string, catalogue: Catalogue): Language {
  const rooms: Readonly<Record<string, object>> = { ...catalogue };
  return { tag, say: <T extends object>(room: string, english: T) => (rooms[room] as T | undefined) ?? english };
}

/**
 * Speaks what the address asks for (`?lang=`), else what the browser prefers. English is there at once, and null says so; for any other language whoever shows something first waits
 * for what comes back.
 */
export function choose(asked: string | null, preferred: readonly string[]): Promise<void> | null {
  if (asked === PSEUDO) return fetched(async () => (await import("./pseudo")).PSEUDO_ENGLISH);
  const tag = tagFor(asked === null ? preferred : [asked, ...preferred], Object.keys(CATALOGUES));
  const catalogue = CATALOGUES[tag];
  return catalogue ? fetched(async () => languageOf(tag, await catalogue())) : null;
}

/** Without a network it stays English. */
async function fetched(fetch: () => Promise<Language>): Promise<void> {
  try {
    speak(await fetch());
  } catch {
    // The page itself is there, and better in English than not at all.
  }
}
