/** What the page has to say besides the pot: a sentence for a moment, and that there is a new version. */

import { signal } from "@preact/signals-core";

export interface Notice {
  readonly text: string;
  readonly id: number;
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

  say(text: string): void {
    this.#last += 1;
    this.#notice.value = { text, id: this.#last };
  }

  /** Does nothing where something newer was said meanwhile. */
  dismiss(id: number): void {
    if (this.#notice.peek()?.id === id) this.#notice.value = null;
  }

  announceNewVersion(): void {
    this.#newVersion.value = true;
  }
}
