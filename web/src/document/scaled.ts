/**
 * The same design in another size. Every equation is linear, so that a shape grows by a factor when all its lengths, slopes and forces do; what has no length (waves, weights of the
 * equation, flares as shares of the swell) stays.
 */

import { FAMILIES } from "./families.gen";
import type { Field } from "./field";
import { filled } from "./kinds";
import { getPath, numberAt, setPath } from "./path";
import { DEFAULTS, UNITS as MILLIMETRES } from "./tables.gen";
import type {
  Blend,
  Component,
  Design,
  Joints,
  Mode,
  Part,
  Placement,
  Rings,
  Section,
  Series,
  Shape,
  Unit,
  VertexFrame,
  Wall,
} from "./types";

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
  const { shape, place, wall, joints } = part;
  // An octant has no length of its own: it is as large as its placement makes it.
  const reach = joints && { joints: jointsBy(joints, factor) };
  if (shape.kind === "octant") return { ...part, ...reach, place: grownBy(place ?? {}, factor) };
  return {
    ...part,
    ...reach,
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
  if (shape.kind === "rings") return ringsBy(shape, factor);
  if (shape.kind === "vertex-frame") return networkBy(shape, factor);
  if (shape.kind === "blend") return blendBy(shape, factor);
  if (shape.kind === "octant") return shape;
  if (shape.kind !== "boundary-value") return familyBy(shape, FAMILIES[shape.kind].fields, factor);
  return {
    ...shape,
    x: componentBy(shape.x, factor),
    y: componentBy(shape.y, factor),
    z: componentBy(shape.z, factor),
  };
}

/** What the tables call a length grows, and so does a force, which is what it moves the wall by. */
function familyBy<S extends Shape>(shape: S, fields: readonly Field[], factor: number): S {
  const whole = filled(shape);
  let grown = shape;
  for (const { path, dimension, group } of fields) {
    if (dimension !== "length" && group !== "force") continue;
    const [key] = path;
    // What the document leaves out is that of the paper, and has to be written out when it changes.
    if (key !== undefined && getPath(grown, [key]) === undefined) grown = setPath(grown, [key], getPath(whole, [key]));
    grown = setPath(grown, path, by(numberAt(whole, path, 0), factor));
  }
  return grown;
}

/** Radii, heights and slopes grow; where rings are along the profile stays. */
function ringsBy(shape: Rings, factor: number): Rings {
  const grown = <C extends { readonly r: Series; readonly z: Series }>(curve: C): C => ({
    ...curve,
    r: seriesBy(curve.r, factor),
    z: seriesBy(curve.z, factor),
  });
  const { foot, rim } = shape;
  return {
    ...shape,
    rings: shape.rings.map(grown),
    ...(foot && { foot: grown(foot) }),
    ...(rim && { rim: grown(rim) }),
  };
}

/** Points move, and forces are what they move the surface by; the parameters of a patch are shares of it. */
function networkBy(shape: VertexFrame, factor: number): VertexFrame {
  const patches = shape.patches.map(({ forces, ...patch }) => ({
    ...patch,
    ...(forces && { forces: forces.map((force) => ({ ...force, f0: all(force.f0, factor) })) }),
  }));
  return { ...shape, vertices: shape.vertices.map((at) => all(at, factor)), patches };
}

/** A taper is a share of the position. */
function blendBy(shape: Blend, factor: number): Blend {
  const section = (given: Section): Section => {
    const level = { z: by(given.z, factor), dz: by(given.dz, factor) };
    if (given.form !== "outline") return { ...given, ...level, radius: all(given.radius, factor) };
    const series = (harmonics: typeof given.x) =>
      harmonics.map(({ n, cos, sin }) => ({
        n,
        ...(cos !== undefined && { cos: by(cos, factor) }),
        ...(sin !== undefined && { sin: by(sin, factor) }),
      }));
    return { ...given, ...level, x: series(given.x), y: series(given.y) };
  };
  return { ...shape, start: section(shape.start), end: section(shape.end) };
}

function seriesBy({ mean, waves }: Series, factor: number): Series {
  const grown = waves?.map(({ n, cos, sin }) => ({
    n,
    ...(cos !== undefined && { cos: by(cos, factor) }),
    ...(sin !== undefined && { sin: by(sin, factor) }),
  }));
  return { mean: by(mean, factor), ...(grown && { waves: grown }) };
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

function grownBy(place: Placement, factor: number): Placement {
  return { ...placeBy(place, factor), scale: all(place.scale ?? [1, 1, 1], factor) };
}

function placeBy(place: Placement, factor: number): Placement {
  return place.shift ? { ...place, shift: all(place.shift, factor) } : place;
}

/** Turns are no lengths. */
function jointsBy(joints: Joints, factor: number): Joints {
  const along = Object.entries(joints).map(([name, joint]) => [
    name,
    name === "turn" ? joint : { ...joint, limits: all(joint.limits, factor) },
  ]);
  return Object.fromEntries(along);
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
