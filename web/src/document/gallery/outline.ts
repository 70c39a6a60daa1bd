/**
 * Free boundary data written as a potter sees a pot: a radius that swells round the axis, and a height.
 *
 * In polar form `radius(u, v) = a(u) + sum_m [ c_m(u) cos(m v) + d_m(u) sin(m v) ]`. Times `cos v` and `sin v` each wave
 * falls into the two neighbouring harmonics `m - 1` and `m + 1` of `x` and `y`, half each.
 */

import type { BoundaryValue, Component, Datum, Mode } from "../types";

/** One wave of the wall: its values and slopes `d/du` at the foot (`u = 0`) and at the rim, and the force on it. */
export interface Profile {
  readonly foot?: number;
  readonly rim?: number;
  readonly footSlope?: number;
  readonly rimSlope?: number;
  /** Coefficients in ascending powers of `u`. */
  readonly force?: readonly number[];
}

/** A wave that goes `n` times round the pot. */
export interface Wave {
  readonly n: number;
  readonly cos?: Profile;
  readonly sin?: Profile;
}

export interface Outline {
  /** `s`, `t`, `w` of `x` and `y`; those of `z` act on its waves alone and are the same. */
  readonly equation: readonly [s: number, t: number, w: number];
  readonly radius: Profile;
  readonly petals?: readonly Wave[];
  readonly height: Profile;
  readonly waves?: readonly Wave[];
  /** Where the axis is in `x`, at foot and rim: a pot may lean. */
  readonly axis?: Profile;
}

export function turned({ equation, radius, petals = [], height, waves = [], axis }: Outline): BoundaryValue {
  const x = new Map<number, Mode>();
  const y = new Map<number, Mode>();
  if (axis) put(x, 0, "cos", axis, 1);
  put(x, 1, "cos", radius, 1);
  put(y, 1, "sin", radius, 1);
  for (const { n, cos, sin } of petals) {
    if (cos) {
      put(x, n - 1, "cos", cos, 0.5);
      put(x, n + 1, "cos", cos, 0.5);
      put(y, n - 1, "sin", cos, -0.5);
      put(y, n + 1, "sin", cos, 0.5);
    }
    if (sin) {
      put(x, n - 1, "sin", sin, 0.5);
      put(x, n + 1, "sin", sin, 0.5);
      put(y, n - 1, "cos", sin, 0.5);
      put(y, n + 1, "cos", sin, -0.5);
    }
  }
  const z = new Map<number, Mode>();
  put(z, 0, "cos", height, 1);
  for (const { n, cos, sin } of waves) {
    if (cos) put(z, n, "cos", cos, 1);
    if (sin) put(z, n, "sin", sin, 1);
  }
  const [s, t, w] = equation;
  const component = (modes: Map<number, Mode>): Component => ({
    order: 4,
    s,
    t,
    w,
    modes: [...modes.values()].sort((a, b) => a.n - b.n),
  });
  return { kind: "boundary-value", span: "2pi", x: component(x), y: component(y), z: component(z) };
}

function put(modes: Map<number, Mode>, n: number, wave: "cos" | "sin", profile: Profile, factor: number): void {
  const mode = modes.get(n) ?? { n };
  const before = mode[wave];
  const scaled = (value: number | undefined) => (value ?? 0) * factor;
  const sum = (a: number | undefined, b: number | undefined) => neat((a ?? 0) + scaled(b));
  const force = Array.from({ length: Math.max(before?.force?.length ?? 0, profile.force?.length ?? 0) }, (_, i) =>
    sum(before?.force?.[i], profile.force?.[i]),
  );
  const datum: Datum = {
    start: sum(before?.start, profile.foot),
    end: sum(before?.end, profile.rim),
    start_u: sum(before?.start_u, profile.footSlope),
    end_u: sum(before?.end_u, profile.rimSlope),
    ...(force.length > 0 && { force }),
  };
  modes.set(n, { ...mode, [wave]: datum });
}

/** Whole micrometres of a pot in centimetres: fields stay readable. */
function neat(value: number): number {
  const rounded = Math.round(value * 1e4) / 1e4;
  return rounded === 0 ? 0 : rounded;
}
