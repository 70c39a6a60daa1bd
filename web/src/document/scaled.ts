/**
 * The same design in another size. Every equation is linear, so that a shape grows by a factor when all its lengths, slopes and forces do; what has no length (waves, weights of the
 * equation, flares as shares of the swell) stays.
 */

import { filled } from "./kinds";
import { DEFAULTS, UNITS as MILLIMETRES } from "./tables.gen";
import type { Component, Design, MixedOrder, Mode, Part, Placement, SecondOrder, Shape, Unit, Wall } from "./types";

/** Digits that a number of a document keeps: those of canonical form. */
const DIGITS = 12;

/** Whether walls grow with the shape or stay as thick as they were said to be. */
export type Walls = "scale" | "stay";

/** The design `factor` times as large. */
export function scaled(design: Design, factor: number, walls: Walls): Design {
  return { ...design, parts: design.parts.map((part) => partBy(part, factor, walls)) };
}

/** The same pot with its numbers in another unit. */
export function inUnit(design: Design, unit: Unit): Design {
  const before = design.unit ?? DEFAULTS.unit;
  return before === unit ? design : { ...scaled(design, MILLIMETRES[before] / MILLIMETRES[unit], "scale"), unit };
}

function partBy(part: Part, factor: number, walls: Walls): Part {
  const { shape, place, wall } = part;
  return {
    ...part,
    shape: shapeBy(shape, factor),
    ...(place && { place: placeBy(place, factor) }),
    ...(wall && walls === "scale" && { wall: wallBy(wall, factor) }),
  };
}

function by(value: number, factor: number): number {
  return Number((value * factor).toPrecision(DIGITS));
}

/** A list of numbers, as long as it was. */
function all<T extends readonly number[]>(values: T, factor: number): T {
  return values.map((value) => by(value, factor)) as unknown as T;
}

export function shapeBy(shape: Shape, factor: number): Shape {
  switch (shape.kind) {
    case "second-order":
      return planarBy(shape, factor);
    case "mixed-order":
      return { ...planarBy(shape, factor), rise: by(shape.rise, factor) };
    case "fourth-order": {
      const { r0, r1, rm, h1, dz } = shape;
      return {
        ...shape,
        r0: by(r0, factor),
        r1: by(r1, factor),
        rm: by(rm, factor),
        h1: by(h1, factor),
        dz: all(dz, factor),
      };
    }
    case "bloor-wilson": {
      const { r, R, h, H } = shape;
      return { ...shape, r: all(r, factor), R: all(R, factor), h: all(h, factor), H: all(H, factor) };
    }
    case "boundary-value":
      return {
        ...shape,
        x: componentBy(shape.x, factor),
        y: componentBy(shape.y, factor),
        z: componentBy(shape.z, factor),
      };
  }
}

/** A height that the document leaves out is that of the paper, and has to be written out when it changes. */
function planarBy<S extends SecondOrder | MixedOrder>(shape: S, factor: number): S {
  const { r, height, force } = filled(shape);
  return {
    ...shape,
    r: all(r, factor),
    ...(height !== undefined && { height: by(height, factor) }),
    ...(force && { force: all(force, factor) }),
  };
}

function componentBy(component: Component, factor: number): Component {
  const modes = component.modes.map((mode: Mode) => ({
    ...mode,
    ...(mode.cos && { cos: datumBy(mode.cos, factor) }),
    ...(mode.sin && { sin: datumBy(mode.sin, factor) }),
  }));
  return { ...component, modes };
}

/** All that a datum says is a length, a slope along `u`, or a force: each grows alike. */
function datumBy<D extends object>(datum: D, factor: number): D {
  const entries = Object.entries(datum).map(([name, value]: [string, number | readonly number[]]) => [
    name,
    typeof value === "number" ? by(value, factor) : all(value, factor),
  ]);
  return Object.fromEntries(entries) as D;
}

function placeBy(place: Placement, factor: number): Placement {
  return place.shift ? { ...place, shift: all(place.shift, factor) } : place;
}

function wallBy(wall: Wall, factor: number): Wall {
  const { thickness, base, foot, drain } = wall;
  return {
    ...wall,
    thickness: by(thickness, factor),
    base: by(base, factor),
    ...(foot && { foot: all(foot, factor) }),
    ...(drain !== undefined && { drain: by(drain, factor) }),
  };
}
