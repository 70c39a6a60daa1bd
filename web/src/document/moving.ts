/** Motions of placed parts: each gives the one placement that a part has after it. Scaled, then turned, then moved, a placement can say every one of them. */

import { UNMOVED, type WholePlacement } from "./placement";
import type { Triple } from "./types";

export type Axis = 0 | 1 | 2;
export const AXES: readonly Axis[] = [0, 1, 2];

/** The real part first. */
export type Quaternion = readonly [w: number, x: number, y: number, z: number];

/** Digits that a document keeps. */
const DIGITS = 12;
/** Rotations that differ from none, or from half a turn, by less are that: the products of a few have errors of this size. */
const NONE = 1e-14;

/** A part moved by so much. */
export function moved(place: WholePlacement, by: Triple): WholePlacement {
  return { ...place, shift: tidied(sum(place.shift, by)) };
}

/** A part turned by an angle (radians, anti-clockwise seen from where the axis points to) about an axis through a point. */
export function turned(place: WholePlacement, axis: Triple, angle: number, about: Triple): WholePlacement {
  const turn = quaternion(axis, angle);
  const arm = rotated(turn, difference(place.shift, about));
  return {
    ...standing(times(turn, quaternion(place.axis, place.angle))),
    scale: place.scale,
    shift: tidied(sum(about, arm)),
  };
}

/** A part made so many times as large, along one of its own axes or along all, so that a point keeps its place. */
export function resized(place: WholePlacement, axis: Axis | null, factor: number, about: Triple): WholePlacement {
  const turn = quaternion(place.axis, place.angle);
  const arm = rotated(inverse(turn), difference(place.shift, about));
  const stretched = arm.map((x, i) => (axis === null || axis === i ? factor * x : x)) as unknown as Triple;
  const scale = place.scale.map((x, i) => (axis === null || axis === i ? round(factor * x) : x)) as unknown as Triple;
  return { ...place, scale, shift: tidied(sum(about, rotated(turn, stretched))) };
}

/**
 * The mirror image of a part in the plane square to an axis of the scene, where that coordinate is `at`. With `H` the reflection and `D` that of the part's own `y`,
 * `H R S = (H R D) (D S)`: the rotation `H R D`, and a scale that is negative along `y` where it was not.
 */
export function mirrored(place: WholePlacement, axis: Axis, at: number): WholePlacement {
  // A reflection is half a turn about its normal, and all turned round: of two of them the latter cancels.
  const half = quaternion(unit(axis), Math.PI);
  const turn = times(times(half, quaternion(place.axis, place.angle)), [0, 0, 1, 0]);
  const [x, y, z] = place.scale;
  const shift = place.shift.map((value, i) => (i === axis ? 2 * at - value : value)) as unknown as Triple;
  return { ...standing(turn), scale: [x, -y, z], shift: tidied(shift) };
}

/** Where one of the part's own axes points to. */
export function ownAxis(place: WholePlacement, axis: Axis): Triple {
  return rotated(quaternion(place.axis, place.angle), unit(axis));
}

export function unit(axis: Axis): Triple {
  return [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
}

export function sum(a: Triple, b: Triple): Triple {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function difference(a: Triple, b: Triple): Triple {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** A vector so many times as long. */
export function scaledBy(factor: number, [x, y, z]: Triple): Triple {
  // No zero has a sign.
  return [factor * x + 0, factor * y + 0, factor * z + 0];
}

/** A number of a document, without the digits of rounding. */
export function round(value: number): number {
  return Number(value.toPrecision(DIGITS)) + 0;
}

/** The same of a point: what is nothing beside its other numbers is 0. */
function tidied(point: Triple): Triple {
  const size = Math.max(...point.map(Math.abs));
  if (size === 0) return [0, 0, 0];
  const last = 10 ** (Math.floor(Math.log10(size)) + 1 - DIGITS);
  return point.map((x) => (Math.abs(x) < last ? 0 : round(x))) as unknown as Triple;
}

/** A rotation as a document has it: an axis of the upper half of all, and an angle from half a turn backwards to less than that forwards. */
function standing([w, x, y, z]: Quaternion): Pick<WholePlacement, "axis" | "angle"> {
  const length = Math.hypot(x, y, z);
  if (length < NONE) return { axis: UNMOVED.axis, angle: 0 };
  const [h, k, l] = [x, y, z].map((each) => (Math.abs(each) < NONE * length ? 0 : round(each / length))) as [
    number,
    number,
    number,
  ];
  const upper = k > 0 || (k === 0 && (h > 0 || (h === 0 && l > 0)));
  const axis: Triple = upper ? [h, k, l] : [0 - h, 0 - k, 0 - l];
  if (Math.abs(w) < NONE) return { axis, angle: -Math.PI };
  const way = upper ? 1 : -1;
  // From -pi to pi, whichever of the two quaternions of a rotation it is.
  return { axis, angle: way * 2 * Math.atan2(Math.sign(w) * length, Math.abs(w)) };
}

export function quaternion(axis: Triple, angle: number): Quaternion {
  const length = Math.hypot(...axis);
  if (length === 0) return [1, 0, 0, 0];
  // Half a turn is exact.
  const [sin, cos] = Math.abs(angle) === Math.PI ? [Math.sign(angle), 0] : [Math.sin(angle / 2), Math.cos(angle / 2)];
  return [cos, (sin * axis[0]) / length, (sin * axis[1]) / length, (sin * axis[2]) / length];
}

/** The rotation `b`, then `a`. */
export function times(a: Quaternion, b: Quaternion): Quaternion {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

function inverse([w, x, y, z]: Quaternion): Quaternion {
  return [w, -x, -y, -z];
}

function rotated(turn: Quaternion, [x, y, z]: Triple): Triple {
  const [, a, b, c] = times(times(turn, [0, x, y, z]), inverse(turn));
  return [a, b, c];
}
