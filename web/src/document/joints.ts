/** Joints: the numbers of placements that are sliders of the scene. What a joint has now stands in the placement alone. */

import { moved, type Quaternion, quaternion, round, times, turned } from "./moving";
import { matrixOf, UNMOVED, type WholePlacement } from "./placement";
import type { Joint, Joints, Part, Triple } from "./types";

export type JointName = keyof Joints & string;
export const JOINT_NAMES: readonly JointName[] = ["x", "y", "z", "turn"];

export const UPRIGHT: Triple = [0, 0, 1];
const TURN = 2 * Math.PI;
/** Numbers that differ by less are the same: far above what rounding leaves, far below what a hand can tell. */
const SLACK = 1e-9;
/** A part that is tipped further from the axis, as `cos(tilt / 2)` squared, is told from where it lies upside down: beside half a turn across, a turn about the axis cannot be told. */
const TIPPED = 0.2;

/** The coordinate that a joint moves along; null of a turn. */
export function alongOf(name: JointName): 0 | 1 | 2 | null {
  return name === "x" ? 0 : name === "y" ? 1 : name === "z" ? 2 : null;
}

/** What a joint has now: a coordinate, or the radians about its axis, of which those are told that are nearest to the middle of its limits. */
export function jointValue(part: Part, name: JointName, joint: Joint): number {
  const place = { ...UNMOVED, ...part.place };
  const along = alongOf(name);
  if (along !== null) return place.shift[along];
  const axis = joint.axis ?? UPRIGHT;
  const turn = quaternion(place.axis, place.angle);
  const value = (own: Quaternion) => nearTo(joint.limits, about(times(turn, own), axis));
  const now = value([1, 0, 0, 0]);
  if (isWithin(joint, now)) return now;
  // Of the placements in which an octant is the same solid a link has one, which need not be that in which it was turned.
  return (
    alike(part, place)
      .map(value)
      .find((other) => isWithin(joint, other)) ?? now
  );
}

export function isWithin({ limits }: Joint, value: number): boolean {
  const slack = SLACK * Math.max(...limits.map(Math.abs));
  return value >= limits[0] - slack && value <= limits[1] + slack;
}

/** Where something stands after a joint of a part at `pivot` went by so much. */
export function goneBy(
  place: WholePlacement,
  name: JointName,
  joint: Joint,
  by: number,
  pivot: Triple,
): WholePlacement {
  const along = alongOf(name);
  if (along === null) return turned(place, joint.axis ?? UPRIGHT, by, pivot);
  return moved(place, [0, 1, 2].map((axis) => (axis === along ? by : 0)) as unknown as Triple);
}

/**
 * The joints of a part that was put elsewhere by anything but them: what they have stands within their limits as it did. A shift goes on along the axis of the scene that its own became, where it
 * became one; the axis of a turn goes along with the part.
 */
export function carried(joints: Joints, before: WholePlacement, after: WholePlacement): Joints {
  const motion = motionBetween(before, after);
  if (!motion) return joints;
  const shifts: { -readonly [K in JointName]?: Joint } = {};
  for (const name of JOINT_NAMES) {
    const [from, joint] = [alongOf(name), joints[name]];
    if (from === null || !joint) continue;
    const image = motion.map((row) => row[from]) as unknown as Triple;
    const to = image.findIndex((x) => Math.abs(x) > 1 - SLACK);
    const into = to < 0 ? from : to;
    const way = to < 0 ? 1 : Math.sign(image[into] as number);
    const [was, is] = [before.shift[from], after.shift[into] as number];
    const ends = joint.limits.map((limit) => round(is + way * (limit - was)));
    shifts[JOINT_NAMES[into] as JointName] = { ...joint, limits: pair(way > 0 ? ends : ends.toReversed()) };
  }
  const { turn } = joints;
  return { ...inOrder(shifts), ...(turn && { turn: turnCarried(turn, motion, before, after) }) };
}

function turnCarried(turn: Joint, motion: readonly Triple[], before: WholePlacement, after: WholePlacement): Joint {
  const was = turn.axis ?? UPRIGHT;
  const handedness = determinant(motion);
  const axis = motion.map((row) => tidy(handedness * dot(row, was))) as unknown as Triple;
  const value = (place: WholePlacement, about_: Triple) => about(quaternion(place.axis, place.angle), about_);
  const change = value(after, axis) - value(before, was);
  const middle = (turn.limits[0] + turn.limits[1]) / 2 + change;
  const by = change - TURN * Math.round(middle / TURN);
  const limits = Math.abs(by) < SLACK ? turn.limits : pair(turn.limits.map((limit) => round(limit + by)));
  return { ...turn, limits, axis };
}

/** How far a rotation turns about an axis: twice the angle of `(w, axis . v)` of its quaternion. What then turns about the axis adds to it, whatever came before. */
function about(turn: Quaternion, axis: Triple): number {
  const length = Math.hypot(...axis);
  const [h, k, l] = [axis[0] / length, axis[1] / length, axis[2] / length];
  const told = ([w, x, y, z]: Quaternion) => [w, h * x + k * y + l * z] as const;
  let [w, along] = told(turn);
  if (w * w + along * along < TIPPED) [w, along] = told(times(turn, [0, ...across([h, k, l])]));
  const angle = 2 * Math.atan2(along, w);
  return angle - TURN * Math.ceil(angle / TURN - 0.5 - SLACK);
}

/** The one direction square to an axis that is nearest to the coordinate axis which is least along it. */
function across(axis: Triple): Triple {
  const sizes = axis.map(Math.abs);
  const least = sizes.indexOf(Math.min(...sizes));
  const share = axis[least] as number;
  const square = axis.map((x, i) => (i === least ? 1 : 0) - share * x) as unknown as Triple;
  const length = Math.hypot(...square);
  return square.map((x) => x / length) as unknown as Triple;
}

/** The angle among those that turn alike that is nearest to the middle of the limits; of two the lesser. */
function nearTo([least, most]: Joint["limits"], angle: number): number {
  return angle + TURN * Math.ceil(((least + most) / 2 - angle) / TURN - 0.5 - SLACK);
}

/** The turns before its own after which an octant is what it is: its edges in another order, and one of them turned round where that takes a mirror image. */
function alike(part: Part, place: WholePlacement): readonly Quaternion[] {
  const [x, y, z] = place.scale;
  if (part.shape.kind !== "octant" || x < 0 || z < 0) return [];
  const orders = [
    [1, 2, 0],
    [2, 0, 1],
    [1, 0, 2],
    [0, 2, 1],
    [2, 1, 0],
  ] as const;
  return orders.map((order, at) => {
    const isOdd = at > 1;
    const [before, after] = [y < 0, y < 0 !== isOdd];
    const entry = (row: number, column: number) =>
      (order[column] === row ? 1 : 0) * (before && row === 1 ? -1 : 1) * (after && column === 1 ? -1 : 1);
    return ofRotation([0, 1, 2].map((row) => [entry(row, 0), entry(row, 1), entry(row, 2)]));
  });
}

/** The quaternion of a rotation whose matrix has nothing but 0, 1 and -1 in it. */
function ofRotation(rows: readonly (readonly number[])[]): Quaternion {
  const m = (i: number, j: number) => rows[i]?.[j] ?? 0;
  const forms: readonly Quaternion[] = [
    [1 + m(0, 0) + m(1, 1) + m(2, 2), m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)],
    [m(2, 1) - m(1, 2), 1 + m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)],
    [m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 - m(0, 0) + m(1, 1) - m(2, 2), m(1, 2) + m(2, 1)],
    [m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 - m(0, 0) - m(1, 1) + m(2, 2)],
  ];
  const size = (form: Quaternion) => Math.hypot(...form);
  const best = forms.reduce((one, other) => (size(other) > size(one) ? other : one));
  const length = size(best);
  return best.map((x) => x / length) as unknown as Quaternion;
}

/** The rows of what takes directions of a part before to those after; null where both are the same placement, or one is none. */
function motionBetween(before: WholePlacement, after: WholePlacement): readonly Triple[] | null {
  const [one, other] = [matrixOf(before), matrixOf(after)];
  if (!one || !other || one.every((x, at) => x === other[at])) return null;
  const column = (matrix: readonly number[], at: number): Triple => {
    const [x, y, z] = matrix.slice(4 * at, 4 * at + 3) as [number, number, number];
    const length = Math.hypot(x, y, z);
    return [x / length, y / length, z / length];
  };
  const pairs = [0, 1, 2].map((at) => [column(one, at), column(other, at)] as const);
  const row = (i: number): Triple =>
    [0, 1, 2].map((j) =>
      pairs.reduce((total, [from, to]) => total + (to[i] as number) * (from[j] as number), 0),
    ) as unknown as Triple;
  return [row(0), row(1), row(2)];
}

function determinant(rows: readonly Triple[]): number {
  const [a, b, c] = rows as [Triple, Triple, Triple];
  const cross: Triple = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
  return Math.sign(dot(a, cross));
}

function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** What rounding left of none, of one and of all else. */
function tidy(x: number): number {
  const whole = Math.round(x);
  return Math.abs(x - whole) < 1e-12 ? whole + 0 : round(x);
}

function pair(limits: readonly number[]): Joint["limits"] {
  return [limits[0] as number, limits[1] as number];
}

function inOrder(joints: Joints): Joints {
  return Object.fromEntries(JOINT_NAMES.flatMap((name) => (joints[name] ? [[name, joints[name]]] : [])));
}

/** Joints, or nothing where none is left. */
export function briefJoints(joints: Joints): Joints | undefined {
  const all = inOrder(joints);
  return Object.keys(all).length > 0 ? all : undefined;
}

/** Limits about a number: from it upwards, or as far to both sides. */
export function limitsAbout(name: JointName, value: number, reach: number): Joint["limits"] {
  if (name === "turn") return [round(value - Math.PI / 2), round(value + Math.PI / 2)];
  return name === "z" ? [value, round(value + reach)] : [round(value - reach), round(value + reach)];
}
