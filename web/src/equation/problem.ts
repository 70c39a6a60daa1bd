/**
 * The boundary value problem that a shape stands for: for each coordinate its equation, and for each of its waves round the pot what is given at the ends and at the rings. Every number knows where in the shape
 * it comes from. Named families expand as the solver expands them (ZY01 equations 1 to 17, IA equations 15 to 18).
 */

import type { Axis } from "../document/boundary-value";
import { type Amount, NOTHING } from "./amount";

/** A wave round the pot, `cos(k v)` or `sin(k v)`, and what is given of the function of `u` that stands before it. */
export interface Harmonic {
  readonly n: Amount;
  readonly wave: "cos" | "sin";
  readonly start: Amount;
  readonly end: Amount;
  readonly start_u: Amount;
  readonly end_u: Amount;
  /** Values at the rings. */
  readonly rings: readonly Amount[];
  /** A polynomial in `u`, in ascending powers. */
  readonly force: readonly Amount[];
}

/** Coordinate by coordinate: `s X_uu + t X_vv = p`, or `s X_uuuu + t X_uuvv + w X_vvvv = p`. */
export interface Component {
  readonly order: 2 | 4;
  readonly s: Amount;
  readonly t: Amount;
  readonly w: Amount;
  readonly free: { readonly start: boolean; readonly end: boolean };
  readonly harmonics: readonly Harmonic[];
}

/** A curve of constant `u` that the surface passes through. */
export interface Hold {
  readonly u: Amount;
  readonly sharp: boolean;
}

/** A radius or a height round the pot: a mean and waves. */
export interface Round {
  readonly mean: Amount;
  readonly waves: readonly { readonly n: Amount; readonly cos: Amount; readonly sin: Amount }[];
}

/** A curve as a potter says it: `x = r cos v`, `y = r sin v`. */
export interface Hoop {
  readonly u: Amount;
  readonly sharp: boolean;
  readonly r: Round;
  readonly z: Round;
}

export interface Problem {
  /** How far `v` runs round the pot: 1, a whole turn, or another length. */
  readonly span: "one" | "turn" | number;
  /** Those inside (0, 1), in ascending order. */
  readonly rings: readonly Hold[];
  readonly components: Readonly<Record<Axis, Component>>;
  /** The smoothing parameter, where all three coordinates obey `(d2/du2 + a^2 d2/dv2)^2 X = 0`. */
  readonly smoothing: Amount | null;
  /** What the ends and rings are called by, and the slopes at either end that are given, where they are given as radii and heights. */
  readonly hoops: { readonly list: readonly Hoop[]; readonly foot: Ends | null; readonly rim: Ends | null } | null;
}

/** Slopes of radius and height. */
export interface Ends {
  readonly r: Round;
  readonly z: Round;
}

/** What nothing is given of. */
export const SILENT: Omit<Harmonic, "n" | "wave"> = {
  start: NOTHING,
  end: NOTHING,
  start_u: NOTHING,
  end_u: NOTHING,
  rings: [],
  force: [],
};

/** The angular frequency: the wave is `cos(k v)`. */
export function frequency({ n }: Harmonic, span: Problem["span"]): number {
  if (span === "turn") return n.value;
  return (2 * Math.PI * n.value) / (span === "one" ? 1 : span);
}

/** Whether nothing is asked of a wave, so that it is nowhere. */
export function isSilent({ start, end, start_u, end_u, rings, force }: Harmonic): boolean {
  return [start, end, start_u, end_u, ...rings, ...force].every(({ value }) => value === 0);
}
