/** The colours by which glazes and clays are chosen: for where they are, and not for what only draws. */

import { CLAYS, DEFAULTS, GLAZES } from "./tables.gen";
import type { ClayChoice, Colour, GlazeChoice } from "./types";

/** Whether it is a colour of one's own, and no name. */
export function isOwn(choice: GlazeChoice | ClayChoice): choice is Colour {
  return choice.startsWith("#");
}

/** The colour by which a glaze or clay is chosen. */
export function swatchOf(choice: GlazeChoice | ClayChoice): Colour {
  const swatches: Readonly<Record<string, Colour>> = { ...GLAZES, ...CLAYS };
  return isOwn(choice) ? choice : (swatches[choice] ?? GLAZES[DEFAULTS.glaze]);
}
