/**
 * The four boundary data of a pot as handles on its section: the rim and foot points, and the slopes of the wall there.
 *
 * A handle says which way the family lets it move and turns a movement into the family's own numbers. Movements are in
 * model units along the radius and the axis; slopes are `dX/du`, whichever end `u = 0` is.
 */

import { filled } from "./kinds";
import type { BoundaryValue, Component, FourthOrder, MixedOrder, Mode, SecondOrder, Shape } from "./types";

export type HandleId = "rim" | "foot" | "rim-slope" | "foot-slope";
export const HANDLE_IDS: readonly HandleId[] = ["rim", "rim-slope", "foot-slope", "foot"];

export const HANDLE_NAMES: Readonly<Record<HandleId, string>> = {
  rim: "Rim",
  foot: "Foot",
  "rim-slope": "Slope at the rim",
  "foot-slope": "Slope at the foot",
};

export interface Handle {
  readonly id: HandleId;
  readonly radial: boolean;
  readonly axial: boolean;
  /** Why it does not move, or moves one way only; empty when it is free. */
  readonly why: string;
}

/** Which end of `u` is the rim. */
export function rimAt(shape: Shape): 0 | 1 {
  switch (shape.kind) {
    case "fourth-order":
      return shape.h1 >= 0 ? 1 : 0;
    case "second-order":
    case "mixed-order":
      return (filled<SecondOrder | MixedOrder>(shape).height ?? 0) >= 0 ? 0 : 1;
    case "bloor-wilson":
      return shape.h[0] >= 0 ? 0 : 1;
    case "boundary-value": {
      const datum = shape.z.modes.find((mode) => mode.n === 0)?.cos;
      return (datum?.end ?? 0) > (datum?.start ?? 0) ? 1 : 0;
    }
  }
}

const FREE = "";
const FOOT_HEIGHT = "The foot of this family always stands at height 0.";

export function handles(shape: Shape): readonly Handle[] {
  const rim: Handle = { id: "rim", radial: true, axial: true, why: FREE };
  const foot: Handle = {
    id: "foot",
    radial: true,
    axial: false,
    why: FOOT_HEIGHT,
  };
  switch (shape.kind) {
    case "second-order": {
      const why = "Second order leaves the slope to the equation. Switch to mixed or fourth order to set it.";
      return [rim, fixed("rim-slope", why), fixed("foot-slope", why), foot];
    }
    case "mixed-order":
      return [
        rim,
        {
          id: "rim-slope",
          radial: false,
          axial: true,
          why: "Mixed order sets the rise at the rim, not the lean.",
        },
        fixed("foot-slope", "In mixed order the wall always ends level at the foot."),
        foot,
      ];
    case "fourth-order": {
      const flat = swellOf(shape) === 0;
      const why = flat
        ? "With this belly radius the flares have no effect. Change the belly radius to free them."
        : FREE;
      return [
        rim,
        { id: "rim-slope", radial: !flat, axial: true, why },
        { id: "foot-slope", radial: !flat, axial: true, why },
        foot,
      ];
    }
    case "bloor-wilson":
      return [
        rim,
        { id: "rim-slope", radial: true, axial: true, why: FREE },
        {
          id: "foot-slope",
          radial: true,
          axial: false,
          why: "The dint vase always ends level at the foot.",
        },
        foot,
      ];
    case "boundary-value": {
      const radial = firstHarmonic(shape) !== null;
      const slopes = radial && shape.x.order === 4 && shape.y.order === 4;
      const rise = shape.z.order === 4;
      const point = radial ? FREE : "There is no first harmonic in x and y, so there is no radius to drag.";
      const lean = slopes ? "" : "The lean needs x and y of order 4. ";
      const climb = rise ? "" : "The rise needs z of order 4.";
      const why = (lean + climb).trim();
      return [
        { id: "rim", radial, axial: true, why: point },
        { id: "rim-slope", radial: slopes, axial: rise, why },
        { id: "foot-slope", radial: slopes, axial: rise, why },
        { id: "foot", radial, axial: true, why: point },
      ];
    }
  }
}

function fixed(id: HandleId, why: string): Handle {
  return { id, radial: false, axial: false, why };
}

/** The shape after a handle moved by (`radial`, `axial`); the same shape when the family has no such freedom. */
export function moveHandle<S extends Shape>(shape: S, id: HandleId, radial: number, axial: number): Shape {
  const handle = handles(shape).find((candidate) => candidate.id === id);
  if (!handle) return shape;
  const dr = handle.radial ? radial : 0;
  const dz = handle.axial ? axial : 0;
  if (dr === 0 && dz === 0) return shape;
  return move(shape, id, dr, dz);
}

function move(shape: Shape, id: HandleId, dr: number, dz: number): Shape {
  switch (shape.kind) {
    case "second-order":
    case "mixed-order":
      return movePlanar(filled<SecondOrder | MixedOrder>(shape), id, dr, dz);
    case "fourth-order":
      return moveFourth(shape, id, dr, dz);
    case "bloor-wilson": {
      const { r, R, h, H } = shape;
      if (id === "rim")
        return {
          ...shape,
          r: [add(r[0], dr), r[1], r[2], r[3]],
          h: [add(h[0], dz), h[1]],
        };
      if (id === "foot") return { ...shape, r: [r[0], r[1], r[2], add(r[3], dr)] };
      if (id === "rim-slope")
        return {
          ...shape,
          R: [add(R[0], dr), R[1], R[2], R[3]],
          H: [add(H[0], dz), H[1]],
        };
      return { ...shape, R: [R[0], R[1], R[2], add(R[3], dr)] };
    }
    case "boundary-value":
      return moveModes(shape, id, dr, dz);
  }
}

function movePlanar(shape: SecondOrder | MixedOrder, id: HandleId, dr: number, dz: number): Shape {
  const { r } = shape;
  if (id === "rim")
    return {
      ...shape,
      r: [add(r[0], dr), r[1], r[2], r[3]],
      height: add(shape.height ?? 0, dz),
    };
  if (id === "foot") return { ...shape, r: [r[0], r[1], add(r[2], dr), r[3]] };
  return shape.kind === "mixed-order" && id === "rim-slope" ? { ...shape, rise: add(shape.rise, dz) } : shape;
}

/** `4 rm - r1 - 3 r0`, the factor of both flares (ZY01 equation 13). */
function swellOf(shape: FourthOrder): number {
  return 4 * shape.rm - shape.r1 - 3 * shape.r0;
}

/** Moving an end keeps the slopes: the belly radius follows so that the swell stays as it was. */
function moveFourth(shape: FourthOrder, id: HandleId, dr: number, dz: number): FourthOrder {
  const { eta, dz: rise } = shape;
  if (id === "rim") {
    return {
      ...shape,
      r1: add(shape.r1, dr),
      rm: add(shape.rm, dr / 4),
      h1: add(shape.h1, dz),
    };
  }
  if (id === "foot") return { ...shape, r0: add(shape.r0, dr), rm: add(shape.rm, (3 * dr) / 4) };
  const lean = dr === 0 ? 0 : dr / swellOf(shape);
  const atRim = id === "rim-slope" ? 1 : 0;
  return atRim === rimAt(shape)
    ? {
        ...shape,
        eta: [eta[0], add(eta[1], lean)],
        dz: [rise[0], add(rise[1], dz)],
      }
    : {
        ...shape,
        eta: [add(eta[0], lean), eta[1]],
        dz: [add(rise[0], dz), rise[1]],
      };
}

function firstHarmonic(shape: BoundaryValue): { readonly x: number; readonly y: number } | null {
  const x = shape.x.modes.findIndex((mode) => mode.n === 1 && mode.cos !== undefined);
  const y = shape.y.modes.findIndex((mode) => mode.n === 1 && mode.sin !== undefined);
  return x < 0 || y < 0 ? null : { x, y };
}

function moveModes(shape: BoundaryValue, id: HandleId, dr: number, dz: number): BoundaryValue {
  const atRim = id === "rim" || id === "rim-slope";
  const start = (rimAt(shape) === 0) === atRim;
  const slope = id === "rim-slope" || id === "foot-slope";
  const name = slope ? (start ? "start_u" : "end_u") : start ? "start" : "end";
  const first = firstHarmonic(shape);
  let next = shape;
  if (dr !== 0 && first) {
    // y may run the other way round the axis: its radius grows with the sign it has.
    const x = bump(shape.x, first.x, "cos", name, dr);
    const sense = Math.sign(shape.y.modes[first.y]?.sin?.start ?? 1) || 1;
    next = { ...next, x, y: bump(shape.y, first.y, "sin", name, sense * dr) };
  }
  if (dz !== 0) {
    const level = shape.z.modes.findIndex((mode) => mode.n === 0);
    const z: Component = level < 0 ? { ...shape.z, modes: [{ n: 0, cos: {} }, ...shape.z.modes] } : shape.z;
    next = { ...next, z: bump(z, Math.max(level, 0), "cos", name, dz) };
  }
  return next;
}

function bump(
  component: Component,
  index: number,
  wave: "cos" | "sin",
  name: "start" | "end" | "start_u" | "end_u",
  by: number,
): Component {
  const modes = component.modes.map((mode, i): Mode => {
    if (i !== index) return mode;
    const datum = mode[wave] ?? {};
    return { ...mode, [wave]: { ...datum, [name]: add(datum[name] ?? 0, by) } };
  });
  return { ...component, modes };
}

/** A sum rounded to nine digits: finer than any hand, and the field beside the picture stays readable. */
function add(value: number, by: number): number {
  return by === 0 ? value : Number((value + by).toPrecision(9));
}
