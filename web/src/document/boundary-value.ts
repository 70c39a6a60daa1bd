/** Editing free boundary data: the modes of each component, each with the data of its cosine and its sine. */

import { DATA } from "./families.gen";
import type { Path } from "./path";
import { setPath } from "./path";
import { LIMITS } from "./tables.gen";
import type { BoundaryValue, Component, Datum, Mode } from "./types";

export type Axis = "x" | "y" | "z";
export const AXES: readonly Axis[] = ["x", "y", "z"];
export const MAX_MODES = LIMITS.modes;

export type DatumName = (typeof DATA)[2 | 4][number];

/** The data that a component can be given: of its order, but for the slopes at free ends. */
export function datumNames({ order, free }: Component): readonly DatumName[] {
  const isFree = { start_u: free === "start" || free === "both", end_u: free === "end" || free === "both" };
  return DATA[order].filter((name) => !((name === "start_u" || name === "end_u") && isFree[name]));
}

export function hasSine(mode: Mode): boolean {
  return mode.n !== 0;
}

/** The first whole frequency that the component does not use yet. */
function nextFrequency(component: Component): number {
  let n = 0;
  while (component.modes.some((mode) => mode.n === n)) n += 1;
  return n;
}

export function withMode(shape: BoundaryValue, axis: Axis): BoundaryValue {
  const component = shape[axis];
  const mode: Mode = { n: nextFrequency(component), cos: {} };
  return {
    ...shape,
    [axis]: { ...component, modes: [...component.modes, mode] },
  };
}

export function withoutMode(shape: BoundaryValue, axis: Axis, index: number): BoundaryValue {
  const component = shape[axis];
  if (component.modes[index] === undefined) return shape;
  return {
    ...shape,
    [axis]: {
      ...component,
      modes: component.modes.filter((_, i) => i !== index),
    },
  };
}

/** The component in the other order. Slopes, free ends and `w` mean nothing to order 2 and are left out there. */
export function withOrder(shape: BoundaryValue, axis: Axis, order: 2 | 4): BoundaryValue {
  const component = shape[axis];
  if (component.order === order) return shape;
  if (order === 4) return { ...shape, [axis]: { ...component, order, w: component.w ?? 0 } };
  const { w: _w, free: _free, ...rest } = component;
  const modes = component.modes.map((mode) => ({
    n: mode.n,
    ...(mode.cos && { cos: withoutSlopes(mode.cos) }),
    ...(mode.sin && { sin: withoutSlopes(mode.sin) }),
  }));
  return { ...shape, [axis]: { ...rest, order, modes } };
}

function withoutSlopes(datum: Datum): Datum {
  const { start_u: _start, end_u: _end, ...rest } = datum;
  return rest;
}

/** Where the table keeps a number, inside the shape. */
export function datumPath(axis: Axis, index: number, wave: "cos" | "sin", name: DatumName): Path {
  return [axis, "modes", index, wave, name];
}

/** The force of one harmonic, trailing zeros dropped. */
export function withForce(
  shape: BoundaryValue,
  axis: Axis,
  index: number,
  wave: "cos" | "sin",
  force: readonly number[],
): BoundaryValue {
  let length = force.length;
  while (length > 0 && force[length - 1] === 0) length -= 1;
  return setPath(shape, [axis, "modes", index, wave, "force"], length === 0 ? undefined : force.slice(0, length));
}
