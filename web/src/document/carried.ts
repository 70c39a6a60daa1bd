/**
 * What was made of a part goes along where the part is only moved, or turned about the vertical: a wall goes by its surface, and by which way is up. So do its foot ring and its drain. What is scaled, tilted, or of another shape is
 * made anew.
 */

import { IDENTITY, type Matrix, matrixOf, UNMOVED } from "./placement";
import type { Part } from "./types";

/** What leans by less than this has turned about the vertical: digits of rounding. */
const LEANS = 1e-9;

/** For each part the motion that brings what was made of it to where it stands now; null where there is none. Walls are not looked at. */
export function motionsBetween(before: readonly Part[], now: readonly Part[]): readonly (Matrix | null)[] {
  return now.map((part, place) => (before.length === now.length ? motionOf(before[place], part) : null));
}

/** Whether all that was made of these parts only has to be moved for those. */
export function areCarried(before: readonly Part[], now: readonly Part[]): boolean {
  return (
    before.length === now.length &&
    now.every((part, place) => part.wall === before[place]?.wall && motionOf(before[place], part) !== null)
  );
}

/** Whether all walls stand as they were made. */
export function areUntouched(before: readonly Part[], now: readonly Part[]): boolean {
  const motions = motionsBetween(before, now);
  return (
    before.length === now.length &&
    now.every(({ wall }, place) => wall === before[place]?.wall && (!wall || motions[place] === IDENTITY))
  );
}

/** The walled parts of which something else was made than is wanted now, by their places; the walls of all others only have to be moved. */
export function changedBetween(before: readonly Part[], now: readonly Part[]): readonly number[] {
  const motions = motionsBetween(before, now);
  return [...now.keys()].filter(
    (place) => now[place]?.wall && (motions[place] === null || now[place]?.wall !== before[place]?.wall),
  );
}

function motionOf(before: Part | undefined, now: Part): Matrix | null {
  if (before?.shape !== now.shape) return null;
  if (before.place === now.place) return IDENTITY;
  const [from, to] = [
    { ...UNMOVED, ...before.place },
    { ...UNMOVED, ...now.place },
  ];
  if (!to.scale.every((factor, axis) => factor === from.scale[axis])) return null;
  const [a, b] = [matrixOf({ axis: from.axis, angle: from.angle }), matrixOf({ axis: to.axis, angle: to.angle })];
  if (!a || !b) return null;
  const number = (m: Matrix, row: number, column: number) => m[4 * column + row] as number;
  // The turn back is the transpose.
  const turned = (row: number, column: number) =>
    [0, 1, 2].reduce((sum, each) => sum + number(b, row, each) * number(a, column, each), 0);
  const still = a.every((value, i) => value === b[i]);
  const turn = [0, 1, 2].map((row) =>
    [0, 1, 2].map((column) => (still ? Number(row === column) : turned(row, column))),
  );
  const of = (row: number, column: number) => turn[row]?.[column] ?? Number.NaN;
  if (!(Math.hypot(of(0, 2), of(1, 2)) < LEANS && of(2, 2) > 0)) return null;
  const [x, y, z] = from.shift;
  const shift = [0, 1, 2].map((row) => (to.shift[row] as number) - (of(row, 0) * x + of(row, 1) * y + of(row, 2) * z));
  if (!shift.every(Number.isFinite)) return null;
  return [
    of(0, 0),
    of(1, 0),
    of(2, 0),
    0,
    of(0, 1),
    of(1, 1),
    of(2, 1),
    0,
    of(0, 2),
    of(1, 2),
    of(2, 2),
    0,
    ...shift,
    1,
  ];
}
