/**
 * What a pot holds is kept while a hand moves, frame by frame, by an estimate that takes no measuring: as much as is within a wall that is as thick as it should be along the normal of its profile, above the
 * base and below the lowest point of the rim.
 *
 * The surface is linear in the rings that make up for it, so that it is read twice, and for any factor it is known from then on.
 */

import { evaluate } from "pasu";
import type { MakingUp } from "../document/locks";
import type { Rings, Sent, SentShape, Wall } from "../document/types";
import { factorFor, madeUp } from "./making-up";

/** How far the estimate may be from what it was, as a part of it: far less than it is off. */
const WITHIN = 1e-6;

const ROWS = 24;
const COLUMNS = 16;

/** The same pot where it held as much before, as far as is known without measuring; `after` itself where no ring that is free makes up for it. */
export function heldMeanwhile(before: Rings, after: Rings, wall: Wall, up: MakingUp): Rings {
  if (up.rings.length === 0) return after;
  const goal = roomIn(pointsOf(before), wall);
  const [one, two] = [pointsOf(after), pointsOf(madeUp(after, up, 2))];
  const points = new Float64Array(one.length);
  const factor = factorFor(up.along, WITHIN, (factor) => {
    for (let i = 0; i < points.length; i += 1) {
      const at = one[i] as number;
      points[i] = at + (factor - 1) * ((two[i] as number) - at);
    }
    const room = roomIn(points, wall);
    return goal > 0 && room > 0 ? room / goal - 1 : null;
  });
  return factor === null || factor === 1 ? after : madeUp(after, up, factor);
}

/** Of rows from the foot to the rim, each round the axis. */
function pointsOf(shape: Rings): Float64Array {
  const places: number[] = [];
  for (let row = 0; row <= ROWS; row += 1)
    for (let column = 0; column < COLUMNS; column += 1) places.push(row / ROWS, (2 * Math.PI * column) / COLUMNS);
  const design: Sent = { pasu: 1, parts: [{ shape: shape as SentShape }] };
  return evaluate(design, 0, places);
}

function roomIn(points: Float64Array, { thickness, base, side }: Wall): number {
  const inset = side === "outside" ? 0 : thickness;
  const height = (column: number, row: number) => points[3 * (row * COLUMNS + column) + 2] as number;
  const radius = (column: number, row: number) => {
    const i = 3 * (row * COLUMNS + column);
    return Math.hypot(points[i] as number, points[i + 1] as number);
  };
  const columns = Array.from({ length: COLUMNS }, (_, column) => column);
  const floor = columns.reduce((sum, column) => sum + height(column, 0), 0) / COLUMNS + base;
  const brim = columns.reduce((least, column) => Math.min(least, height(column, ROWS)), Number.POSITIVE_INFINITY);
  let room = 0;
  for (const column of columns) {
    let [reach, level] = [0, 0];
    for (let row = 0; row <= ROWS; row += 1) {
      const [before, behind] = [Math.max(0, row - 1), Math.min(ROWS, row + 1)];
      const [out, up] = [
        radius(column, behind) - radius(column, before),
        height(column, behind) - height(column, before),
      ];
      const length = Math.hypot(out, up);
      const [in_, on] = length > 0 ? [(inset * up) / length, (inset * out) / length] : [0, 0];
      const [r, z] = [
        Math.max(0, radius(column, row) - in_),
        Math.min(brim, Math.max(floor, height(column, row) + on)),
      ];
      // A frustum of a cone, of which a column is its share.
      if (row > 0) room += ((z - level) * (r * r + r * reach + reach * reach) * Math.PI) / (3 * COLUMNS);
      [reach, level] = [r, z];
    }
  }
  return room;
}
