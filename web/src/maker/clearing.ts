/** Where parts have to go so that they no longer run into others, or so that they touch one: found by asking whether the scene keeps its constraints there, not by meshes. */

import { constraints, pick } from "pasu";
import { difference, moved, scaledBy } from "../document/moving";
import { UNMOVED } from "../document/placement";
import type { Breach, Design, Part, Sent, Triple } from "../document/types";

/** A way out: some parts go so far in a direction at most, where these others may be in their way. */
export interface Way {
  readonly moving: readonly number[];
  /** A unit vector. */
  readonly towards: Triple;
  readonly far: number;
  readonly others: readonly number[];
}

/** The first of some ways on which parts come clear of all others, and no further than they have to. */
export interface ApartAsk {
  readonly kind: "apart";
  readonly design: Design;
  readonly ways: readonly Way[];
}

/** How far parts that hang together have to go for one of them to touch another part, from a place of theirs towards a place within the other. */
export interface TogetherAsk {
  readonly kind: "together";
  readonly design: Design;
  readonly group: readonly number[];
  readonly other: number;
  readonly from: Triple;
  readonly to: Triple;
  /** How large the part is that is next to the other. */
  readonly size: number;
}

/** Which parts have to go where. */
export interface Move {
  readonly moving: readonly number[];
  readonly by: Triple;
}

/** How exact the way is, as a share of the longest that was tried. */
const EXACT = 1e-3;
/** How far a part may go beyond where a place of it meets the other, as shares of its size: surfaces that only just touch are hard to tell from such that do not, flat ones most of all. */
const BEYOND = [1e-3, 0.01, 0.04, 0.15, 0.3];

/** What of two parts is no distance between them. */
const TOGETHER = ["interference", "within", "same-place", "contact", "undecided-interference", "undecided-within"];
/** What is said of parts that hang together and of which nobody knows that they touch the others. */
const LOOSE = ["not-connected", "undecided-connection"];
/** What of two parts of one object is no good joint. */
const LOST = ["within", "undecided-within", "same-place"];

/** Null where none of the ways leads out. */
export function apart({ design, ways }: ApartAsk): Move | null {
  for (const { moving, towards, far, others } of ways) {
    const isClear = (by: number) => {
      const parts = [...placed(design, moving, scaledBy(by, towards)), ...placed(design, others, [0, 0, 0])];
      const { breaches, leftOut } = constraints(sceneOf(design, parts));
      const isOurs = (part: number) => part < moving.length;
      return (
        leftOut === 0 &&
        breaches.every(({ code, part, other }) => !TOGETHER.includes(code) || isOurs(part) === isOurs(other))
      );
    };
    if (isClear(far)) return { moving, by: scaledBy(least(isClear, far), towards) };
  }
  return null;
}

/** Null where they meet the other nowhere on that way. */
export function together({ design, group, other, from, to, size }: TogetherAsk): Move | null {
  const way = difference(to, from);
  const length = Math.hypot(...way);
  if (!(length > 0)) return null;
  const towards = scaledBy(1 / length, way);
  const [there] = placed(design, [other], [0, 0, 0]);
  if (!there) return null;
  const [hit] = pick(sceneOf(design, [there]), { origin: [...from], direction: [...towards] });
  if (!hit) return null;
  const touches = (by: number) => {
    const glued = [...placed(design, group, scaledBy(by, towards)), there].map((each) => ({ ...each, object: 0 }));
    const { breaches, leftOut } = constraints(sceneOf(design, glued));
    const last = glued.length - 1;
    const isLost = breaches.some(({ code, part, other: of }) => LOST.includes(code) && (part === last || of === last));
    return leftOut === 0 && !isLost && hangTogether(breaches, last, glued.length) > 1;
  };
  const far = BEYOND.map((share) => hit.distance + share * size).find(touches);
  return far === undefined ? null : { moving: group, by: scaledBy(least(touches, far), towards) };
}

/** With how many parts of a scene of one object a part hangs together, itself among them: with those of its group, or else with all that are in none. */
function hangTogether(breaches: readonly Breach[], part: number, count: number): number {
  const groups = breaches.filter(({ code }) => LOOSE.includes(code)).map(({ group }) => group);
  const own = groups.find((group) => group.includes(part));
  return own ? own.length : groups.reduce((left, group) => left - group.length, count);
}

/** The least number up to `far` of which it is true, to within a share of that, rounded upwards. It is true of `far`, and taken for false at 0. */
function least(isTrue: (by: number) => boolean, far: number): number {
  let [no, yes] = [0, far];
  while (yes - no > EXACT * far) {
    const middle = (no + yes) / 2;
    if (isTrue(middle)) yes = middle;
    else no = middle;
  }
  const last = 10 ** Math.floor(Math.log10(EXACT * far));
  const rounded = Number((Math.ceil(yes / last) * last).toPrecision(6));
  return rounded < far && isTrue(rounded) ? rounded : yes;
}

function placed(design: Design, places: readonly number[], by: Triple): readonly Part[] {
  return places.flatMap((place) => {
    const part = design.parts[place];
    return part ? [{ ...part, place: moved({ ...UNMOVED, ...part.place }, by) }] : [];
  });
}

function sceneOf({ pasu, unit }: Design, parts: readonly Part[]): Sent {
  return { pasu, ...(unit && { unit }), parts } as Sent;
}
