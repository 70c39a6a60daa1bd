/** What is shown of the inside of a blend: surfaces on which one of its parameters stays the same, whole or as what is left of the solid beyond three cuts. */

import type { Blend, Pair, Triple } from "../types";
import { isClosed } from "./section";

export const SHOWN = ["cut", "surfaces", "joined"] as const;
export type Shown = (typeof SHOWN)[number];

export const INSIDE_MAPS = ["residual", "jacobian"] as const;
export type InsideMap = (typeof INSIDE_MAPS)[number];

export interface Look {
  readonly shown: Shown;
  readonly map: InsideMap;
  /** Where the surfaces are, along `u`, `v` and `w`, each from 0 to 1. */
  readonly at: Triple;
}

/** Half is cut away along `v`, before the eye: one sees into it. */
export const USUAL: Look = { shown: "cut", map: "jacobian", at: [1, 0.5, 1] };

/** Points of triples (u, v, w), three numbers each, and triangles between them. */
export interface Sheets {
  readonly at: Float64Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

/** Surfaces within a blend, and what is told of its inside. */
export interface SeenInside {
  /** xyz triples in model units, before placement. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** One number for each, NaN where there is none: on the border of a disc over a square. */
  readonly values: Float32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
  /** Of those that there are. */
  readonly least: number;
  readonly greatest: number;
  /** The range that the colours stand for. */
  readonly low: number;
  readonly high: number;
  /** Of the whole inside, by samples: the largest residual or the least Jacobian, and where. */
  readonly worst: number;
  readonly worstAt: Triple;
  readonly folded: boolean;
  /** Of residuals: whether the equation holds wherever it was looked at, but for rounding. */
  readonly holds: boolean;
}

/** Cells along each side of a sheet; round a solid it takes more. */
const CELLS = 36;
const ROUND = 96;

/** Whether `v` goes round the solid. */
export function isRound({ start, end }: Blend): boolean {
  return isClosed(start.form) && isClosed(end.form);
}

/** How far the solids that a blend joins are shown beyond its sections, in parts of their tangents there: a flare is straight so far. */
const BEYOND = 0.15;

/** The same of the solids that a blend joins: prisms and cylinders, tapered as its tangents say. */
export interface Beyond {
  /** Points (u, v, w) of a section, and how far along its tangent each point of the solid is: below 0 before the blend begins. */
  readonly at: Float64Array<ArrayBuffer>;
  readonly along: Float64Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

/** The sides of both solids, and where each ends. */
export function beyondOf(blend: Blend): Beyond {
  const round = isRound(blend);
  const [places, along, indices]: [number[], number[], number[]] = [[], [], []];
  const sides: readonly Pair[] = round
    ? [[0, 1]]
    : [
        [0, 0],
        [0, 1],
        [1, 0],
        [1, 1],
      ];
  const ranges: Ranges = [
    [0, 1],
    [0, 1],
    [0, 1],
  ];
  for (const [w, far] of [
    [0, -BEYOND],
    [1, BEYOND],
  ] as const) {
    const add = (axis: 0 | 1 | 2, held: number) => {
      const first = places.length;
      grid(axis, held, ranges, round, places, indices);
      for (let place = first; place < places.length; place += 3) {
        along.push(axis === 2 ? far : (places[place + 2] ?? 0) * far);
        places[place + 2] = w;
      }
    };
    for (const [axis, held] of sides) add(axis as 0 | 1, held);
    add(2, w);
  }
  return { at: Float64Array.from(places), along: Float64Array.from(along), indices: Uint32Array.from(indices) };
}

/** What is left of each parameter by a cut: from 0 to it, but along `v` what is behind it, as the page looks at a pot. */
export function leftOf({ start }: Blend, at: Triple): readonly [Pair, Pair, Pair] {
  return [[0, at[0]], start.form === "rectangle" ? [0, at[1]] : [at[1], 1], [0, at[2]]];
}

/** Where a cut along each parameter takes nothing away. */
export function uncut(blend: Blend): Triple {
  return [1, leftOf(blend, [1, 0, 1])[1][1] === 1 ? 0 : 1, 1];
}

/**
 * Surfaces where one parameter is held. Of a cut: all sides of what is left. A side that is a line, as the middle of a round solid is, is none; and what is left
 * of a round one that is not cut along `v` has no sides there.
 */
export function sheetsOf(blend: Blend, { shown, at }: Look): Sheets {
  const round = isRound(blend);
  const places: number[] = [];
  const indices: number[] = [];
  const whole: Ranges = [
    [0, 1],
    [0, 1],
    [0, 1],
  ];
  const left = shown === "joined" ? whole : leftOf(blend, at);
  const add = (axis: 0 | 1 | 2, held: number) =>
    grid(axis, held, shown === "surfaces" ? whole : left, round, places, indices);
  for (const axis of [0, 1, 2] as const) {
    const [from, to] = left[axis];
    if (shown === "surfaces") add(axis, at[axis]);
    else if (axis === 0 && round) add(axis, to);
    else if (!(axis === 1 && round && to - from >= 1)) {
      add(axis, from);
      if (to > from) add(axis, to);
    }
  }
  return { at: Float64Array.from(places), indices: Uint32Array.from(indices) };
}

/** From where to where along each parameter. */
type Ranges = readonly [Pair, Pair, Pair];

/** A sheet over ranges of the other two parameters: the last of them stays the same along a row, which the solver takes at once. */
function grid(axis: number, held: number, ranges: Ranges, round: boolean, places: number[], indices: number[]): void {
  const [across, along] = ([0, 1, 2] as const).filter((each) => each !== axis) as [0 | 1, 1 | 2];
  const [v0, v1] = ranges[1];
  const cellsOf = (each: number) => (each === 1 && round ? Math.max(2, Math.ceil(ROUND * (v1 - v0))) : CELLS);
  const within = ([from, to]: Pair, share: number) => from + (to - from) * share;
  const [columns, rows] = [cellsOf(across), cellsOf(along)];
  const first = places.length / 3;
  for (let row = 0; row <= rows; row += 1) {
    for (let column = 0; column <= columns; column += 1) {
      const point: [number, number, number] = [held, held, held];
      point[across] = within(ranges[across], column / columns);
      point[along] = within(ranges[along], row / rows);
      places.push(...point);
      if (row === rows || column === columns) continue;
      const [a, b] = [first + row * (columns + 1) + column, first + (row + 1) * (columns + 1) + column];
      indices.push(a, a + 1, b + 1, a, b + 1, b);
    }
  }
}
