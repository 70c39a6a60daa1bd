/** The range of a colour map: that of nearly all of the pot, so that a few extreme places do not leave the rest in one colour. */

import type { Painted } from "./messages";

/** What the package hands over. */
export interface Values {
  readonly values: Float32Array;
  readonly least: number;
  readonly greatest: number;
}

/** The share of the vertices at either end that the range leaves out. */
const LEFT_OUT = 0.02;

/** As many values as tell the range. */
const SAMPLE = 20_000;

export function paintedOf({ values, least, greatest }: Values): Painted {
  const stride = Math.max(1, Math.floor(values.length / SAMPLE));
  const sample = values.filter((value, index) => index % stride === 0 && Number.isFinite(value)).sort();
  const at = (share: number) => sample[Math.round(share * (sample.length - 1))] ?? 0;
  return { values, least, greatest, low: at(LEFT_OUT), high: at(1 - LEFT_OUT) };
}
