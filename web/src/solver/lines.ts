/** Curves on the placed surface: isoparametric lines and boundaries from the mesh itself, tangents from the exact derivatives. */

import type { Grid } from "../document/facts";
import type { Placement, Triple } from "../document/types";
import type { LineArrays } from "./messages";

const LINES_ROUND = 11;
const LINES_UP = 24;
const ARROWS = 24;

/** One row of the grid, `u` constant. */
export function rowOf(grid: Grid, row: number): Float32Array {
  const from = 3 * (grid.first + row * grid.columns);
  return grid.positions.slice(from, from + 3 * grid.columns);
}

/** One column of the grid, `v` constant. */
export function columnOf(grid: Grid, column: number): Float32Array {
  const line = new Float32Array(3 * grid.rows);
  for (let row = 0; row < grid.rows; row += 1) {
    const from = 3 * (grid.first + row * grid.columns + column);
    line.set(grid.positions.subarray(from, from + 3), 3 * row);
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

/** The lines of all parts. `tangents` are positions and `X_u` of one part each, before placement. */
export function linesOf(
  grids: readonly Grid[],
  tangents: readonly { readonly at: Float64Array; readonly du: Float64Array; readonly place: Placement | undefined }[],
): LineArrays {
  const body = grids[0];
  const lines: LineArrays = {
    iso_u: [],
    iso_v: [],
    ...boundaries(body),
    tangents: [],
  };
  for (const grid of grids) {
    for (let i = 1; i <= LINES_ROUND; i += 1) {
      lines.iso_u.push(rowOf(grid, Math.round((i * (grid.rows - 1)) / (LINES_ROUND + 1))));
    }
    for (let i = 0; i < LINES_UP; i += 1) {
      lines.iso_v.push(columnOf(grid, Math.round((i * (grid.columns - 1)) / LINES_UP)));
    }
  }
  for (const { at, du, place } of tangents) {
    for (let i = 0; i < at.length; i += 3) {
      const triple = (from: Float64Array): Triple => [from[i] ?? 0, from[i + 1] ?? 0, from[i + 2] ?? 0];
      lines.tangents.push({
        at: new Float32Array(placed(triple(at), place, true)),
        along: new Float32Array(placed(triple(du), place, false)),
      });
    }
  }
  return lines;
}

function boundaries(body: Grid | undefined): Pick<LineArrays, "rim" | "foot"> {
  if (!body) return { rim: null, foot: null };
  const start = rowOf(body, 0);
  const end = rowOf(body, body.rows - 1);
  const [rim, foot] = meanHeight(start) >= meanHeight(end) ? [start, end] : [end, start];
  return { rim, foot };
}

function meanHeight(line: Float32Array): number {
  let sum = 0;
  for (let i = 2; i < line.length; i += 3) sum += line[i] ?? 0;
  return sum / (line.length / 3);
}

/** A point, or a direction, scaled, turned about the unit axis (Rodrigues) and, for points, shifted. */
function placed(point: Triple, place: Placement | undefined, shifted: boolean): Triple {
  if (!place) return point;
  const scale = place.scale ?? [1, 1, 1];
  const [kx, ky, kz] = place.axis ?? [0, 0, 1];
  const shift = shifted ? (place.shift ?? [0, 0, 0]) : [0, 0, 0];
  const cos = Math.cos(place.angle ?? 0);
  const sin = Math.sin(place.angle ?? 0);
  const x = point[0] * scale[0];
  const y = point[1] * scale[1];
  const z = point[2] * scale[2];
  const along = (kx * x + ky * y + kz * z) * (1 - cos);
  return [
    x * cos + (ky * z - kz * y) * sin + kx * along + (shift[0] ?? 0),
    y * cos + (kz * x - kx * z) * sin + ky * along + (shift[1] ?? 0),
    z * cos + (kx * y - ky * x) * sin + kz * along + (shift[2] ?? 0),
  ];
}
