/** The numbers of the selected part that somebody points at, in a formula or at a field: what stands for them lights up everywhere else. */

import { computed, signal } from "@preact/signals-core";

export class Pointed {
  readonly #at = signal<{ readonly places: readonly string[]; readonly by: "formula" | "field" | null }>({
    places: [],
    by: null,
  });
  readonly #places = computed(() => this.#at.value.places);

  /** As the solver names them inside the shape. */
  get places(): readonly string[] {
    return this.#places.value;
  }

  /** Whoever points is told nothing: what is under the hand is marked already. */
  elsewhere(than: "formula" | "field"): readonly string[] {
    const { places, by } = this.#at.value;
    return by === than ? [] : places;
  }

  point(by: "formula" | "field", places: readonly string[]): void {
    this.#at.value = { places, by };
  }

  /** Whoever pointed last no longer does. */
  leave(by: "formula" | "field"): void {
    if (this.#at.peek().by === by) this.#at.value = { places: [], by: null };
  }
}
