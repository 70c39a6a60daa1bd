/** The regime of a mode: which roots `s r^2 - t k^2`, or `s r^4 - t k^2 r^2 + w k^4`, has. It decides which functions its solutions are made of. */

import type { Component } from "./problem";

/** A pair `+r`, `-r` of roots: real where `z = r^2` is above 0, imaginary below it, both 0 at it. */
export interface Pair {
  readonly z: number;
  /** `sqrt(|z|)`: how fast its solutions grow, fall or swing. */
  readonly rate: number;
}

export type Roots =
  /** Order 2. */
  | { readonly order: 2; readonly kind: "single"; readonly pair: Pair }
  /** Order 4, each root once; both pairs are real or imaginary, and one of them may be 0. The larger first. */
  | { readonly order: 4; readonly kind: "two"; readonly pairs: readonly [Pair, Pair] }
  /** Order 4, each root twice; all four may be 0. */
  | { readonly order: 4; readonly kind: "double"; readonly pair: Pair }
  /** `+-sigma +- i delta`. */
  | { readonly order: 4; readonly kind: "complex"; readonly sigma: number; readonly delta: number };

/** What the discriminant may be off, relative to what it is the difference of, for roots that are the same. */
const DUST = 1e-13;

export function pairOf(z: number): Pair {
  return { z, rate: Math.sqrt(Math.abs(z)) };
}

/** `b` and `c` of `q'' - b q`, or of `q'''' - b q'' + c q`. */
export function coefficients({ order, s, t, w }: Component, k: number): readonly [b: number, c: number] {
  const square = k * k;
  return [(t.value * square) / s.value, order === 4 ? (w.value * square * square) / s.value : 0];
}

export function rootsOf(component: Component, k: number): Roots {
  const [b, c] = coefficients(component, k);
  if (component.order === 2) return { order: 2, kind: "single", pair: pairOf(b) };
  const inside = b * b - 4 * c;
  if (Math.abs(inside) <= DUST * (b * b + 4 * Math.abs(c))) return { order: 4, kind: "double", pair: pairOf(0.5 * b) };
  if (inside < 0) {
    const root = Math.sqrt(c);
    return {
      order: 4,
      kind: "complex",
      sigma: Math.sqrt(0.25 * (2 * root + b)),
      delta: Math.sqrt(0.25 * (2 * root - b)),
    };
  }
  // The larger without cancellation, the smaller from the product.
  const large = 0.5 * (b < 0 ? b - Math.sqrt(inside) : b + Math.sqrt(inside));
  return { order: 4, kind: "two", pairs: [pairOf(large), pairOf(c / large)] };
}

/** The rate of the fastest solution. */
export function fastest(roots: Roots): number {
  switch (roots.kind) {
    case "single":
    case "double":
      return roots.pair.rate;
    case "two":
      return Math.max(roots.pairs[0].rate, roots.pairs[1].rate);
    case "complex":
      return Math.hypot(roots.sigma, roots.delta);
  }
}
