/** What the page has to say besides the pot: a sentence for a moment, and that there is a new version. */

import { signal } from "@preact/signals-core";

export interface Notice {
  readonly text: string;
  readonly id: number;
  /** What takes back what is told; null where nothing can. */
  readonly undo: Undo | null;
}

/** A way back. */
export interface Undo {
  readonly label: string;
  /** What it does otherwise than take back what was done: saves what has no address. */
  readonly saves?: boolean;
  /** Takes it back, and says what became of that. */
  act(): Promise<string>;
}

export class Notices {
  readonly #notice = signal<Notice | null>(null);
  readonly #newVersion = signal(false);
  #last = 0;

  get notice(): Notice | null {
    return this.#notice.value;
  }

  get newVersion(): boolean {
    return this.#newVersion.value;
  }

  say(text: string, undo: Undo | null = null): void {
    this.#last += 1;
    const notice = { text, id: this.#last, undo };
    const isSaid = this.#notice.peek()?.text === text;
    this.#notice.value = isSaid ? null : notice;
    // The same words are read aloud again where they were gone meanwhile.
    if (!isSaid) return;
    setTimeout(() => {
      if (this.#last === notice.id) this.#notice.value = notice;
    });
  }

  /** Does nothing where something newer was said meanwhile. */
  dismiss(id: number): void {
    if (this.#notice.peek()?.id === id) this.#notice.value = null;
  }

  /** Takes back what the present notice tells of, once, and says what became of that. */
  async undo(): Promise<void> {
    const notice = this.#notice.peek();
    if (!notice?.undo) return;
    this.dismiss(notice.id);
    this.say(await notice.undo.act());
  }

  announceNewVersion(): void {
    this.#newVersion.value = true;
  }
}
