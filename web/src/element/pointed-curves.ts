/** The curves on the pot that numbers of a part are about, where they stand. */

import { matrixOf } from "../document/placement";
import type { Part } from "../document/types";
import { curvesOf } from "../equation/curves";

export function pointedCurves(part: Part | undefined, places: readonly string[]): Float32Array[] {
  const matrix = matrixOf(part?.place);
  if (!part || !matrix) return [];
  const curves = curvesOf(part.shape, places);
  return part.place === undefined ? curves : curves.map((curve) => placed(curve, matrix));
}

function placed(curve: Float32Array, matrix: readonly number[]): Float32Array {
  const at = (row: number, column: number) => matrix[4 * column + row] ?? 0;
  return curve.map((_, index) => {
    const row = index % 3;
    const first = index - row;
    const [x = 0, y = 0, z = 0] = curve.subarray(first, first + 3);
    return at(row, 0) * x + at(row, 1) * y + at(row, 2) * z + at(row, 3);
  });
}
