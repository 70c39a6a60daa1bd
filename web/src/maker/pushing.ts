/** A part pushed into the wall of another: as far as all of what faces it close by is in the clay, and no further than through the wall. Asked along rays of the exact surfaces. */

import { constraints, PasuError, pick } from "pasu";
import { roundTo } from "../document/boxes";
import { scaledBy } from "../document/moving";
import type { Design, Sent, Triple } from "../document/types";
import type { Move } from "./clearing";

export interface PushAsk {
  readonly kind: "push";
  readonly design: Design;
  readonly moving: readonly number[];
  readonly onto: number;
  /** A unit vector. */
  readonly towards: Triple;
  /** So far back from where it is, it is clear of the other for certain. */
  readonly back: number;
  /** Points of what moves that go first, where they are. */
  readonly points: readonly Triple[];
  /** How large what moves is. */
  readonly size: number;
}

export interface Pushed extends Move {
  /** Whether all of what faces the wall close by is in it. */
  readonly isSet: boolean;
}

/** What is further from the wall than this when the first point meets it, as a share of the size, is not what is set into it. */
const CLOSE = 0.2;
/** In a solid, or a thick wall, it goes so far in beyond the last point, as a share of the size. */
const IN = 0.02;
/** Where not all goes in, so much of the wall stays before it comes through. */
const LEFT = 0.25;

/** The last digit of how far it goes, as a share of the size: points of meshes have no more, and what is pushed again stays. */
const LAST = 1e-4;

/** So much nearer to their middle rays are asked than points are, as a share: two pots on one table have their feet, and equal ones their rims, in planes along which a ray tells nothing. */
const WITHIN = 1e-4;

/** What joins parts of one object too little. */
const LOOSE = ["not-connected", "undecided-connection"];

/** Null where it meets the other nowhere on its way. */
export function push({ design, moving, onto, towards, back, points, size }: PushAsk): Pushed | null {
  const [other] = design.parts.slice(onto, onto + 1);
  if (!other) return null;
  const alone = { pasu: design.pasu, parts: [other] } as Sent;
  const middle = middleOfAll(points);
  const walls = points.flatMap((point) => {
    const off = point.map((x, axis) => WITHIN * ((middle[axis] as number) - x));
    const on = off.reduce((sum, x, axis) => sum + x * (towards[axis] as number), 0);
    const origin = point.map((x, axis) => x + (off[axis] as number) - (back + on) * (towards[axis] as number));
    const [first, second] = hitsOf(alone, origin as [number, number, number], towards);
    return first ? [{ near: first.distance, far: second?.distance ?? first.distance }] : [];
  });
  const nearest = Math.min(...walls.map(({ near }) => near));
  if (!Number.isFinite(nearest)) return null;
  const close = walls.filter(({ near }) => near <= nearest + CLOSE * size);
  const last = Math.max(...close.map(({ near }) => near));
  const through = Math.min(...close.map(({ far }) => far));
  const isSet = last < through;
  const far = isSet ? last + Math.min((through - last) / 2, IN * size) : through - LEFT * (through - nearest);
  // Of a surface without a thickness there is one hit: it is touched.
  const by = roundTo(Math.max(far, nearest) - back, 10 ** Math.floor(Math.log10(LAST * size)));
  const move = { moving, by: scaledBy(by, towards), isSet };
  return joins(design, move, onto) ? move : null;
}

/** Where a ray meets the other; nowhere where it goes along its surface, which says nothing of how far the point can go. */
function hitsOf(alone: Sent, origin: [number, number, number], [x, y, z]: Triple): ReturnType<typeof pick> {
  try {
    return pick(alone, { origin, direction: [x, y, z] });
  } catch (error) {
    if (error instanceof PasuError && error.code === "too-large") return [];
    throw error;
  }
}

function middleOfAll(points: readonly Triple[]): Triple {
  const sum = (axis: number) => points.reduce((all, point) => all + (point[axis] as number), 0);
  return [0, 1, 2].map((axis) => sum(axis) / points.length) as unknown as Triple;
}

/** Whether everything that moved touches the other, directly or by the rest. */
function joins(design: Design, { moving, by }: Move, onto: number): boolean {
  const parts = [...moving, onto].flatMap((place) => {
    const part = design.parts[place];
    if (!part) return [];
    const shift = part.place?.shift ?? [0, 0, 0];
    const to = place === onto ? shift : shift.map((x, axis) => x + (by[axis] as number));
    return [{ ...part, name: undefined, object: 0, place: { ...part.place, shift: to } }];
  });
  const scene = { pasu: design.pasu, parts: parts.map(({ name: _, ...part }) => part) } as unknown as Sent;
  return constraints(scene).breaches.every(({ code }) => !LOOSE.includes(code));
}
