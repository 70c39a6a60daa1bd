/** What one part is like, read off its vertices: the outline from foot to rim, petals and waves. */

/** The vertices of one part as a grid, row by row from `u = 0` to `u = 1`. */
export interface Grid {
  readonly positions: Float32Array | Float64Array;
  readonly rows: number;
  readonly columns: number;
}

/** One part, scaled and turned as it stands but not moved. */
export interface Body {
  readonly rim: Level;
  /** Where it reaches out furthest, petals included. */
  readonly widest: Level;
  /** How many times the outline swings out, and where. */
  readonly petals: number;
  readonly petalsAt: "rim" | "foot";
  /** How many times the rim rises. */
  readonly waves: number;
  /** Height and mean radius of the rings, from the foot to the rim. */
  readonly outline: readonly (readonly [number, number])[];
}

/** A ring, its mean height and mean radius. */
export interface Level {
  readonly height: number;
  readonly radius: number;
}

/** A ripple smaller than this share of the mean radius (or of the height) is not spoken of. */
const VISIBLE = 0.015;

interface Ring extends Level {
  readonly radii: readonly number[];
  readonly heights: readonly number[];
  /** How far it swings out. */
  readonly reach: number;
}

/**
 * Reads a part off its grid. Petals and waves are counted on `edges`, its rim and foot sampled finely enough for every wave; none are where there is no
 * such grid, because there are too many.
 */
export function bodyOf(grid: Grid, edges: Grid | null = grid): Body | null {
  if (grid.rows < 2 || grid.columns < 3) return null;
  const rings = Array.from({ length: grid.rows }, (_, row) => ringOf(grid, row));
  const start = rings[0];
  const end = rings[rings.length - 1];
  if (!start || !end) return null;
  const rim = start.height >= end.height ? start : end;
  // Where it reaches out furthest, petals included: that is where it is as wide as is said.
  const widest = rings.reduce((best, ring) => (ring.reach > best.reach * 1.0005 ? ring : best), rim);
  const height = heightOf(grid);
  const ends = edges && [ringOf(edges, 0), ringOf(edges, edges.rows - 1)];
  const [atRim, atFoot] = rim === start ? (ends ?? []) : (ends?.toReversed() ?? []);
  const rimPetals = atRim ? peaks(atRim.radii, VISIBLE * atRim.radius) : 0;
  const footPetals = atFoot ? peaks(atFoot.radii, VISIBLE * atFoot.radius) : 0;
  return {
    rim: levelOf(rim),
    widest: levelOf(widest),
    petals: rimPetals > 1 ? rimPetals : footPetals,
    petalsAt: rimPetals > 1 || footPetals <= 1 ? "rim" : "foot",
    waves: atRim ? peaks(atRim.heights, VISIBLE * height) : 0,
    outline: (rim === end ? rings : rings.toReversed()).map((ring) => [ring.height, ring.radius] as const),
  };
}

function levelOf({ height, radius }: Ring): Level {
  return { height, radius };
}

function heightOf({ positions, rows, columns }: Grid): number {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 2; i < 3 * rows * columns; i += 3) {
    low = Math.min(low, positions[i] ?? 0);
    high = Math.max(high, positions[i] ?? 0);
  }
  return high - low;
}

function ringOf(grid: Grid, row: number): Ring {
  const { positions, columns } = grid;
  const count = columns - 1;
  const at = (column: number, axis: number) => positions[3 * (row * columns + column) + axis] ?? 0;
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

/** Whether the wall closes round the axis. */
export function isClosed(grid: Grid): boolean {
  const { positions, rows, columns } = grid;
  for (let row = 0; row < rows; row += Math.max(1, rows - 1)) {
    const a = 3 * row * columns;
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
