/** What a hand, a file or a photograph shows of a pot, as the lines of a sheet. */

import { evenly, type Spot } from "./knot";
import { MARGIN, SHEET, type Sheet, withSide, withSides } from "./sheet";
import { boxOf, mirrored, type Sides, sidesOf } from "./sides";
import { alike, type Picture, silhouetteOf } from "./silhouette";
import { knotsOf, type Smoothing } from "./stroke";

/** A hand trembles. */
const TREMBLING: Smoothing = 4;

/** Two sides are looked at in points so far apart, and may differ by this beside half of it, on the sheet. */
const GAP = 8;
const SAME = 1.5;

/** An outline in the place of what is drawn; null where it has no height. One that is the same on both sides says so. */
export function withOutline(sheet: Sheet, { right, left, axis }: Sides, smoothing: Smoothing): Sheet | null {
  const knots = (line: readonly Spot[]) => knotsOf(evenly(line, 1), smoothing);
  const [one, other] = [knots(right), left && knots(left)];
  if (one.length < 2) return null;
  const middle = axis ?? sheet.axis;
  const same = other && isSame(one, mirrored(other, middle));
  return withSides(sheet, one, same ? null : other, middle);
}

/** With a line that was drawn by hand: of sides that are their own, the one that it is nearer to. Null where it is too short to be the wall of a pot. */
export function withStroke(sheet: Sheet, line: readonly Spot[]): Sheet | null {
  const sides = sidesOf(line, false, sheet.axis);
  const right = sides && knotsOf(sides.right, TREMBLING);
  if (!sides || !right || right.length < 2) return null;
  if (sheet.left === null) return withSides(sheet, right, null);
  if (sides.left) return withSides(sheet, right, knotsOf(sides.left, TREMBLING));
  const mean = line.reduce((sum, { x }) => sum + x, 0) / line.length;
  return mean < sheet.axis ? withSide(sheet, "left", mirrored(right, sheet.axis)) : withSide(sheet, "right", right);
}

/** The pot on a photograph that begins at this place of the sheet; null where none can be told from what is behind it. */
export function sidesSeen(picture: Picture, { x, y }: Spot, sensitivity: number): Sides | null {
  const seen = silhouetteOf(picture, sensitivity);
  if (!seen) return null;
  const there = (line: readonly Spot[]) => line.map((spot) => ({ x: spot.x + x, y: spot.y + y }));
  const both = alike(seen);
  return { right: there(both ?? seen.right), left: both ? null : there(seen.left), axis: seen.axis + x };
}

/** Lines of radius and height in pairs (to the left of the axis below 0), as large as the sheet allows; none of what has no size. */
export function linesOnSheet(lines: readonly Float64Array[], axis: number): readonly (readonly Spot[])[] {
  const spots = lines.map((pairs) =>
    Array.from({ length: pairs.length >> 1 }, (_, i) => ({ x: pairs[2 * i] ?? 0, y: -(pairs[2 * i + 1] ?? 0) })),
  );
  const { left, right, top, bottom } = boxOf(spots.flat());
  const wide = Math.max(Math.abs(left), Math.abs(right));
  const scale = Math.min((SHEET - 2 * MARGIN) / (bottom - top), (SHEET / 2 - MARGIN / 2) / wide);
  if (!Number.isFinite(scale)) return [];
  const middle = (SHEET - scale * (top + bottom)) / 2;
  return spots.map((line) => line.map(({ x, y }) => ({ x: axis + scale * x, y: middle + scale * y })));
}

/** Whether two sides go the same way, as far as their points say. */
function isSame(one: readonly Spot[], other: readonly Spot[]): boolean {
  const [a, b] = [evenly(one, GAP), evenly(other, GAP)];
  if (Math.abs(a.length - b.length) > 1) return false;
  const count = Math.min(a.length, b.length);
  const at = (line: readonly Spot[], i: number) => line[Math.round((i * (line.length - 1)) / (count - 1))] as Spot;
  return Array.from({ length: count }, (_, i) => i).every((i) => {
    const [p, q] = [at(a, i), at(b, i)];
    return Math.hypot(p.x - q.x, p.y - q.y) < GAP / 2 + SAME;
  });
}
