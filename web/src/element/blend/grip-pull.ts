/** How far a grip is to go so that it stays under the hand. */

import type { Triple } from "../../document/types";
import type { See, Spot } from "../../render/pull/reach";

/** A way that is seen end on by so much, in pixels for each unit of the others, cannot be pulled along. */
const LEAST = 1e-3;

/** By how much each number is to grow: the least change for which the grip is seen as near as it can be to where it was and `by` further. */
export function followed(see: See, at: Triple, along: readonly Triple[], by: Spot): readonly number[] {
  const here = see(at);
  if (!here) return along.map(() => 0);
  const size = Math.max(...along.map((way) => Math.hypot(...way)), Number.MIN_VALUE);
  const seen = along.map((way) => {
    const there = see([at[0] + way[0], at[1] + way[1], at[2] + way[2]]);
    return there ? { x: there.x - here.x, y: there.y - here.y } : { x: 0, y: 0 };
  });
  const [a, b] = seen;
  if (!a) return [];
  const least = (LEAST * size) ** 2;
  const alone = (way: Spot) => {
    const squared = way.x ** 2 + way.y ** 2;
    return squared > least ? (by.x * way.x + by.y * way.y) / squared : 0;
  };
  if (!b) return [alone(a)];
  const determinant = a.x * b.y - a.y * b.x;
  const scale = Math.hypot(a.x, a.y) * Math.hypot(b.x, b.y);
  // Both are seen in one line: the one that is seen longer goes.
  if (Math.abs(determinant) < 0.05 * scale || scale === 0) {
    return Math.hypot(a.x, a.y) > Math.hypot(b.x, b.y) ? [alone(a), 0] : [0, alone(b)];
  }
  return [(by.x * b.y - by.y * b.x) / determinant, (a.x * by.y - a.y * by.x) / determinant];
}
