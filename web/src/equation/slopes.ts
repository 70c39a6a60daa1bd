/**
 * The slopes of a mode of order 4 at its rings and free ends, which are not given: at a smooth ring they are such that `q''` is continuous, at a sharp one and at a free end `q''` is 0. One system with three diagonals for
 * what lies between two corners, as the solver has it.
 */

import { type Bending, bending } from "./fundamental";
import { polynomialAt } from "./particular";
import type { Roots } from "./roots";

export interface Beam {
  readonly roots: Roots & { readonly order: 4 };
  readonly equation: readonly [b: number, c: number];
  /** The ends and the rings between them, in ascending order, with the value at each. */
  readonly places: readonly number[];
  readonly values: readonly number[];
  /** Whether there is a corner; never at the ends. */
  readonly corners: readonly boolean[];
  /** Slopes at the ends, null where an end is free. */
  readonly ends: readonly [start: number | null, end: number | null];
  /** A solution under the force. */
  readonly particular: readonly number[];
}

/** For each stretch between two neighbours the slopes at its ends. */
export function slopesOf(beam: Beam): (readonly [number, number])[] {
  const { places, values, corners, particular } = beam;
  const last = places.length - 1;
  const forced = places.map((u) => polynomialAt(particular, u));
  // What is left when the solution under the force is taken away.
  const rest = values.map((value, index) => value - (forced[index]?.[0] ?? 0));
  const bays = places.slice(1).map((to, index) => bending(beam.roots, beam.equation, to - (places[index] ?? 0)));
  const found: [number, number][] = bays.map(() => [0, 0]);
  let first = 0;
  for (let index = 1; index <= last; index += 1) {
    if (index < last && !corners[index]) continue;
    const given = (end: number): number | null => {
      const slope = end === 0 ? beam.ends[0] : end === last ? beam.ends[1] : null;
      return slope === null ? null : slope - (forced[end]?.[1] ?? 0);
    };
    const slopes = stretch(bays.slice(first, index), rest.slice(first, index + 1), [
      [given(first), forced[first]?.[2] ?? 0],
      [given(index), forced[index]?.[2] ?? 0],
    ]);
    for (let bay = first; bay < index; bay += 1) {
      found[bay] = [slopes[bay - first] ?? Number.NaN, slopes[bay - first + 1] ?? Number.NaN];
    }
    first = index;
  }
  return found.map(([near, far], bay) => [near + (forced[bay]?.[1] ?? 0), far + (forced[bay + 1]?.[1] ?? 0)]);
}

/** One smooth stretch from a corner or an end to the next: at each the slope that is given, or what bends it already. */
function stretch(
  bays: readonly Bending[],
  rest: readonly number[],
  ends: readonly [readonly [slope: number | null, bent: number], readonly [slope: number | null, bent: number]],
): number[] {
  const rows = rest.map((_, index): [number, number, number, number] => {
    const [before, after] = [bays[index - 1], bays[index]];
    const end = index === 0 ? ends[0] : index === rest.length - 1 ? ends[1] : null;
    if (end && end[0] !== null) return [0, 1, 0, end[0]];
    const [here, left, right] = [rest[index] ?? 0, rest[index - 1] ?? 0, rest[index + 1] ?? 0];
    const row: [number, number, number, number] = [0, 0, 0, 0];
    // `q''` at the far end of what is before; slopes turn their sign with the direction.
    if (before) {
      row[0] += before.slope[1];
      row[1] -= before.slope[0];
      row[3] -= left * before.value[1] + here * before.value[0];
    }
    // Minus `q''` at the near end of what is after.
    if (after) {
      row[1] -= after.slope[0];
      row[2] += after.slope[1];
      row[3] += here * after.value[0] + right * after.value[1];
    }
    if (end) row[3] += index === 0 ? end[1] : -end[1];
    return row;
  });
  for (let index = 1; index < rows.length; index += 1) {
    const [above, row] = [rows[index - 1], rows[index]];
    if (!above || !row) continue;
    const factor = row[0] / above[1];
    row[1] -= factor * above[2];
    row[3] -= factor * above[3];
  }
  const slopes: number[] = [];
  for (let index = rows.length - 1; index >= 0; index -= 1) {
    const row = rows[index];
    if (row) slopes[index] = (row[3] - row[2] * (slopes[index + 1] ?? 0)) / row[1];
  }
  return slopes;
}
