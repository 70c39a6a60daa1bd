/**
 * A closed curve as what goes round with it: `y + i x = sum c_k exp(2 pi i k v)`. The disc of the papers has `c_1` alone, so that what is turned, stretched or wavy is read from the others.
 */

import type { Section } from "../types";

export type OutlineSection = Extract<Section, { readonly form: "outline" }>;
type Harmonic = OutlineSection["x"][number];

/** `re + i im` */
export type Complex = readonly [re: number, im: number];

/** By `k`, which goes both ways; what is not there is 0. */
export type Waves = ReadonlyMap<number, Complex>;

/** Digits that a number of a document keeps: those of canonical form. */
const DIGITS = 12;

export const NOTHING: Complex = [0, 0];

export function waveAt(waves: Waves, k: number): Complex {
  return waves.get(k) ?? NOTHING;
}

export function sizeOf([re, im]: Complex): number {
  return Math.hypot(re, im);
}

/** Turned on by an angle, in radians. */
export function turnedBy([re, im]: Complex, angle: number): Complex {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [re * c - im * s, re * s + im * c];
}

export function wavesOf({ x, y }: Pick<OutlineSection, "x" | "y">): Waves {
  const waves = new Map<number, Complex>();
  const add = (k: number, re: number, im: number) => {
    const [a, b] = waveAt(waves, k);
    waves.set(k, [a + re, b + im]);
  };
  for (const { n, cos = 0, sin = 0 } of y) {
    if (n === 0) add(0, cos, 0);
    else {
      add(n, cos / 2, -sin / 2);
      add(-n, cos / 2, sin / 2);
    }
  }
  for (const { n, cos = 0, sin = 0 } of x) {
    if (n === 0) add(0, 0, cos);
    else {
      add(n, sin / 2, cos / 2);
      add(-n, -sin / 2, cos / 2);
    }
  }
  return waves;
}

/** As a document has it; what is too small to matter beside `unit` is left out. */
export function seriesOf(waves: Waves, unit: number): Pick<OutlineSection, "x" | "y"> {
  const orders = [...new Set([...waves.keys()].map((k) => Math.abs(k)))].sort((a, b) => a - b);
  const list = (of: (n: number, forth: Complex, back: Complex) => readonly [cos: number, sin: number]): Harmonic[] =>
    orders.flatMap((n) => {
      const [cos, sin] = of(n, waveAt(waves, n), waveAt(waves, -n)).map((value) => short(value, unit)) as [
        number,
        number,
      ];
      return cos === 0 && sin === 0 ? [] : [{ n, ...(cos !== 0 && { cos }), ...(sin !== 0 && { sin }) }];
    });
  return {
    x: list((n, [re, im], [reBack, imBack]) => (n === 0 ? [im, 0] : [im + imBack, re - reBack])),
    y: list((n, [re, im], [reBack, imBack]) => (n === 0 ? [re, 0] : [re + reBack, imBack - im])),
  };
}

function short(value: number, unit: number): number {
  return Math.abs(value) < 1e-11 * unit ? 0 : Number(value.toPrecision(DIGITS));
}
