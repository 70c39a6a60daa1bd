/** The two ends of a part where it stands: on which something can be put, and by which it stands on something. From the mesh, so as exact as that is. */

import { boxOf } from "../document/box";
import { middleOf } from "../document/boxes";
import { placedAll } from "../document/placement";
import type { Shape, Triple } from "../document/types";
import type { SolvedPart } from "../solver/solved";
import type { Rim, Rims } from "../state/stand-actions";

/** Shapes whose mesh is one grid from one end to the other. */
const UPRIGHT: readonly Shape["kind"][] = [
  "second-order",
  "mixed-order",
  "fourth-order",
  "bloor-wilson",
  "boundary-value",
  "rings",
];

/** Whether the first and the last row of points of a mesh are the two ends of the part. */
export function hasEnds(kind: Shape["kind"]): boolean {
  return UPRIGHT.includes(kind);
}

/** Of what has no ends the sides of the box that it fills; null for what fills nothing. */
export function rimsOf(
  { mesh, matrix, box }: Pick<SolvedPart, "mesh" | "matrix" | "box">,
  kind: Shape["kind"],
): Rims | null {
  if (!box) return null;
  const whole: Rim = { middle: [middleOf(box)[0], middleOf(box)[1]], high: box.max[2], width: box.max[0] - box.min[0] };
  if (!hasEnds(kind)) return { upper: whole, lower: whole };
  const columns = columnsOf(mesh.uvs);
  const { positions } = mesh;
  const ends = [positions.subarray(0, 3 * columns), positions.subarray(positions.length - 3 * columns)].flatMap(
    (row) => {
      const placed = placedAll(matrix, row);
      const end = boxOf(placed);
      const [x, y, level] = meanOf(placed);
      return end ? [{ middle: [x, y] as const, high: end.max[2], width: end.max[0] - end.min[0], level }] : [];
    },
  );
  const [lower, upper] = ends.sort((a, b) => a.level - b.level);
  return upper && lower ? { upper, lower } : null;
}

/** The mean of the points of a ring, whose last is its first: petals of any number lean to no side of it. */
function meanOf(ring: Float64Array): Triple {
  const mean = [0, 0, 0];
  const count = Math.max(1, ring.length / 3 - 1);
  for (let i = 0; i < ring.length - 3; i += 1) mean[i % 3] = (mean[i % 3] as number) + (ring[i] as number) / count;
  return mean as unknown as Triple;
}

/** Points of a row have one `u`. */
export function columnsOf(uvs: Float32Array): number {
  let columns = 1;
  while (2 * columns < uvs.length && uvs[2 * columns] === uvs[0]) columns += 1;
  return columns;
}
