/**
 * What every design of the history was opened as: where a reset leads, and what the ranges of sliders go by. A pot out of the gallery, of a link or of a
 * file keeps its origin through every change, and undo to a design opened before finds the origin of that one.
 */

import { isAlike } from "../document/alike";
import type { Design, Part } from "../document/types";

export class Origins {
  readonly #of = new WeakMap<Design, Design>();

  /** The design as it was opened; itself if nothing is known of it. */
  of(design: Design): Design {
    return this.#of.get(design) ?? design;
  }

  /** A design was opened; or it goes on from where it was opened in an earlier visit. */
  open(design: Design, origin: Design = design): void {
    this.#of.set(design, origin);
  }

  /** The design was made larger or smaller, or said in another unit: so is what it was opened as. */
  convert(design: Design, before: Design, convert: (origin: Design) => Design): void {
    if (design !== before && !this.#of.has(design)) this.#of.set(design, convert(this.of(before)));
  }

  /**
   * The design changed; `was` is the place that a part had before, -1 if it is new. A new part begins anew, and so does one that became another kind of shape:
   * what it was has none of its numbers.
   */
  follow(design: Design, before: Design, was: (place: number) => number): void {
    if (this.#of.has(design)) return;
    const origin = this.of(before);
    const parts = design.parts.map((part, index) => partOf(origin.parts[was(index)], part));
    this.#of.set(design, isAlike(parts, origin.parts) ? origin : { ...origin, parts });
  }
}

function partOf(origin: Part | undefined, now: Part): Part {
  return origin?.shape.kind === now.shape.kind ? origin : now;
}
