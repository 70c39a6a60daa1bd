/**
 * Which of the tabs this one is. Each keeps its work under a name of its own. The name stands in sessionStorage, which lives as long as its tab does and through reloads;
 * but a browser copies it when a tab is duplicated, so the name is a tab's own only once it has the Web Lock of that name too, which the browser takes back when the tab is
 * closed or dies. By the same lock a new tab knows which works nobody has open any more: it goes on with the newest of them.
 */

import {
  allWork,
  forgetOldWork,
  type KeptWork,
  keepTab,
  readTab,
  readWork,
  type Shelf,
  type Work,
} from "../state/storage";

/**
 * Claims a tab's name for as long as this page lives, waiting so many milliseconds for it. False when another page has it, null where nobody can know.
 */
export type Claim = (tab: string, patience?: number) => Promise<boolean | null>;

/** A page that is reloaded has its name as soon as the page before it has let go of it. */
const PATIENCE = 500;

export class Seat {
  readonly #shelf: Shelf | null;
  readonly #own: Shelf | null;
  readonly #claim: Claim;
  #name = freshName();

  constructor(shelf: Shelf | null, own: Shelf | null, claim: Claim) {
    this.#shelf = shelf;
    this.#own = own;
    this.#claim = claim;
  }

  get name(): string {
    return this.#name;
  }

  /** The work to go on with. `linked` tabs, which come to see something else, leave the works of others where they are. */
  async take(linked: boolean): Promise<Work | null> {
    const before = readTab(this.#own);
    const work = before === null ? await this.#inherit(linked) : await this.#goOn(before);
    keepTab(this.#own, this.#name);
    forgetOldWork(this.#shelf);
    return work;
  }

  /** The works of closed tabs that are nowhere else; no other tab goes on with them from now on. */
  async left(): Promise<readonly KeptWork[]> {
    const found: KeptWork[] = [];
    for (const kept of allWork(this.#shelf)) {
      const others = kept.work.unsaved && kept.tab !== this.#name;
      if (others && (await this.#claim(kept.tab))) found.push(kept);
    }
    return found;
  }

  /** The tab was here before, or is a copy of one that was: a copy begins with the same work and keeps it under another name. */
  async #goOn(before: string): Promise<Work | null> {
    if ((await this.#claim(before, PATIENCE)) === false) await this.#claim(this.#name);
    else this.#name = before;
    return readWork(this.#shelf, before);
  }

  async #inherit(linked: boolean): Promise<Work | null> {
    for (const { tab, work } of linked ? [] : allWork(this.#shelf)) {
      const claimed = await this.#claim(tab);
      if (claimed === false) continue;
      // Where nobody knows whether somebody else has it open, it goes on as a copy.
      if (claimed) this.#name = tab;
      return work;
    }
    await this.#claim(this.#name);
    return null;
  }
}

/** A name that nothing ever had; also where there is no secure context, and so no `randomUUID`. */
export function freshName(): string {
  return Array.from(crypto.getRandomValues(new Uint32Array(3)), (word) => word.toString(36)).join("-");
}
