/** What all elements of a page have in common: begun with the first that takes it, ended with the last. A page that has one of its own lends it. */

/** A share, to be given back. */
export interface Share<T> {
  readonly it: T;
  leave(): void;
}

export class Shared<T extends { dispose(): void }> {
  readonly #begin: () => T;
  #lent: T | null = null;
  #own: T | null = null;
  #users = 0;

  constructor(begin: () => T) {
    this.#begin = begin;
  }

  take(): Share<T> {
    if (this.#lent) return { it: this.#lent, leave: () => {} };
    this.#own ??= this.#begin();
    this.#users += 1;
    let left = false;
    return {
      it: this.#own,
      leave: () => {
        if (left) return;
        left = true;
        this.#users -= 1;
        if (this.#users > 0) return;
        this.#own?.dispose();
        this.#own = null;
      },
    };
  }

  /** Has those that come from now on take this one; none of the page's own at null. */
  lend(lent: T | null): void {
    this.#lent = lent;
  }
}
