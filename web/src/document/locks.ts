/** What of a pot stays while a hand pulls it, as a potter thinks of it: groups of a family's numbers, or ends of a pot of rings, and what that holds. */

import { curvesOf, curveUnder, pointOn, spanOf } from "./curves";
import { pathText } from "./path";
import { familyOf } from "./schema";
import type { BoundaryValue, Rings, Shape } from "./types";

/** Those that numbers say. */
export const LOCKS = ["rim", "foot", "height"] as const;

/** How the wall leaves the foot and comes to the rim, of what has rings. What a pot holds is no number of it: its height makes up for what the hand does, or the width of other rings. */
const ALL = [...LOCKS, "slopes", "capacity"] as const;

/** What a pull is told that leaves the slopes at both ends as they are. The solver has no name for it: they are given to it before. */
export const SLOPES = "slopes";

export type Lock = (typeof ALL)[number];

/** Those that a shape has numbers for; what it holds, of a pot of rings with a wall. */
export function locksOf(shape: Shape, walled: boolean): readonly Lock[] {
  if (shape.kind === "rings" && walled) return ALL;
  if (shape.kind === "rings" || shape.kind === "boundary-value") return [...LOCKS, SLOPES];
  const fields = familyOf(shape.kind)?.fields ?? [];
  return LOCKS.filter((lock) => fields.some(({ group }) => group === lock));
}

/** What stays of a shape that is pulled at `u`, by the names of the solver. Of what has rings that is what its end may not do, and the slopes: the other rings stay as they are. */
export function keptBy(shape: Shape, locked: readonly Lock[], u: number): readonly string[] {
  if (shape.kind === "rings" || shape.kind === "boundary-value") {
    const slopes = locked.includes(SLOPES) ? [SLOPES] : [];
    return [...keptOfEnd(shape, locked, endUnder(shape, u)), ...slopes];
  }
  const fields = familyOf(shape.kind)?.fields ?? [];
  return fields.filter(({ group }) => locked.some((lock) => lock === group)).map(({ path }) => pathText(path));
}

function keptOfEnd({ kind }: Shape, locked: readonly Lock[], end: "foot" | "rim" | null): readonly string[] {
  if (end === null) return [];
  if (locked.includes(end)) return kind === "rings" ? ["r", "z", "v"] : ["x", "y", "z"];
  return locked.includes("height") ? ["z"] : [];
}

/** What makes up for what a hand does to what a pot holds: how high or how wide some of its rings are, by their numbers. */
export interface MakingUp {
  readonly along: "r" | "z";
  readonly rings: readonly number[];
}

/** How high the pot is above its foot, where that is free; else how wide rings are that neither the hand at `u` nor a lock is on. */
export function makingUp(shape: Rings, locked: readonly Lock[], u: number): MakingUp {
  const all = [...shape.rings.keys()];
  const last = shape.rings.length - 1;
  if (!locked.includes("height") && !locked.includes("rim")) return { along: "z", rings: all.slice(1) };
  const under = curveUnder(shape, u)?.index;
  const free = (index: number) =>
    index !== under && !(index === 0 && locked.includes("foot")) && !(index === last && locked.includes("rim"));
  return { along: "r", rings: all.filter(free) };
}

function endUnder(shape: Rings | BoundaryValue, u: number): "foot" | "rim" | null {
  const curve = curveUnder(shape, u);
  if (!curve?.end) return null;
  return (curve.index === 0) === beginsAtFoot(shape) ? "foot" : "rim";
}

/** Rings begin at the foot; data that are written out begin at either end. */
function beginsAtFoot(shape: Rings | BoundaryValue): boolean {
  const last = curvesOf(shape).length - 1;
  const height = (index: number) => {
    const span = spanOf(shape);
    return [0, 0.25, 0.5, 0.75].reduce((sum, share) => sum + (pointOn(shape, index, share * span)?.[2] ?? 0), 0);
  };
  return shape.kind === "rings" || height(0) <= height(last);
}

/** The same with one more locked, or no longer. */
export function withLock(locked: readonly Lock[], lock: Lock, on: boolean): readonly Lock[] {
  return ALL.filter((each) => (each === lock ? on : locked.includes(each)));
}
