/**
 * Petals as the eye counts them. The planar families draw `r cos(2 pi n1 v) + d cos(2 pi n2 v)` and its sine: while the wall goes round `n1` times the second wave goes
 * round `n2` times, and swings out where the two meet, which is `n2 - n1` times.
 */

import { filled } from "./kinds";
import type { Path } from "./path";
import { numberAt, setPath } from "./path";
import type { Shape } from "./types";

/** What the petals are in the paper's symbols. */
export const PETALS_SYMBOL = "n_2 − n_1";

/** Digits that a difference of two numbers keeps. */
const DIGITS = 12;

const TURNS: Path = ["n", 0];
const WAVES: Path = ["n", 1];

function is(path: Path, other: Path): boolean {
  return path.length === other.length && path.every((key, index) => key === other[index]);
}

function isPlanar({ kind }: Shape): boolean {
  return kind === "second-order" || kind === "mixed-order";
}

/** The petals of a shape, if the number at this path is what they come from. */
export function petalsAt(shape: Shape, path: Path): number | null {
  if (!isPlanar(shape) || !is(path, WAVES)) return null;
  const whole = filled(shape);
  return Number((numberAt(whole, WAVES, Number.NaN) - numberAt(whole, TURNS, Number.NaN)).toPrecision(DIGITS));
}

/** The shape, with everything written out, after the number at a path was set: petals become waves, and turns leave the petals as many as they were. */
export function withPetals<S extends Shape>(shape: S, path: Path, value: number): S | null {
  if (!isPlanar(shape)) return null;
  const whole = filled(shape);
  const turns = numberAt(whole, TURNS, Number.NaN);
  const waves = (petals: number, round: number) => Number((petals + round).toPrecision(DIGITS));
  if (is(path, WAVES)) return setPath(whole, WAVES, waves(value, turns));
  if (is(path, TURNS)) {
    const petals = petalsAt(whole, WAVES) ?? 0;
    return setPath(setPath(whole, TURNS, value), WAVES, waves(petals, value));
  }
  return null;
}
