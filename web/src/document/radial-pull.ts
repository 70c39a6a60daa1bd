/**
 * Boundary data that are written out, pulled away from the axis at several places or all round: a bump along the radius is added to one curve. The solver's own pull moves a curve along one
 * direction, which is another thing wherever more than one place is pulled.
 */

import type { Bump } from "./brush";
import { curvesOf, spanOf } from "./curves";
import type { BoundaryValue, Component, Datum, Mode } from "./types";

/** Whether the angle round the axis is `v` itself. */
export function isRound(shape: BoundaryValue): boolean {
  return shape.span === "2pi" || Math.abs(spanOf(shape) - 2 * Math.PI) < 1e-12;
}

/** How far a curve is moved at the middle of a bump: along the axis, and away from it in the direction that is `lean` beyond `v`, which is where the point is that a hand holds. */
export interface RadialMove {
  readonly out: number;
  readonly up: number;
  readonly lean: number;
}

/** The same with `out b(v - v0)` added along the radius of a curve, by its number, and `up b(v - v0)` along the axis. Modes of the same frequency stand beside each other: canonical form adds them up. */
export function pulledRound(
  shape: BoundaryValue,
  curve: number,
  { out, up, lean }: RadialMove,
  bump: Bump,
  v0: number,
): BoundaryValue {
  const count = curvesOf(shape).length;
  const waves = wavesOf(bump);
  const radial = (turned: number) =>
    waves.flatMap(({ n, amplitude }): Mode[] =>
      // cos(n (v - v0)) cos(v + lean - turned), as a sum.
      [1, -1].map((side) => wave(n + side, (out * amplitude) / 2, n * v0 + side * (turned - lean), curve, count)),
    );
  const along = waves.map(({ n, amplitude }) => wave(n, up * amplitude, n * v0, curve, count));
  const more = (component: Component, modes: readonly Mode[]): Component => ({
    ...component,
    modes: [...component.modes, ...modes],
  });
  return {
    ...shape,
    ...(out !== 0 && { x: more(shape.x, radial(0)), y: more(shape.y, radial(Math.PI / 2)) }),
    ...(up !== 0 && { z: more(shape.z, along) }),
  };
}

/** The waves that a bump is the sum of: `cos^(2N)(x / 2) = sum C(2N, N - k) cos(k x) / 4^N` over `k` from `-N` to `N`. */
export function wavesOf({ degree, petals }: Bump): readonly { readonly n: number; readonly amplitude: number }[] {
  let amplitude = 1;
  for (let j = 1; j <= degree; j += 1) amplitude *= (2 * j - 1) / (2 * j);
  const waves = [{ n: 0, amplitude }];
  amplitude *= 2;
  for (let k = 1; k <= degree; k += 1) {
    amplitude *= (degree + 1 - k) / (degree + k);
    waves.push({ n: k * petals, amplitude });
  }
  return waves;
}

/** `amplitude cos(n v - phase)` at one curve and nothing at the others. */
function wave(n: number, amplitude: number, phase: number, curve: number, count: number): Mode {
  const [turns, sign] = n < 0 ? [-n, -1] : [n, 1];
  const datum = (value: number): Datum => {
    if (curve === 0) return { start: value };
    if (curve === count - 1) return { end: value };
    return { rings: Array.from({ length: count - 2 }, (_, ring) => (ring === curve - 1 ? value : 0)) };
  };
  const cos = datum(amplitude * Math.cos(phase));
  return turns === 0 ? { n: 0, cos } : { n: turns, cos, sin: datum(sign * amplitude * Math.sin(phase)) };
}
