/** Where a hand is on a line or in a plane of the scene, by where it is seen: exact, the perspective being a ratio of linear functions. */

import type { See, Spot } from "../pull/reach";
import type { Triple } from "../triple";

/** A plane that is seen so much shorter one way than the other, and a line so much shorter than one across, cannot be pointed into. */
const EDGE_ON = 0.12;

/** How far along a direction from a point the place of the line is that is seen nearest to a spot; null where the line is seen end on, or does not come so far. */
export function alongLine(see: See, point: Triple, way: Triple, size: number, spot: Spot): number | null {
  const lines = seen(see, point, [way], size);
  if (!lines) return null;
  const [[x, y, w], [dx, dy, dw]] = lines as [Seen, Seen];
  // The direction in which the line is seen is the same all along it.
  const [ux, uy] = [dx * w - dw * x, dy * w - dw * y];
  const length = Math.hypot(ux, uy);
  if (length / (w * w) < (EDGE_ON / 2) * (across(see, point, size) / size)) return null;
  const target = (spot.x * ux + spot.y * uy) / length;
  // (x + t dx) / (w + t dw) along u is the target.
  const below = (dx * ux + dy * uy) / length - target * dw;
  const t = (target * w - (x * ux + y * uy) / length) / below;
  return Number.isFinite(t) && w + t * dw > 0 ? t : null;
}

/** The two coordinates, along directions from a point, of the place of their plane that is seen at a spot; null where the plane is seen edge on, or does not come so far. */
export function inPlane(
  see: See,
  point: Triple,
  [a, b]: readonly [Triple, Triple],
  size: number,
  spot: Spot,
): readonly [number, number] | null {
  const planes = seen(see, point, [a, b], size);
  if (!planes || isEdgeOn(planes)) return null;
  const [[x, y, w], [ax, ay, aw], [bx, by, bw]] = planes as [Seen, Seen, Seen];
  const [p, q, r, s] = [ax - spot.x * aw, bx - spot.x * bw, ay - spot.y * aw, by - spot.y * bw];
  const [u, v] = [spot.x * w - x, spot.y * w - y];
  const determinant = p * s - q * r;
  const [t1, t2] = [(u * s - q * v) / determinant, (p * v - u * r) / determinant];
  return Number.isFinite(t1) && Number.isFinite(t2) && w + t1 * aw + t2 * bw > 0 ? [t1, t2] : null;
}

/** How many pixels a length of `size` is, across the view at a point. */
export function across(see: See, point: Triple, size: number): number {
  const ways: readonly Triple[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const here = see(point);
  const near = 1e-3;
  const squares = ways.map((way) => {
    const there = see(moved(point, way, near * size));
    return here && there ? ((there.x - here.x) / near) ** 2 + ((there.y - here.y) / near) ** 2 : 0;
  });
  // Of three directions at right angles the squares add up to two of one that is seen across.
  return Math.sqrt(squares.reduce((all, each) => all + each, 0) / 2);
}

/** Before the division: x, y and the depth. */
type Seen = readonly [x: number, y: number, w: number];

/** A point as it is seen, and by how much that changes for each unit of the directions. */
function seen(see: See, point: Triple, ways: readonly Triple[], size: number): readonly Seen[] | null {
  const step = 1e-2 * size;
  const before = (at: Triple): Seen | null => {
    const spot = see(at);
    return spot?.depth === undefined ? null : [spot.x * spot.depth, spot.y * spot.depth, spot.depth];
  };
  const here = before(point);
  if (!here) return null;
  const all: Seen[] = [here];
  for (const way of ways) {
    const there = before(moved(point, way, step));
    if (!there) return null;
    all.push([(there[0] - here[0]) / step, (there[1] - here[1]) / step, (there[2] - here[2]) / step]);
  }
  return all;
}

/** Whether a small square of the plane is seen much flatter than it is wide. */
function isEdgeOn(planes: readonly Seen[]): boolean {
  const [[x, y, w], a, b] = planes as [Seen, Seen, Seen];
  const slope = ([dx, dy, dw]: Seen) => [(dx * w - dw * x) / w ** 2, (dy * w - dw * y) / w ** 2] as const;
  const [[ax, ay], [bx, by]] = [slope(a), slope(b)];
  const [aa, ab, bb] = [ax * ax + ay * ay, ax * bx + ay * by, bx * bx + by * by];
  const gap = Math.hypot(aa - bb, 2 * ab);
  return aa + bb - gap < EDGE_ON ** 2 * (aa + bb + gap);
}

function moved(point: Triple, way: Triple, by: number): Triple {
  return [point[0] + by * way[0], point[1] + by * way[1], point[2] + by * way[2]];
}
