/** The other scene that the design on the stage is held against, in colours. What that takes is fetched with what draws it. */

import { signal } from "@preact/signals-core";
import type { Design } from "../document/types";

export class Contrast {
  readonly #there = signal<Design | null>(null);

  /** Null where nothing is compared. */
  get there(): Design | null {
    return this.#there.value;
  }

  show(there: Design): void {
    this.#there.value = there;
  }

  close(): void {
    this.#there.value = null;
  }
}
