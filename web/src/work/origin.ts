/** What the design on the stage was opened as, followed through every change: where a reset leads, and how large it was then. */

import { effect, untracked } from "@preact/signals-core";
import type { Design } from "../document/types";
import { Origins } from "../state/origins";
import type { PartId } from "../state/part-ids";
import type { Store } from "../state/store";
import type { Surface } from "./surface";

export class Origin {
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #origins = new Origins();
  /** How large each design was when it was first solved. */
  readonly #sizes = new WeakMap<Design, number>();
  /** The design that was followed last, and who its parts were. */
  #last: Design;
  #lastIds: readonly PartId[];

  constructor(store: Store, surface: Surface) {
    this.#store = store;
    this.#surface = surface;
    this.#last = store.design;
    this.#lastIds = store.ids;
  }

  /** The design as it was opened. */
  get design(): Design {
    return this.of(this.#store.design);
  }

  /** How high or wide it was then, whichever is more; null before it was solved. */
  get size(): number | null {
    this.#learn();
    return this.#sizes.get(this.design) ?? null;
  }

  /** What a design of the history was opened as. */
  of(design: Design): Design {
    this.#follow();
    return this.#origins.of(design);
  }

  /** A design was opened; or it goes on from where it was opened in an earlier visit. */
  open(design: Design, origin: Design = design): void {
    this.#origins.open(design, origin);
  }

  /** The design is made larger or smaller, or said in another unit: so is what it was opened as. */
  convert(design: Design, convert: (origin: Design) => Design): void {
    this.#follow();
    this.#origins.convert(design, this.#last, convert);
  }

  /** Follows the document and what is on the stage until what comes back is called. */
  connect(): () => void {
    return effect(() => {
      this.#follow();
      this.#learn();
    });
  }

  #follow(): void {
    const { design, ids } = this.#store;
    if (design === this.#last) return;
    const before = this.#lastIds;
    this.#origins.follow(design, this.#last, (place) => before.indexOf(ids[place] ?? -1));
    this.#last = design;
    this.#lastIds = ids;
  }

  #learn(): void {
    const { shown } = this.#surface;
    if (!shown?.solved.facts) return;
    const { height, width, depth } = shown.solved.facts;
    const origin = untracked(() => this.of(shown.design));
    if (!this.#sizes.has(origin)) this.#sizes.set(origin, Math.max(height, width, depth));
  }
}
