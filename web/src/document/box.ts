/** What something fills of the scene: a box along its axes. */

import type { Triple } from "./types";

export interface Box {
  readonly min: Triple;
  readonly max: Triple;
}

/** The box of points (xyz); null where there is none. */
export function boxOf(points: ArrayLike<number>): Box | null {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 1) {
    const axis = (i % 3) as 0 | 1 | 2;
    const x = points[i] as number;
    if (x < min[axis]) min[axis] = x;
    if (x > max[axis]) max[axis] = x;
  }
  return min[0] <= max[0] ? { min, max } : null;
}
