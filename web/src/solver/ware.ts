/**
 * What a potter's glaze goes by, at every place of the wall. It varies slowly, so it is taken on a coarse grid of its own,
 * the same however finely the pot is drawn, and looked up by the parameters (u, v).
 */

import type { GridSize } from "../document/waves";

/** Numbers per sample. */
export const WARE_SIZE = 4;

/** A table of samples of one part: row after row four numbers per column (see {@link ware}). */
export interface Ware {
  readonly texels: Float32Array;
  readonly rows: number;
  readonly columns: number;
}

/** The vertices of a coarse grid, scaled and turned as the part stands. */
export interface WareMesh {
  readonly positions: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
}

const ROWS = 49;
/** Cells round the pot, at least; and in a quarter of a wave. */
const ROUND = 64;
const LEAST_PER_QUARTER = 2;
const LEAST: GridSize = { rows: 8, columns: 25 };
/** A texture may be this large on every machine that draws at all well. */
const LARGEST_SIDE = 4096;
/** All parts together. */
const MOST_SAMPLES = 100_000;

/** The coarse grid of a part among so many. It is the same for about as many, so that one part more leaves the others as they are. */
export function wareGrid(parts: number, waves: number): GridSize {
  const about = 2 ** Math.ceil(Math.log2(Math.max(1, parts)));
  // Whole quarters of a wave, so that crests and troughs are met.
  const quarters = 4 * Math.max(1, Math.round(waves));
  const columns = quarters * Math.max(LEAST_PER_QUARTER, Math.ceil(ROUND / quarters)) + 1;
  const share = Math.min(1, Math.sqrt(MOST_SAMPLES / (ROWS * columns * about)));
  const scaled = (count: number, least: number) => Math.max(least, Math.floor(share * count));
  return {
    rows: scaled(ROWS, LEAST.rows),
    columns: Math.min(scaled(columns, LEAST.columns), LARGEST_SIDE),
  };
}

/** A distance to an edge that there is not. */
const NO_EDGE = 1e9;

/** What a glaze goes by where there is nothing to tell: it is even, far from every edge, and its inner side has as much light as the outer. */
export function evenWare({ rows, columns }: GridSize): Float32Array {
  const texels = new Float32Array(WARE_SIZE * rows * columns);
  for (let at = 0; at < texels.length; at += WARE_SIZE) texels.set([0, NO_EDGE, NO_EDGE, 0], at);
  return texels;
}

/** An end of the profile shorter than this share of the longest ring is a closed one (a pole), not an edge. */
const POLE_SHARE = 0.02;

/**
 * Fills `into` for every vertex, in model units, with four numbers:
 * - the mean curvature beyond that of a plain cylinder of the same girth, positive where the surface bulges outwards (glaze runs thin) and negative in hollows (it pools);
 * - the distance along the profile to the rim;
 * - the distance along the profile to the foot, or the height above the lowest point when the bottom is closed;
 * - the depth below the rim divided by the radius of the mouth: how much of the light of the opening reaches the inside.
 */
export function ware(mesh: WareMesh, grid: GridSize, into: Float32Array): void {
  curvature(mesh, grid, into);
  straighten(mesh.positions, grid, into);
  edges(mesh.positions, grid, into);
}

/** A cell whose sides are this close to one line (by the square of the sine of their angle) has no curvature to speak of. */
const FLAT = 1e-6;

/**
 * Half the divergence of the normals from central differences, with the fundamental forms `I` and `II` of the differences:
 * `(L G - 2 M F + N E) / (2 (E G - F^2))`. Round a closed surface there is no seam; a pole has the mean of the ring beside it;
 * elsewhere it is 0 where the surface is degenerate.
 */
function curvature({ positions: p, normals: n }: WareMesh, { rows, columns }: GridSize, into: Float32Array): void {
  const closed = [0, rows - 1].every((row) => {
    const a = 3 * row * columns;
    const b = a + 3 * (columns - 1);
    return at(p, a) === at(p, b) && at(p, a + 1) === at(p, b + 1) && at(p, a + 2) === at(p, b + 2);
  });
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const vertex = row * columns + column;
      const a = 3 * (row > 0 ? vertex - columns : vertex);
      const b = 3 * (row < rows - 1 ? vertex + columns : vertex);
      const c = 3 * (column > 0 ? vertex - 1 : closed ? vertex + columns - 2 : vertex);
      const d = 3 * (column < columns - 1 ? vertex + 1 : closed ? vertex - columns + 2 : vertex);
      const ux = at(p, b) - at(p, a);
      const uy = at(p, b + 1) - at(p, a + 1);
      const uz = at(p, b + 2) - at(p, a + 2);
      const vx = at(p, d) - at(p, c);
      const vy = at(p, d + 1) - at(p, c + 1);
      const vz = at(p, d + 2) - at(p, c + 2);
      const nux = at(n, b) - at(n, a);
      const nuy = at(n, b + 1) - at(n, a + 1);
      const nuz = at(n, b + 2) - at(n, a + 2);
      const nvx = at(n, d) - at(n, c);
      const nvy = at(n, d + 1) - at(n, c + 1);
      const nvz = at(n, d + 2) - at(n, c + 2);
      const e = ux * ux + uy * uy + uz * uz;
      const f = ux * vx + uy * vy + uz * vz;
      const g = vx * vx + vy * vy + vz * vz;
      const area = e * g - f * f;
      const l = nux * ux + nuy * uy + nuz * uz;
      const m2 = nux * vx + nuy * vy + nuz * vz + nvx * ux + nvy * uy + nvz * uz;
      const nn = nvx * vx + nvy * vy + nvz * vz;
      into[WARE_SIZE * vertex] = area > FLAT * e * g ? (l * g - m2 * f + nn * e) / (2 * area) : 0;
    }
  }
  for (const [end, beside] of [
    [0, 1],
    [rows - 1, rows - 2],
  ] as const) {
    const start = end * columns;
    const middle = start + (columns >> 1);
    if ([0, 1, 2].some((k) => at(p, 3 * start + k) !== at(p, 3 * middle + k))) continue;
    const ring = beside * columns;
    let mean = 0;
    for (let v = ring; v < ring + columns; v++) mean += at(into, WARE_SIZE * v) / columns;
    for (let v = start; v < start + columns; v++) into[WARE_SIZE * v] = mean;
  }
}

/** Rings smaller than this share of the largest are taken as that large: towards a pole the girth goes to nothing. */
const LEAST_GIRTH = 0.2;

/** Takes off the curvature that a row has only because it goes round: a slender neck is no edge. */
function straighten(p: ArrayLike<number>, grid: GridSize, into: Float32Array): void {
  const { rows, columns } = grid;
  const radii = Array.from({ length: rows }, (_, row) => ring(p, row * columns, columns).radius);
  const least = LEAST_GIRTH * radii.reduce((a, b) => Math.max(a, b), 0);
  if (!(least > 0)) return;
  for (const [row, radius] of radii.entries()) {
    const start = row * columns;
    const plain = 0.5 / Math.max(radius, least);
    for (let v = start; v < start + columns; v++) into[WARE_SIZE * v] = at(into, WARE_SIZE * v) - plain;
  }
}

function edges(p: ArrayLike<number>, grid: GridSize, into: Float32Array): void {
  const { rows, columns } = grid;
  const top = ring(p, 0, columns);
  const bottom = ring(p, (rows - 1) * columns, columns);
  const middle = ring(p, (rows >> 1) * columns, columns);
  const rimFirst = top.height >= bottom.height;
  const rim = rimFirst ? top : bottom;
  const longest = Math.max(top.radius, bottom.radius, middle.radius);
  const foot = rimFirst ? bottom : top;
  const open = rim.radius > POLE_SHARE * longest;
  const closedFoot = foot.radius <= POLE_SHARE * longest;
  const lowest = closedFoot ? lowestOf(p, rows * columns) : 0;
  const step = rimFirst ? columns : -columns;
  const start = rimFirst ? 0 : (rows - 1) * columns;
  for (let column = 0; column < columns; column++) {
    let length = 0;
    for (let row = 0, vertex = start + column; row < rows; row++, vertex += step) {
      if (row > 0) {
        const a = 3 * vertex;
        const b = 3 * (vertex - step);
        const [dx, dy, dz] = [at(p, a) - at(p, b), at(p, a + 1) - at(p, b + 1), at(p, a + 2) - at(p, b + 2)];
        // Not Math.hypot, which is ten times slower and only needed for numbers that single precision does not have.
        length += Math.sqrt(dx * dx + dy * dy + dz * dz);
      }
      into[WARE_SIZE * vertex + 1] = open ? length : NO_EDGE;
      into[WARE_SIZE * vertex + 2] = length;
      const depth = rim.height - at(p, 3 * vertex + 2);
      into[WARE_SIZE * vertex + 3] = open ? Math.max(0, depth / rim.radius) : NO_EDGE;
    }
    for (let row = 0, vertex = start + column; row < rows; row++, vertex += step) {
      into[WARE_SIZE * vertex + 2] = closedFoot
        ? at(p, 3 * vertex + 2) - lowest
        : length - at(into, WARE_SIZE * vertex + 2);
    }
  }
}

function lowestOf(p: ArrayLike<number>, end: number): number {
  let lowest = Infinity;
  for (let v = 0; v < end; v++) lowest = Math.min(lowest, at(p, 3 * v + 2));
  return lowest;
}

/** The mean height of a ring of vertices and their mean distance from their middle. */
function ring(p: ArrayLike<number>, first: number, columns: number): { height: number; radius: number } {
  let [x, y, z] = [0, 0, 0];
  for (let v = first; v < first + columns; v++) {
    x += at(p, 3 * v) / columns;
    y += at(p, 3 * v + 1) / columns;
    z += at(p, 3 * v + 2) / columns;
  }
  let radius = 0;
  for (let v = first; v < first + columns; v++) {
    const [dx, dy] = [at(p, 3 * v) - x, at(p, 3 * v + 1) - y];
    radius += Math.sqrt(dx * dx + dy * dy) / columns;
  }
  return { height: z, radius };
}

/** Reads a number that is known to be there. */
function at(values: ArrayLike<number>, index: number): number {
  return values[index] as number;
}
