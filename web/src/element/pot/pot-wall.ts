/** The wall of a pot in a page: made by one maker for all elements, and drawn beside the surface. Fetched with the first design that has one. */

import { looksOf } from "../../document/look";
import type { Design } from "../../document/types";
import { sameSurface } from "../../document/wall";
import type { Solid } from "../../maker/messages";
import { Made } from "../../render/made/made";
import type { Stage } from "../../render/stage";
import type { Bounds } from "../../solver/bounds";
import type { SolvedParts } from "../../solver/solved";
import { makers } from "./shared-maker";

/** How far the picture may be from the faces, as a share of the size of the pot, which is smaller here than in the designer. */
const FINENESS = 1 / 450;

/** What walls fill together with parts that have none. */
type With = (walls: Bounds | null) => Bounds | null;

export class PotWall {
  readonly #share = makers.take();
  readonly #lane: string;
  readonly #drawing: Made;
  /** Whose wall is shown, or under way. */
  #of: Design | null = null;

  /** `lane` is the element's own. */
  constructor(stage: Stage, lane: string) {
    this.#lane = lane;
    this.#drawing = stage.invite((place) => new Made(place));
  }

  /** Shows the wall of a design once it is made, until then that of the same surface or none. A wall that is refused is not drawn: the surface stands as it is. */
  async show(design: Design, { bounds }: SolvedParts, all: With): Promise<void> {
    const before = this.#of;
    if (before === design) return;
    this.#share.it.cancel(this.#lane);
    if (before && !sameSurface(before.parts, design.parts)) this.#draw(null, before);
    this.#of = design;
    if (!bounds || design.parts.every(({ wall }) => wall === undefined)) {
      this.#draw(null, design);
      return;
    }
    const sides = bounds.max.map((most, axis) => most - (bounds.min[axis] ?? most));
    const tolerance = FINENESS * Math.max(...sides);
    const outcome = await this.#share.it.ask({ kind: "solid", design, tolerance, fine: false }, this.#lane);
    if (outcome.state === "superseded" || this.#of !== design) return;
    this.#draw(outcome.state === "done" ? outcome.value : null, design, all);
  }

  /** Takes the wall away and ends what is under way: another surface is shown. */
  rest(): void {
    if (!this.#of) return;
    this.#share.it.cancel(this.#lane);
    this.#draw(null, this.#of);
    this.#of = null;
  }

  /** Gives the maker back; what is drawn goes with the stage. */
  dispose(): void {
    this.#of = null;
    this.#share.it.cancel(this.#lane);
    this.#share.leave();
  }

  #draw(solid: Solid | null, design: Design, all: With = (walls) => walls): void {
    this.#drawing.show(solid, looksOf(design), [], all(solid?.bounds ?? null));
  }
}
