/** The colours of what became of parts. Apart from each other in lightness too; what stays as it is keeps its glaze. */

import type { Fate } from "../../document/fates";
import type { Colour } from "../../render/contrast/tints";

const COLOURS: Readonly<Record<Exclude<Fate, "kept">, Colour>> = {
  changed: [0.95, 0.62, 0.1],
  moved: [0.2, 0.45, 0.95],
  reglued: [0.58, 0.3, 0.75],
  added: [0.1, 0.62, 0.38],
  gone: [0.8, 0.16, 0.16],
};

export function colourOf(fate: Fate): Colour | null {
  return fate === "kept" ? null : COLOURS[fate];
}

/** As style sheets have it. */
export function cssOf([red, green, blue]: Colour): string {
  const share = (value: number) => `${(100 * value).toFixed(1)}%`;
  return `rgb(${share(red)} ${share(green)} ${share(blue)})`;
}
