/** Which report on the scene is shown on the stage: it is of one design, and goes with it. */

import { computed, signal } from "@preact/signals-core";
import type { Breach, Design } from "../document/types";
import type { Store } from "../state/store";

export interface Shown {
  readonly breach: Breach;
  readonly of: Design;
}

export class Witness {
  readonly #chosen = signal<Shown | null>(null);
  readonly #shown;

  constructor(store: Store) {
    this.#shown = computed(() => (this.#chosen.value?.of === store.design ? this.#chosen.value : null));
  }

  get shown(): Shown | null {
    return this.#shown.value;
  }

  /** Shows one, or none. */
  show(shown: Shown | null): void {
    this.#chosen.value = shown;
  }
}
