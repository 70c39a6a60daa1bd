/** What the vertices of a mesh fill. */

import type { Box } from "../document/box";
import { type Matrix, placedAll } from "../document/placement";
import type { Triple } from "../document/types";

export interface Bounds {
  readonly min: Triple;
  readonly max: Triple;
  /** The middle of the box. */
  readonly centre: Triple;
  /** The largest distance of a point from the centre. */
  readonly radius: number;
}

/** What two sets of points fill together. The radius is one that is large enough. */
export function around(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (!a || !b) return a ?? b;
  const each = (of: (axis: 0 | 1 | 2) => number): Triple => [of(0), of(1), of(2)];
  const min = each((axis) => Math.min(a.min[axis], b.min[axis]));
  const max = each((axis) => Math.max(a.max[axis], b.max[axis]));
  const centre = each((axis) => (min[axis] + max[axis]) / 2);
  const reach = ({ centre: [x, y, z], radius }: Bounds) =>
    Math.hypot(x - centre[0], y - centre[1], z - centre[2]) + radius;
  return { min, max, centre, radius: Math.max(reach(a), reach(b)) };
}

/** A part where it stands: what it fills before placement, and after it. */
export interface Standing {
  readonly matrix: Matrix;
  readonly bounds: Bounds | null;
  readonly box: Box | null;
}

/** What parts fill together where they stand. The box is that of their farthest points; the radius is large enough. */
export function boundsOfParts(parts: readonly Standing[]): Bounds | null {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const { box } of parts) {
    for (const axis of [0, 1, 2] as const) {
      min[axis] = Math.min(min[axis] as number, box?.min[axis] ?? Infinity);
      max[axis] = Math.max(max[axis] as number, box?.max[axis] ?? -Infinity);
    }
  }
  const [x0, y0, z0] = min as [number, number, number];
  const [x1, y1, z1] = max as [number, number, number];
  if (!(x1 >= x0)) return null;
  const centre: Triple = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2];
  const far = parts.map(({ matrix, bounds }) => {
    if (!bounds) return 0;
    const [x, y, z] = placedAll(matrix, bounds.centre) as unknown as Triple;
    return Math.hypot(x - centre[0], y - centre[1], z - centre[2]) + stretch(matrix) * bounds.radius;
  });
  // Nothing is farther than a corner of the box.
  const corner = Math.hypot(x1 - centre[0], y1 - centre[1], z1 - centre[2]);
  return { min: [x0, y0, z0], max: [x1, y1, z1], centre, radius: Math.min(corner, Math.max(...far)) };
}

/** How much longer anything becomes at most: placements scale along the axes of the part. */
function stretch(matrix: Matrix): number {
  const column = (i: number) => Math.hypot(...matrix.slice(4 * i, 4 * i + 3));
  return Math.max(column(0), column(1), column(2));
}

/**
 * The bounds of xyz triples, or null when there are none. The box is exact; the radius is that of `sample`, fewer points of
 * the same surface, because the camera and the light need no better one.
 */
export function boundsOf(positions: Float32Array, sample = positions): Bounds | null {
  if (positions.length < 3) return null;
  let [x0, y0, z0] = [Infinity, Infinity, Infinity];
  let [x1, y1, z1] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i] as number;
    const y = positions[i + 1] as number;
    const z = positions[i + 2] as number;
    if (x < x0) x0 = x;
    if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    if (y > y1) y1 = y;
    if (z < z0) z0 = z;
    if (z > z1) z1 = z;
  }
  const centre: Triple = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2];
  let squared = 0;
  for (let i = 0; i < sample.length; i += 3) {
    const x = (sample[i] as number) - centre[0];
    const y = (sample[i + 1] as number) - centre[1];
    const z = (sample[i + 2] as number) - centre[2];
    squared = Math.max(squared, x * x + y * y + z * z);
  }
  return { min: [x0, y0, z0], max: [x1, y1, z1], centre, radius: Math.sqrt(squared) };
}
