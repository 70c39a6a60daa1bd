/** Curves on a part: isoparametric lines and boundaries from the mesh itself, tangents from the exact derivatives. */

import type { Grid } from "../document/body";
import { IDENTITY, type Matrix, placedAll } from "../document/placement";
import type { LineArrays, PartLines } from "./messages";

const LINES_ROUND = 11;
const LINES_UP = 24;
const ARROWS = 24;

/** One row of the grid, `u` constant. */
export function rowOf({ positions, columns }: Grid, row: number): Float32Array {
  return new Float32Array(positions.subarray(3 * row * columns, 3 * (row + 1) * columns));
}

/** One column of the grid, `v` constant. */
function columnOf({ positions, rows, columns }: Grid, column: number): Float32Array {
  const line = new Float32Array(3 * rows);
  for (let row = 0; row < rows; row += 1) {
    const from = 3 * (row * columns + column);
    line.set(positions.subarray(from, from + 3), 3 * row);
  }
  return line;
}

/** Where the tangent arrows stand, as `(u, v)` pairs: the same `v` at both ends. */
export function tangentPoints(span: number): Float64Array {
  const at = new Float64Array(4 * ARROWS);
  for (let i = 0; i < ARROWS; i += 1) {
    const v = (span * i) / ARROWS;
    at.set([0, v], 2 * i);
    at.set([1, v], 2 * (ARROWS + i));
  }
  return at;
}

/** The lines of one part. `tangents` are positions and `X_u`. */
export function linesOf(grid: Grid, tangents: PartLines["tangents"]): PartLines {
  const along = Array.from({ length: LINES_ROUND }, (_, i) =>
    rowOf(grid, Math.round(((i + 1) * (grid.rows - 1)) / (LINES_ROUND + 1))),
  );
  const up = Array.from({ length: LINES_UP }, (_, i) =>
    columnOf(grid, Math.round((i * (grid.columns - 1)) / LINES_UP)),
  );
  return { iso_u: along, iso_v: up, ends: [rowOf(grid, 0), rowOf(grid, grid.rows - 1)], tangents };
}

/** The lines of a part where it stands. */
export function placedLines(lines: PartLines, matrix: Matrix): LineArrays {
  const at = new Float32Array(placedAll(matrix, lines.tangents.at));
  const along = new Float32Array(placedAll(matrix, lines.tangents.along, 0));
  const tangents: LineArrays["tangents"] = [];
  for (let i = 0; i < at.length; i += 3) tangents.push({ at: at.subarray(i, i + 3), along: along.subarray(i, i + 3) });
  return {
    iso_u: lines.iso_u.map((line) => placedLine(matrix, line)),
    iso_v: lines.iso_v.map((line) => placedLine(matrix, line)),
    ...boundaries(lines, matrix),
    tangents,
  };
}

function placedLine(matrix: Matrix, line: Float32Array): Float32Array {
  return matrix === IDENTITY ? line : new Float32Array(placedAll(matrix, line));
}

function boundaries({ ends }: PartLines, matrix: Matrix): Pick<LineArrays, "rim" | "foot"> {
  const [start, end] = ends.map((line) => placedLine(matrix, line)) as [Float32Array, Float32Array];
  const [rim, foot] = meanHeight(start) >= meanHeight(end) ? [start, end] : [end, start];
  return { rim, foot };
}

function meanHeight(line: Float32Array): number {
  let sum = 0;
  for (let i = 2; i < line.length; i += 3) sum += line[i] ?? 0;
  return sum / (line.length / 3);
}
