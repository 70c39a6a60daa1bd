/** Rings of boundary data that are written out, as numbers that a potter knows: the mean radius and the mean height of each, and where along the wall it is. */

import { isRound } from "./radial-pull";
import type { BoundaryValue, Component, Datum, Mode } from "./types";

/** Rings keep this distance from their neighbours, along `u`. */
const APART = 1e-4;

export type Mean = "radius" | "height";

/** The mean of a ring, by its number; null for a radius where the wall does not go once round the axis. */
export function meanOf(shape: BoundaryValue, ring: number, of: Mean): number | null {
  if (of === "height") return given(shape.z, 0, "cos", ring);
  return isRound(shape) ? (given(shape.x, 1, "cos", ring) + given(shape.y, 1, "sin", ring)) / 2 : null;
}

/** The same with another mean; all else of the ring stays. */
export function withMean(shape: BoundaryValue, ring: number, of: Mean, value: number): BoundaryValue {
  const now = meanOf(shape, ring, of);
  if (now === null) return shape;
  const count = shape.rings?.length ?? 0;
  const more = (component: Component, n: number, wave: "cos" | "sin") =>
    added(component, n, wave, ring, count, value - now);
  return of === "height"
    ? { ...shape, z: more(shape.z, 0, "cos") }
    : { ...shape, x: more(shape.x, 1, "cos"), y: more(shape.y, 1, "sin") };
}

/** With a ring elsewhere, between its neighbours. */
export function withPlace(shape: BoundaryValue, ring: number, u: number): BoundaryValue {
  const rings = shape.rings ?? [];
  const [below, above] = [rings[ring - 1]?.u ?? 0, rings[ring + 1]?.u ?? 1];
  const within = Math.min(above - APART, Math.max(below + APART, u));
  return { ...shape, rings: rings.map((each, i) => (i === ring ? { ...each, u: within } : each)) };
}

export function withSharpRing(shape: BoundaryValue, ring: number, sharp: boolean): BoundaryValue {
  const rings = (shape.rings ?? []).map((each, i) =>
    i === ring ? { u: each.u, ...(sharp && { sharp: true as const }) } : each,
  );
  return { ...shape, rings };
}

function given({ modes }: Component, n: number, wave: "cos" | "sin", ring: number): number {
  return modes.reduce((sum, mode) => sum + (mode.n === n ? (mode[wave]?.rings?.[ring] ?? 0) : 0), 0);
}

function added(
  component: Component,
  n: number,
  wave: "cos" | "sin",
  ring: number,
  count: number,
  by: number,
): Component {
  const more = (datum: Datum | undefined): Datum => ({
    ...datum,
    rings: Array.from({ length: count }, (_, i) => (datum?.rings?.[i] ?? 0) + (i === ring ? by : 0)),
  });
  const place = component.modes.findIndex((mode) => mode.n === n);
  const modes: readonly Mode[] =
    place < 0
      ? [...component.modes, { n, [wave]: more(undefined) }]
      : component.modes.map((mode, i) => (i === place ? { ...mode, [wave]: more(mode[wave]) } : mode));
  return { ...component, modes };
}
