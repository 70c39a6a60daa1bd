/** Some rings of a pot come nearer to the foot or further from it, or become wider or narrower, all by one factor: what makes up for what a hand does to what the pot holds. */

import type { MakingUp } from "../document/locks";
import type { Rings, Series } from "../document/types";

/** Steps of the secant method at most: four or five suffice. */
const MOST_STEPS = 16;

/** Nothing becomes more than so many times as high or wide, or as low or narrow. */
const MOST = 3;

/** Digits of numbers that are multiplied. */
const DIGITS = 10;

/** The factor at which `off`, by what part the pot holds more than it did, is no more than `within`; null where none is found, or where `off` has no answer. */
export function factorFor(
  along: MakingUp["along"],
  within: number,
  off: (factor: number) => number | null,
): number | null {
  let last = { factor: 1, off: off(1) };
  if (last.off === null) return null;
  if (Math.abs(last.off) <= within) return 1;
  // What a pot holds goes as its height and as the square of its width: that is near enough to begin with.
  let factor = bounded((1 + last.off) ** (along === "z" ? -1 : -0.5));
  for (let step = 0; step < MOST_STEPS; step += 1) {
    const next: number | null = off(factor);
    if (next === null || next === last.off) return null;
    if (Math.abs(next) <= within) return factor;
    const further: number = bounded(factor - (next * (factor - last.factor)) / (next - (last.off as number)));
    [last, factor] = [{ factor, off: next }, further];
  }
  return null;
}

function bounded(factor: number): number {
  return Math.min(MOST, Math.max(1 / MOST, factor));
}

export function madeUp(shape: Rings, { along, rings }: MakingUp, factor: number): Rings {
  const from = along === "z" ? (shape.rings[0]?.z.mean ?? 0) : 0;
  return {
    ...shape,
    rings: shape.rings.map((ring, index) =>
      rings.includes(index) ? { ...ring, [along]: times(ring[along], factor, from) } : ring,
    ),
  };
}

/** A series as far again from `from`, by a factor. */
function times({ mean, waves }: Series, factor: number, from: number): Series {
  const short = (value: number) => Number(value.toPrecision(DIGITS));
  return {
    mean: short(from + factor * (mean - from)),
    ...(waves && {
      waves: waves.map(({ n, cos, sin }) => ({
        n,
        ...(cos !== undefined && { cos: short(factor * cos) }),
        ...(sin !== undefined && { sin: short(factor * sin) }),
      })),
    }),
  };
}
