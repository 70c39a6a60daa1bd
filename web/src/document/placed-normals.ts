/** Normals of what is scaled and turned. */

import { type Matrix, placedAll } from "./placement";

/** Unit normals of what is placed: they go by the cofactors of the matrix, and point out of a mirrored shape as before. */
export function placedNormals(matrix: Matrix, normals: ArrayLike<number>): Float64Array {
  const m = (row: number, column: number) => matrix[4 * column + row] as number;
  const cofactor = (row: number, column: number) => {
    const [a, b, c, d] = [(row + 1) % 3, (row + 2) % 3, (column + 1) % 3, (column + 2) % 3];
    return m(a, c) * m(b, d) - m(a, d) * m(b, c);
  };
  const sign = [0, 1, 2].reduce((sum, i) => sum + m(i, 0) * cofactor(i, 0), 0) < 0 ? -1 : 1;
  const linear = [0, 1, 2].flatMap((column) => [...[0, 1, 2].map((row) => sign * cofactor(row, column)), 0]);
  const out = placedAll([...linear, 0, 0, 0, 1], normals, 0);
  for (let i = 0; i < out.length; i += 3) {
    const [x, y, z] = [out[i] as number, out[i + 1] as number, out[i + 2] as number];
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0) out.set([x / length, y / length, z / length], i);
  }
  return out;
}
