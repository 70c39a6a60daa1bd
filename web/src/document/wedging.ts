/** How much wet clay a pot begins with. */

/**
 * Grams of a cubic centimetre of clay as it is wedged: a fifth of its weight is water (throwing bodies have 19.5 to 22.5 %), and its minerals weigh 2.6 g/cm3:
 * `1 / (0.21 + 0.79 / 2.6)`.
 */
export const WET_DENSITY = 1.95;

/** Percentages from 0 to less than this: nothing shrinks to half, and whoever trims away more than there is of the pot counts it otherwise. */
export const MOST_SHRINKAGE = 50;
export const MOST_ALLOWANCE = 200;

/** What there is of each, in grams. */
export interface Wedging {
  /** The clay of the pot itself, wet and as large as it is before it shrinks. */
  readonly pot: number;
  /** What is trimmed off, thrown away and left on the hands. */
  readonly allowance: number;
  readonly all: number;
}

/** Of a fired volume in millilitres: each length was larger by what the clay shrinks, a percentage of the wet length. `allowance` is a percentage of the pot itself. */
export function wedging(fired: number, shrinkage: number, allowance: number): Wedging {
  const pot = (WET_DENSITY * fired) / (1 - shrinkage / 100) ** 3;
  const spare = (pot * allowance) / 100;
  return { pot, allowance: spare, all: pot + spare };
}
