/** The rings of a pot as handles on its section, beside those of its ends, and where on the wall a new one would be. */

import type { Handle, Shape } from "./types";

/** A ring between the ends, on the section: its radius and its height are its own. */
export interface RingHandle {
  readonly id: `ring-${number}`;
  /** Its number from the foot on. */
  readonly index: number;
  readonly radial: Handle["radial"];
  readonly axial: Handle["axial"];
}

/** The rings of a pot between its ends; none of any other shape. */
export function ringHandles(shape: Shape): readonly RingHandle[] {
  if (shape.kind !== "rings") return [];
  return shape.rings.slice(1, -1).map((_, place): RingHandle => {
    const index = place + 1;
    const one = (of: "r" | "z") => [{ path: `rings[${index}].${of}.mean`, by: 1 }];
    return { id: `ring-${index}`, index, radial: one("r"), axial: one("z") };
  });
}

/** Where the wall on the section (`x, z` pairs, evenly spaced along `u`) is nearest to a point: how far along, and how far away. */
export function nearestOn(
  line: ArrayLike<number>,
  x: number,
  z: number,
): { readonly u: number; readonly away: number } {
  const count = line.length / 2;
  let [best, away] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i < count; i += 1) {
    const far = Math.hypot((line[2 * i] as number) - x, (line[2 * i + 1] as number) - z);
    if (far < away) [best, away] = [i, far];
  }
  return { u: count > 1 ? best / (count - 1) : 0, away };
}
