/** The glazes, clays and unit of a design, defaults included. */

import { DEFAULTS } from "./tables.gen";
import type { ClayChoice, Design, GlazeChoice, Part, Unit } from "./types";

/** What a part is covered with and made of. */
export interface Looked {
  readonly glaze: GlazeChoice;
  readonly inside: GlazeChoice;
  /** Where the glaze of the outside ends, as a share of its height. */
  readonly line: number;
  readonly clay: ClayChoice;
}

export function lookOf(part: Part | undefined): Looked {
  const { glaze = DEFAULTS.glaze, inside = glaze, line = 0, clay = DEFAULTS.clay } = part?.look ?? {};
  return { glaze, inside, line, clay };
}

export function looksOf(design: Design): readonly Looked[] {
  return design.parts.map(lookOf);
}

export function unitOf(design: Design): Unit {
  return design.unit ?? DEFAULTS.unit;
}
