/** The curves that a surface is told to pass through: its two ends and its rings. Where they are, and what becomes of the shape without one. */

import { AXES } from "./boundary-value";
import type { BoundaryValue, Component, Datum, Mode, Rings, Series, Shape, Triple } from "./types";

/** A hand within this of a ring, along `u`, takes hold of it: otherwise the solver puts one where the hand is. */
const NEAR = 1 / 64;

/** One of them. */
export interface Curve {
  readonly u: number;
  /** Its number from the first, an end, on. */
  readonly index: number;
  /** Ends stay, rings may go. */
  readonly end: boolean;
}

/** Those of a shape, from `u` 0 to `u` 1; none where a shape is so many numbers. */
export function curvesOf(shape: Shape): readonly Curve[] {
  const places = placesOf(shape);
  return places.map((u, index) => ({ u, index, end: index === 0 || index === places.length - 1 }));
}

/** Where a hand by keys takes hold: at every curve, and of a family of numbers at both ends and between them. */
export function gripsOf(shape: Shape): readonly Curve[] {
  const curves = curvesOf(shape);
  return curves.length > 0 ? curves : [0, 0.5, 1].map((u, index) => ({ u, index, end: u !== 0.5 }));
}

function placesOf(shape: Shape): readonly number[] {
  if (shape.kind === "rings") return shape.rings.map(({ u }) => u);
  return shape.kind === "boundary-value" ? [0, ...(shape.rings ?? []).map(({ u }) => u), 1] : [];
}

/** The curve that a hand at `u` takes hold of; null where a pull puts a new one. */
export function curveUnder(shape: Shape, u: number): Curve | null {
  const [nearest] = [...curvesOf(shape)].sort((a, b) => Math.abs(a.u - u) - Math.abs(b.u - u));
  return nearest && Math.abs(nearest.u - u) <= NEAR ? nearest : null;
}

/** Where a curve is at `v`, before placement; null of a shape that has none. */
export function pointOn(shape: Shape, index: number, v: number): Triple | null {
  if (shape.kind === "rings") {
    const ring = shape.rings[index];
    if (!ring) return null;
    const r = seriesAt(ring.r, v);
    return [r * Math.cos(v), r * Math.sin(v), seriesAt(ring.z, v)];
  }
  if (shape.kind !== "boundary-value") return null;
  const turns = (2 * Math.PI * v) / spanOf(shape);
  const count = shape.rings?.length ?? 0;
  const [x, y, z] = AXES.map((axis) => sumOf(shape[axis], index, count, turns)) as [number, number, number];
  return [x, y, z];
}

/** The `v` at which its walls meet again. */
export function spanOf(shape: Pick<BoundaryValue, "span"> | Exclude<Shape, BoundaryValue>): number {
  return "span" in shape && typeof shape.span === "number" ? shape.span : 2 * Math.PI;
}

/** A series at `v`. */
function seriesAt({ mean, waves = [] }: Series, v: number): number {
  return waves.reduce((sum, { n, cos = 0, sin = 0 }) => sum + cos * Math.cos(n * v) + sin * Math.sin(n * v), mean);
}

function sumOf({ modes }: Component, curve: number, count: number, turns: number): number {
  return modes.reduce((sum, { n, cos, sin }) => {
    const [a, b] = [givenAt(cos, curve, count), givenAt(sin, curve, count)];
    return sum + a * Math.cos(n * turns) + b * Math.sin(n * turns);
  }, 0);
}

function givenAt(datum: Datum | undefined, curve: number, count: number): number {
  if (curve === 0) return datum?.start ?? 0;
  return (curve <= count ? datum?.rings?.[curve - 1] : datum?.end) ?? 0;
}

/** The shape without one of its rings; the same shape where that is an end. */
export function withoutCurve(shape: Shape, index: number): Shape {
  const curve = curvesOf(shape)[index];
  if (!curve || curve.end) return shape;
  if (shape.kind === "rings") return withoutHoop(shape, index);
  return shape.kind === "boundary-value" ? withoutRing(shape, index - 1) : shape;
}

function withoutHoop(shape: Rings, index: number): Rings {
  return { ...shape, rings: shape.rings.filter((_, at) => at !== index) };
}

function withoutRing(shape: BoundaryValue, index: number): BoundaryValue {
  const others = <T>(list: readonly T[]) => list.filter((_, at) => at !== index);
  const datum = (given: Datum): Datum => {
    const { rings, ...rest } = given;
    return rings && rings.length > 1 ? { ...rest, rings: others(rings) } : rest;
  };
  const mode = ({ n, cos, sin }: Mode): Mode => ({
    n,
    ...(cos && { cos: datum(cos) }),
    ...(sin && { sin: datum(sin) }),
  });
  const component = <C extends Component>(given: C): C => ({ ...given, modes: given.modes.map(mode) });
  const { rings = [], ...rest } = shape;
  const left = others(rings);
  return {
    ...rest,
    ...(left.length > 0 && { rings: left }),
    x: component(shape.x),
    y: component(shape.y),
    z: component(shape.z),
  };
}
