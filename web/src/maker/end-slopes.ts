/** The slopes at the ends of a pot: given as they are, they stay while rings are pulled. A surface with its own slopes given is the same surface. */

import { derivatives } from "pasu";
import { AXES } from "../document/boundary-value";
import { spanOf } from "../document/curves";
import type { BoundaryValue, Component, Mode, Rings, Sent, SentShape, Series, Shape } from "../document/types";

/** Below the size of the slopes by this factor a wave is rounding. */
const NOTHING = 1e-11;

/** As many as a document has. */
const DIGITS = 12;

/** The same surface with the slopes given at the ends where none were. */
export function withSlopes(shape: Shape): Shape {
  if (shape.kind === "rings") return ringsWithSlopes(shape);
  return shape.kind === "boundary-value" ? writtenWithSlopes(shape) : shape;
}

function ringsWithSlopes(pot: Rings): Rings {
  const most = Math.max(
    0,
    ...pot.rings.flatMap(({ r, z }) => [r, z]).flatMap(({ waves = [] }) => waves.map(({ n }) => n)),
  );
  // Waves of the radius are those of x and y, one more or less of each.
  const at = (u: number) => {
    const found = around(pot, u, most + 2, 2 * Math.PI);
    const along = found.map(([x, y], index) => {
      const v = (2 * Math.PI * index) / found.length;
      return x * Math.cos(v) + y * Math.sin(v);
    });
    const size = Math.max(...found.flat().map(Math.abs));
    return {
      r: seriesOf(along, size),
      z: seriesOf(
        found.map(([, , z]) => z),
        size,
      ),
    };
  };
  return { ...pot, foot: pot.foot ?? at(0), rim: pot.rim ?? at(1) };
}

function writtenWithSlopes(shape: BoundaryValue): BoundaryValue {
  const counts = AXES.flatMap((axis) => shape[axis].modes.map(({ n }) => n));
  // What does not close round the axis has no waves to be read off.
  if (!counts.every(Number.isInteger)) return shape;
  const most = Math.max(0, ...counts);
  const ends = ([0, 1] as const).map((u) => around(shape, u, most, spanOf(shape)));
  const [x, y, z] = AXES.map((axis, index) => {
    const [start, end] = ends.map((found) => wavesOf(found.map((point) => point[index] ?? 0)));
    return start && end ? held(shape[axis], start, end) : shape[axis];
  });
  return x && y && z ? { ...shape, x, y, z } : shape;
}

/** A component with slopes where it was free. Order 2 has none. */
function held(component: Component, start: readonly Wave[], end: readonly Wave[]): Component {
  if (component.order !== 4 || component.free === undefined) return component;
  const { free, ...rest } = component;
  const added = new Set<number>();
  const modes = rest.modes.map((mode): Mode => {
    // Of several modes of one frequency the first takes the slope of all.
    if (added.has(mode.n)) return mode;
    added.add(mode.n);
    const datum = (name: "cos" | "sin") => {
      const slope = (waves: readonly Wave[]) => short(waves[mode.n]?.[name] ?? 0);
      return {
        ...mode[name],
        ...(free !== "end" && { start_u: slope(start) }),
        ...(free !== "start" && { end_u: slope(end) }),
      };
    };
    return { n: mode.n, cos: datum("cos"), ...(mode.n > 0 && { sin: datum("sin") }) };
  });
  return { ...rest, modes } as Component;
}

interface Wave {
  readonly cos: number;
  readonly sin: number;
}

/** `X_u` at even steps round the axis, enough of them for so many waves. */
function around(shape: Shape, u: number, waves: number, span: number): readonly (readonly [number, number, number])[] {
  const count = 2 * waves + 2;
  const at = Array.from({ length: count }, (_, index) => [u, (span * index) / count]).flat();
  const { du } = derivatives({ pasu: 1, parts: [{ shape: shape as SentShape }] } as Sent, 0, at);
  return Array.from({ length: count }, (_, index) => [
    du[3 * index] ?? 0,
    du[3 * index + 1] ?? 0,
    du[3 * index + 2] ?? 0,
  ]);
}

/** The waves of values at even steps, by their number. */
function wavesOf(values: readonly number[]): readonly Wave[] {
  const count = values.length;
  return Array.from({ length: count / 2 }, (_, n) => {
    const sum = (of: (angle: number) => number) =>
      values.reduce((all, value, index) => all + value * of((2 * Math.PI * ((n * index) % count)) / count), 0);
    const factor = (n === 0 ? 1 : 2) / count;
    return { cos: factor * sum(Math.cos), sin: factor * sum(Math.sin) };
  });
}

function seriesOf(values: readonly number[], size: number): Series {
  const [mean, ...waves] = wavesOf(values);
  const left = waves.flatMap(({ cos, sin }, index) => {
    if (Math.hypot(cos, sin) <= NOTHING * size) return [];
    return [{ n: index + 1, cos: short(cos), sin: short(sin) }];
  });
  return { mean: short(mean?.cos ?? 0), ...(left.length > 0 && { waves: left }) };
}

function short(value: number): number {
  return Number(value.toPrecision(DIGITS));
}
