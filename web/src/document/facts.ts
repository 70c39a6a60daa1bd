/** What there is to say of a shape to someone who cannot see it. */

import { type Extents, extentsOf } from "./extents";
import type { Triple } from "./types";

/** The vertices of one part as a grid, row by row from `u = 0` to `u = 1`. */
export interface Grid {
  readonly positions: Float32Array;
  /** Index of the part's first vertex. */
  readonly first: number;
  readonly rows: number;
  readonly columns: number;
}

/** What a description is made of; lengths in model units. */
export interface Facts {
  readonly parts: number;
  readonly height: number;
  /** Along x and y. */
  readonly width: number;
  readonly depth: number;
  /** In every direction. */
  readonly extents: Extents;
  /** Height of the widest place, 0 at the bottom, 1 at the top. */
  readonly widestAt: number;
  /** Width of the mouth as a share of the widest width. */
  readonly mouth: number;
  /** How many times the outline swings out, and where. */
  readonly petals: number;
  readonly petalsAt: "rim" | "foot";
  /** How many times the rim rises. */
  readonly waves: number;
  readonly closed: boolean;
  /** Height and mean radius of the rings of the first part, from the foot to the rim. */
  readonly outline: readonly (readonly [number, number])[];
}

/** A ripple smaller than this share of the mean radius (or of the height) is not spoken of. */
const VISIBLE = 0.015;

interface Ring {
  readonly radii: readonly number[];
  readonly heights: readonly number[];
  readonly radius: number;
  /** How far it swings out. */
  readonly reach: number;
  readonly height: number;
}

/** The box that a placed mesh fills. */
export interface Box {
  readonly min: Triple;
  readonly max: Triple;
}

/**
 * Measures the placed mesh, whose vertices are `positions`. `grids` has at least one part; the outline is read from the first. Petals and waves are
 * counted on `edges`, the first part's rim and foot sampled finely enough for every wave; none are where there is no such grid, because there are too many.
 */
export function facts(
  grids: readonly Grid[],
  { min: low, max: high }: Box,
  positions: Float32Array,
  edges: Grid | null = grids[0] ?? null,
): Facts | null {
  const body = grids[0];
  const extents = extentsOf(positions);
  if (!extents || !body || body.rows < 2 || body.columns < 3) return null;
  const rings = Array.from({ length: body.rows }, (_, row) => ringOf(body, row));
  const start = rings[0];
  const end = rings[rings.length - 1];
  if (!start || !end) return null;
  const rim = start.height >= end.height ? start : end;
  // Where it reaches out furthest, petals included: that is where it is as wide as is said.
  const widest = rings.reduce((best, ring) => (ring.reach > best.reach * 1.0005 ? ring : best), rim);
  const height = high[2] - low[2];
  const ends = edges && [ringOf(edges, 0), ringOf(edges, edges.rows - 1)];
  const [atRim, atFoot] = rim === start ? (ends ?? []) : (ends?.toReversed() ?? []);
  const rimPetals = atRim ? peaks(atRim.radii, VISIBLE * atRim.radius) : 0;
  const footPetals = atFoot ? peaks(atFoot.radii, VISIBLE * atFoot.radius) : 0;
  return {
    parts: grids.length,
    height,
    width: high[0] - low[0],
    depth: high[1] - low[1],
    extents,
    widestAt: height > 0 ? (widest.height - low[2]) / height : 0,
    mouth: widest.radius > 0 ? rim.radius / widest.radius : 0,
    petals: rimPetals > 1 ? rimPetals : footPetals,
    petalsAt: rimPetals > 1 || footPetals <= 1 ? "rim" : "foot",
    waves: atRim ? peaks(atRim.heights, VISIBLE * height) : 0,
    closed: grids.every(isClosed),
    outline: (rim === end ? rings : rings.toReversed()).map((ring) => [ring.height, ring.radius] as const),
  };
}

function ringOf(grid: Grid, row: number): Ring {
  const { positions, first, columns } = grid;
  const count = columns - 1;
  const at = (column: number, axis: number) => positions[3 * (first + row * columns + column) + axis] ?? 0;
  let x = 0;
  let y = 0;
  let height = 0;
  for (let column = 0; column < count; column += 1) {
    x += at(column, 0) / count;
    y += at(column, 1) / count;
    height += at(column, 2) / count;
  }
  const radii: number[] = [];
  const heights: number[] = [];
  let radius = 0;
  for (let column = 0; column < count; column += 1) {
    const [dx, dy] = [at(column, 0) - x, at(column, 1) - y];
    const r = Math.sqrt(dx * dx + dy * dy);
    radii.push(r);
    heights.push(at(column, 2));
    radius += r / count;
  }
  return { radii, heights, radius, reach: Math.max(...radii), height };
}

/** How many hills a closed line of values has that rise at least `visible` above the valleys beside them. */
function peaks(values: readonly number[], visible: number): number {
  const lowest = values.reduce((best, value, i) => (value < (values[best] ?? 0) ? i : best), 0);
  let count = 0;
  let valley = values[lowest] ?? 0;
  let hill = valley;
  let climbing = true;
  for (let i = 1; i <= values.length; i += 1) {
    const value = values[(lowest + i) % values.length] ?? 0;
    if (climbing) {
      if (value > hill) hill = value;
      if (value < valley) valley = value;
      if (hill - valley > visible && hill - value > visible / 2) {
        count += 1;
        climbing = false;
        valley = value;
      }
    } else {
      if (value < valley) valley = value;
      if (value - valley > visible / 2) {
        climbing = true;
        hill = value;
      }
    }
  }
  return count;
}

function isClosed(grid: Grid): boolean {
  const { positions, first, rows, columns } = grid;
  for (let row = 0; row < rows; row += Math.max(1, rows - 1)) {
    const a = 3 * (first + row * columns);
    const b = a + 3 * (columns - 1);
    for (let axis = 0; axis < 3; axis += 1) {
      const size = Math.max(
        1e-12,
        Math.abs(positions[a] ?? 0),
        Math.abs(positions[a + 1] ?? 0),
        Math.abs(positions[a + 2] ?? 0),
      );
      if (Math.abs((positions[a + axis] ?? 0) - (positions[b + axis] ?? 0)) > 1e-4 * size) return false;
    }
  }
  return true;
}
