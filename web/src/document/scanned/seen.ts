/** A scan as it is seen from the side. */

import type { Levels } from "./levels";
import { DIRECTIONS } from "./section";

/** How far out it reaches anywhere. */
export function widestOf({ radii }: Levels): number {
  return radii.reduce((most, section) => section.reduce((a, b) => Math.max(a, b), most), 0);
}

/** The direction of its outermost point, by its number. */
export function frontOf(levels: Levels): number {
  const widest = widestOf(levels);
  return Math.max(0, ...levels.radii.map((section) => section.indexOf(widest)));
}

/** How far out a section is seen to reach that way. */
export function seenAt(section: Float64Array, direction: number): number {
  const turned = (k: number) => Math.cos((2 * Math.PI * (k - direction)) / DIRECTIONS);
  return section.reduce((most, radius, k) => Math.max(most, radius * turned(k)), 0);
}
