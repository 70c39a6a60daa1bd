/** The selected part in another order, shown beside the design while a person compares them. */

import { batch, computed, effect, signal } from "@preact/signals-core";
import { convertible } from "../document/orders";
import { setPath } from "../document/path";
import type { Design, OrderKind, Refusal } from "../document/types";
import type { SolverClient } from "../solver/client";
import type { SolvedParts } from "../solver/solved";
import type { Store } from "../state/store";
import type { Surface } from "./surface";

export interface Compared {
  readonly order: OrderKind;
  readonly design: Design;
  readonly solved: SolvedParts;
}

export class Comparison {
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #solver: SolverClient;
  readonly #order = computed(() => this.#store.session.compare);
  readonly #shown = signal<Compared | null>(null);
  readonly #problem = signal<Refusal | null>(null);

  constructor(store: Store, surface: Surface, solver: SolverClient) {
    this.#store = store;
    this.#surface = surface;
    this.#solver = solver;
  }

  get shown(): Compared | null {
    return this.#shown.value;
  }

  /** Why there is nothing to compare with. */
  get problem(): Refusal | null {
    return this.#problem.value;
  }

  /** Follows the document until what comes back is called. */
  connect(): () => void {
    return effect(() => {
      const order = this.#order.value;
      if (order) void this.#compare(order, this.#store.design, this.#store.part);
      else this.#put(null, null);
    });
  }

  async #compare(order: OrderKind, design: Design, part: number): Promise<void> {
    const shape = design.parts[part]?.shape;
    if (!shape || !convertible(shape.kind)) {
      this.#put(null, null);
      return;
    }
    const made = await this.#solver.convert("compare", shape, order);
    if (this.#order.peek() !== order || this.#store.design !== design || made.state === "superseded") return;
    if (made.state === "refused") {
      this.#put(this.#shown.peek(), made.refusal);
      return;
    }
    const other = setPath(design, ["parts", part, "shape"], made.value.shape);
    const { rows, columns } = this.#surface.grid(other);
    const outcome = await this.#solver.mesh("compare", other, rows, columns);
    if (outcome.state === "superseded" || this.#order.peek() !== order) return;
    if (outcome.state === "refused") this.#put(this.#shown.peek(), outcome.refusal);
    else this.#put({ order, design: other, solved: outcome.value }, null);
  }

  #put(shown: Compared | null, problem: Refusal | null): void {
    batch(() => {
      this.#shown.value = shown;
      this.#problem.value = problem;
    });
  }
}
