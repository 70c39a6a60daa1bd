/** The glazes, clays and unit of a design, defaults included. */

import { DEFAULTS } from "./tables.gen";
import type { Design, Look, Part, Unit } from "./types";

/** Both names of a part's look, defaults included. */
export function lookOf(part: Part | undefined): Required<Look> {
  return {
    glaze: part?.look?.glaze ?? DEFAULTS.glaze,
    clay: part?.look?.clay ?? DEFAULTS.clay,
  };
}

export function looksOf(design: Design): readonly Required<Look>[] {
  return design.parts.map(lookOf);
}

export function unitOf(design: Design): Unit {
  return design.unit ?? DEFAULTS.unit;
}
