/** The link in a text that is about it, as a mail is. */

import type { SolverClient } from "../solver/client";

/** Where a link of this or of another version has its design. */
const DESIGN = /#\d+[/~]/;

/** What ends a link, and what begins one: white space, brackets and quotation marks, of which links have none. */
const AROUND = /[\s()[\]{}<>"'“”„‘’‚«»]/;

/** What stands behind a link at the end of a sentence. */
const STOPS = /[.,;:!?]+$/;

/** What of a text is to be opened: all of it where it can be read as it is, as a link that a mail program broke over several lines can, or else the link in it. */
export async function linkOf(text: string, solver: Pick<SolverClient, "parse">): Promise<string> {
  const link = linkInText(text);
  if (link === null || link === text.trim()) return text;
  return (await solver.parse(text)).state === "refused" ? link : text;
}

/** The first one, with the view before its `#`; null where there is none, or a document. Each letter is looked at once or twice, however many marks of links there are. */
export function linkInText(text: string): string | null {
  const at = text.search(DESIGN);
  if (at < 0 || /^\ufeff?\s*\{/.test(text)) return null;
  let [from, to] = [at, at];
  while (from > 0 && !AROUND.test(text.charAt(from - 1))) from -= 1;
  while (to < text.length && !AROUND.test(text.charAt(to))) to += 1;
  return text.slice(from, to).replace(STOPS, "");
}
