/** How high and how wide what is drawn is: the numbers that caption, dimension lines and measures share. */

/** The pot between two upright planes square to a horizontal direction. */
export interface Span {
  /** In degrees from the x axis. */
  readonly direction: number;
  /** Where the first plane is along the direction. */
  readonly low: number;
  readonly width: number;
}

export interface Extents {
  readonly bottom: number;
  readonly height: number;
  readonly greatest: Span;
  readonly least: Span;
}

/** The largest there is of height and width; 0 where there is nothing. */
export function sizeOf(extents: Pick<Extents, "height" | "greatest"> | null): number {
  return extents ? Math.max(extents.height, extents.greatest.width) : 0;
}

/** Directions in which the farthest points are sought; the widths are then those between all of these points. */
const DIRECTIONS = 128;

/** Widths that differ by less have no direction worth drawing: what is round is drawn with corners. */
const ROUND = 1e-3;

/** The farthest of some points: all that extents go by. */
export interface Farthest {
  readonly bottom: number;
  readonly top: number;
  /** The one that is farthest in each of the directions, `x, y` after `x, y`, and how far that is. */
  readonly corners: Float64Array;
  readonly far: Float64Array;
}

/** Extents of points (xyz); null where there is none. */
export function extentsOf(positions: ArrayLike<number>): Extents | null {
  return extentsTogether([farthestOf(positions)]);
}

/** The farthest of points (xyz). */
export function farthestOf(positions: ArrayLike<number>): Farthest {
  let [bottom, top] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 2; i < positions.length; i += 3) {
    const z = positions[i] as number;
    if (z < bottom) bottom = z;
    if (z > top) top = z;
  }
  const corners = new Float64Array(2 * DIRECTIONS);
  const far = new Float64Array(DIRECTIONS).fill(Number.NEGATIVE_INFINITY);
  for (let k = 0; k < DIRECTIONS; k += 1) {
    const angle = (2 * Math.PI * k) / DIRECTIONS;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y] = [positions[i] as number, positions[i + 1] as number];
      const along = c * x + s * y;
      if (along > (far[k] as number)) {
        far[k] = along;
        corners[2 * k] = x;
        corners[2 * k + 1] = y;
      }
    }
  }
  return { bottom, top, corners, far };
}

/** Extents of several sets of points, of which the farthest are known: what has not moved is not looked through again. */
export function extentsTogether(sets: readonly Farthest[]): Extents | null {
  let [bottom, top] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const set of sets) {
    if (set.bottom < bottom) bottom = set.bottom;
    if (set.top > top) top = set.top;
  }
  if (!(top >= bottom)) return null;
  const corners = cornersOf(sets);
  let greatest: Span = { direction: 0, low: 0, width: -1 };
  let least: Span = { direction: 0, low: 0, width: Number.POSITIVE_INFINITY };
  const consider = (dx: number, dy: number) => {
    if (dx === 0 && dy === 0) return;
    const along = spanAlong(corners, Math.atan2(dy, dx));
    if (along.width > greatest.width) greatest = along;
    const across = spanAlong(corners, Math.atan2(dx, -dy));
    if (across.width < least.width) least = across;
  };
  consider(1, 0);
  consider(0, 1);
  // The widest place is between two corners, and the narrowest is square to a side.
  const farthest = farthestPair(corners);
  if (farthest) consider(farthest[0], farthest[1]);
  corners.forEach(([x, y], index) => {
    const next = corners[(index + 1) % corners.length];
    if (next) consider(next[0] - x, next[1] - y);
  });
  return { bottom, height: top - bottom, greatest, least };
}

/** Whether the widths are the same all round, as far as anyone can see. */
export function isRound({ greatest, least }: Extents): boolean {
  return greatest.width - least.width <= ROUND * greatest.width;
}

type Corner = readonly [x: number, y: number];

/** The points that are farthest in one of the directions, in the order of these: an outline as seen from above, without its hollows. */
function cornersOf(sets: readonly Farthest[]): readonly Corner[] {
  const corners: Corner[] = [];
  for (let k = 0; k < DIRECTIONS; k += 1) {
    let best = sets[0];
    for (const set of sets) if ((set.far[k] as number) > (best?.far[k] as number)) best = set;
    const corner: Corner = [best?.corners[2 * k] ?? 0, best?.corners[2 * k + 1] ?? 0];
    const before = corners.at(-1);
    if (!before || before[0] !== corner[0] || before[1] !== corner[1]) corners.push(corner);
  }
  return corners;
}

function farthestPair(corners: readonly Corner[]): Corner | null {
  let best: Corner | null = null;
  for (const [x, y] of corners) {
    for (const [p, q] of corners) if (!best || Math.hypot(p - x, q - y) > Math.hypot(...best)) best = [p - x, q - y];
  }
  return best;
}

/** A direction and its opposite are one: it is told from 0 to less than 180 degrees. */
function spanAlong(corners: readonly Corner[], angle: number): Span {
  const half = ((angle % Math.PI) + Math.PI) % Math.PI;
  const [c, s] = [Math.cos(half), Math.sin(half)];
  const along = corners.map(([x, y]) => c * x + s * y);
  const low = Math.min(...along);
  return { direction: (half * 180) / Math.PI, low, width: Math.max(...along) - low };
}
