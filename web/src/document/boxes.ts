/** What is read of the boxes that parts fill, and lengths beside them that are round. */

import { type Box, boxOf } from "./box";
import type { Triple } from "./types";

/** What boxes fill together; null where there is none. */
export function boxAround(boxes: readonly Box[]): Box | null {
  return boxOf(boxes.flatMap(({ min, max }) => [...min, ...max]));
}

export function middleOf({ min, max }: Box): Triple {
  return [0, 1, 2].map((i) => ((min[i] as number) + (max[i] as number)) / 2) as unknown as Triple;
}

/** The longest of its edges. */
export function longestOf({ min, max }: Box): number {
  return Math.max(...max.map((high, i) => high - (min[i] as number)));
}

/** A point with as many digits as a hand has beside something so large: where a round pot stands is not known from its corners to the last one. */
export function handy(point: Triple, size: number): Triple {
  return point.map((x) => roundTo(x, 10 ** Math.floor(Math.log10(size || 1) - 3))) as unknown as Triple;
}

/** The multiple of a step that is nearest. */
export function roundTo(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toPrecision(12)) + 0;
}

/** 1, 2 or 5 times a power of ten: not more than a length. */
export function roundStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  const digit = [5, 2].find((each) => each * power <= length * (1 + 1e-9)) ?? 1;
  return Number((digit * power).toPrecision(3));
}

/** Where the table is for some parts: under all that stand about them, and at 0 or below. */
export function tableUnder(others: readonly Box[]): number {
  return Math.min(0, ...others.map(({ min }) => min[2]));
}
