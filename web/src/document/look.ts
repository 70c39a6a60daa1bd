/** The glazes, clays and unit of a design, defaults included. */

import { CLAYS, DEFAULTS, GLAZES } from "./tables.gen";
import type { ClayChoice, Colour, Design, GlazeChoice, Part, Unit } from "./types";

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

/** Whether it is a colour of one's own, and no name. */
export function isOwn(choice: GlazeChoice | ClayChoice): choice is Colour {
  return choice.startsWith("#");
}

/** The colour by which a glaze or clay is chosen. */
export function swatchOf(choice: GlazeChoice | ClayChoice): Colour {
  const swatches: Readonly<Record<string, Colour>> = { ...GLAZES, ...CLAYS };
  return isOwn(choice) ? choice : (swatches[choice] ?? GLAZES[DEFAULTS.glaze]);
}

export function unitOf(design: Design): Unit {
  return design.unit ?? DEFAULTS.unit;
}
