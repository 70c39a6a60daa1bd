/** The points of a part that go first where it is pushed: those that face the way it goes, and its ends. */

import { placedNormals } from "./placed-normals";
import { type Matrix, placedAll } from "./placement";
import type { Triple } from "./types";

/** A surface that leans away by more than some 70 degrees is a side. */
const FACING = 0.34;

interface Meshed {
  readonly matrix: Matrix;
  readonly mesh: { readonly positions: Float32Array; readonly normals: Float32Array };
}

/** Points (xyz) of a placed mesh that face a unit vector, and with `ends`, so many points in a row, those of its first row and its last; about as many as are asked for. */
export function leadingPoints(
  { matrix, mesh: { positions, normals } }: Meshed,
  towards: Triple,
  ends: number,
  most: number,
): readonly Triple[] {
  const [placed, turned] = [placedAll(matrix, positions), placedNormals(matrix, normals)];
  const count = positions.length / 3;
  const at = (all: Float64Array, k: number): Triple => [
    all[3 * k] as number,
    all[3 * k + 1] as number,
    all[3 * k + 2] as number,
  ];
  const found: Triple[] = [];
  for (let k = 0; k < count; k += 1) {
    const [x, y, z] = at(turned, k);
    const faces = x * towards[0] + y * towards[1] + z * towards[2] > FACING;
    if (faces || k < ends || k >= count - ends) found.push(at(placed, k));
  }
  const stride = Math.max(1, Math.ceil(found.length / most));
  return found.filter((_, k) => k % stride === 0);
}
