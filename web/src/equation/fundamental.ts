/**
 * The fundamental solutions of an equation of order 4 about one end, which start like `x`, `x^2 / 2` and `x^3 / 6`: `C` with `B = C'`, `A = B'`, and `A'`. From them comes what holds a beam: for the solution on [0, h]
 * with given values and slopes at both ends, its second derivatives there.
 */

import { fastest, type Pair, pairOf, type Roots } from "./roots";

/** Second derivatives of a beam of a length at its near end and at its far one, for a unit of value or of slope at the near end. */
export interface Bending {
  readonly value: readonly [near: number, far: number];
  readonly slope: readonly [near: number, far: number];
}

/** Of the solution on [0, h]. `b` and `c` are those of `q'''' - b q'' + c q`. */
export function bending(roots: Fourth, [b, c]: readonly [number, number], h: number): Bending {
  if (fastest(roots) * h <= SERIES) return ofFundamental(series(b, c, h));
  switch (roots.kind) {
    case "double":
      return ofFundamental(double(roots.pair, h));
    case "complex":
      return ofFundamental(complex(roots.sigma, roots.delta, h));
    case "two": {
      const [one, other] = roots.pairs;
      const isNear = one.z * other.z > 0 && Math.abs(one.rate - other.rate) * h < NEAR;
      return isNear ? ofFundamental(double(pairOf(0.5 * (one.z + other.z)), h)) : apart(roots.pairs, h);
    }
  }
}

type Fourth = Roots & { readonly order: 4 };

/** Up to this product of rate and length the closed forms lose digits that power series keep. */
const SERIES = 2;
const TERMS = 40;
/** Two rates whose difference times the length is below this are taken for their mean: what that is off is of the size of its square, and what would cancel is as large. */
const NEAR = 2e-4;

/** `C` with its first three derivatives at the far end, divided by the exponential of `grown`. */
interface Fundamental {
  readonly slope: number;
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly grown: number;
}

function ofFundamental({ slope, a, b, c, grown }: Fundamental): Bending {
  const determinant = b * b - a * c;
  const fallen = Math.exp(-grown);
  return {
    value: [(b * slope - a * a) / determinant, (b * fallen) / determinant],
    slope: [(c * slope - b * a) / determinant, (c * fallen) / determinant],
  };
}

function double(pair: Pair, h: number): Fundamental {
  const { even, odd, grown } = functions(pair, h);
  return {
    slope: even + 0.5 * pair.z * h * odd,
    a: 0.5 * (odd + h * even),
    b: 0.5 * h * odd,
    c: (0.5 * (h * even - odd)) / pair.z,
    grown,
  };
}

function complex(sigma: number, delta: number, h: number): Fundamental {
  const grown = sigma * h;
  const [cosh, sinh] = [0.5 * (1 + Math.exp(-2 * grown)), 0.5 * (1 - Math.exp(-2 * grown))];
  const [cos, sin] = [Math.cos(delta * h), Math.sin(delta * h)];
  const product = 2 * sigma * delta;
  return {
    slope: ((sigma * sigma - delta * delta) * sinh * sin) / product + cosh * cos,
    a: (sigma * cosh * sin + delta * sinh * cos) / product,
    b: (sinh * sin) / product,
    c: (sigma * cosh * sin - delta * sinh * cos) / (product * (sigma * sigma + delta * delta)),
    grown,
  };
}

/** With `cosh^2 - sinh^2 = 1` written out: where one pair outgrows the other, the squares of the faster are what would cancel. */
function apart([one, other]: readonly [Pair, Pair], h: number): Bending {
  const [first, second] = [functions(one, h), functions(other, h)];
  const [p, q] = [Math.exp(-first.grown), Math.exp(-second.grown)];
  const none = p * q;
  const determinant = 2 * none - 2 * first.even * second.even + (one.z + other.z) * first.odd * second.odd;
  const distance = one.z - other.z;
  return {
    value: [
      ((one.z + other.z) * (none - first.even * second.even) + 2 * one.z * other.z * first.odd * second.odd) /
        determinant,
      (distance * (first.even * q - second.even * p)) / determinant,
    ],
    slope: [
      (distance * (first.odd * second.even - second.odd * first.even)) / determinant,
      (distance * (first.odd * q - second.odd * p)) / determinant,
    ],
  };
}

/** `cosh(r x)` and `sinh(r x) / r`, or their kin for imaginary and for no roots, divided by `exp(grown)`. */
function functions(
  { z, rate }: Pair,
  x: number,
): { readonly even: number; readonly odd: number; readonly grown: number } {
  if (z === 0) return { even: 1, odd: x, grown: 0 };
  if (z < 0) return { even: Math.cos(rate * x), odd: Math.sin(rate * x) / rate, grown: 0 };
  const grown = rate * x;
  const small = Math.exp(-2 * grown);
  return { even: 0.5 * (1 + small), odd: (0.5 * (1 - small)) / rate, grown };
}

function series(b: number, c: number, x: number): Fundamental {
  // Of C, by `q'''' = b q'' - c q`.
  const terms = [0, 0, 0, 1 / 6];
  for (let n = 0; n + 4 < TERMS; n += 1) {
    const two = terms[n + 2] ?? 0;
    const none = terms[n] ?? 0;
    terms.push((b * (n + 2) * (n + 1) * two - c * none) / ((n + 4) * (n + 3) * (n + 2) * (n + 1)));
  }
  const sums = [0, 0, 0, 0] as [number, number, number, number];
  for (let n = TERMS - 1; n >= 0; n -= 1) {
    const term = terms[n] ?? 0;
    let factor = 1;
    for (const order of [0, 1, 2, 3] as const) {
      if (n >= order) sums[order] += term * factor * x ** (n - order);
      factor *= n - order;
    }
  }
  return { c: sums[0], b: sums[1], a: sums[2], slope: sums[3], grown: 0 };
}
