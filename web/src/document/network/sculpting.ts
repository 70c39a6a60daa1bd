/** Regions that forces push: how far, where on the patches, and what a rectangle is that a hand draws across several of them. */

import type { Pair, Triple } from "../types";
import { edgesOf, keyOf, type Network, type Patch, sideOf } from "./network";
import { pointOn } from "./surface";

export type Force = NonNullable<Patch["forces"]>[number];

const UNIT: Pair = [0, 1];
const ONES: Triple = [1, 1, 1];
/** A patch has no more forces. */
export const MOST_FORCES = 64;
/** A region is no narrower. */
const NARROWEST = 0.05;
/** So many patches away a region may reach. */
const REACH = 3;
const DIGITS = 6;

/** A patch beside another one, and where its unit square lies from the other's. */
export interface Unfolded {
  readonly patch: number;
  readonly origin: Pair;
  readonly along: Pair;
  readonly across: Pair;
}

/** How far a force moves the surface at its crest. */
export function heightOf({ a1 = ONES, a2 = ONES }: Patch, { f0 }: Force): Triple {
  const one = (axis: 0 | 1 | 2) => {
    const under = Math.PI ** 2 * (a1[axis] + a2[axis]);
    return under === 0 ? 0 : -f0[axis] / under;
  };
  return [one(0), one(1), one(2)];
}

/** The force that moves it so far. */
export function forceFor({ a1 = ONES, a2 = ONES }: Patch, height: Triple): Triple {
  const exact = (axis: 0 | 1 | 2) => -height[axis] * Math.PI ** 2 * (a1[axis] + a2[axis]);
  const most = Math.max(...([0, 1, 2] as const).map((axis) => Math.abs(exact(axis))));
  // Beside the others it is rounding.
  const one = (axis: 0 | 1 | 2) =>
    Math.abs(exact(axis)) < 1e-6 * most ? 0 : Number(exact(axis).toPrecision(DIGITS)) + 0;
  return [one(0), one(1), one(2)];
}

/** The patch and those round it, laid flat: the nearest first. */
export function unfolded(network: Network, patch: number): readonly Unfolded[] {
  const found: Unfolded[] = [{ patch, origin: [0, 0], along: [1, 0], across: [0, 1] }];
  const cells = new Set(["0 0"]);
  let level: readonly Unfolded[] = found.slice();
  for (let step = 0; step < REACH; step += 1) {
    const next: Unfolded[] = [];
    for (const from of level) {
      for (let side = 0; side < 4; side += 1) {
        const beside = across(network, from, side);
        if (!beside) continue;
        const cell = cellOf(beside).join(" ");
        if (cells.has(cell)) continue;
        cells.add(cell);
        next.push(beside);
      }
    }
    found.push(...next);
    level = next;
  }
  return found;
}

/** Whether one patch is so near to another that a region may go on to it, laid flat or not: round a corner of five patches two would lie in one place. */
export function isWithinReach(network: Network, from: number, to: number): boolean {
  const reached = new Set([from]);
  for (let step = 0; step < REACH; step += 1) {
    for (const patch of [...reached]) {
      for (let side = 0; side < 4; side += 1) {
        const key = keyOf(sideOf((network.patches[patch] as Patch).frame, side));
        for (const beside of edgesOf(network).get(key)?.sides ?? []) reached.add(beside.patch);
      }
    }
  }
  return reached.has(to);
}

/** Whether the rectangle of a force can lie flat on the patches that it reaches: round a corner at which not four of them meet it cannot, and is refused by the solver. */
export function liesFlat(network: Network, patch: number, region: Pick<Force, "u" | "v">): boolean {
  return laidOut(network, patch, region) !== null;
}

/** The patches that have a region in common because it goes over edges, with the one that it is a force of; none where it stays on that. */
export function sharedBy(network: Network, patch: number, region: Pick<Force, "u" | "v">): ReadonlySet<number> {
  const { u = UNIT, v = UNIT } = region;
  if ([...u, ...v].every((each) => each >= 0 && each <= 1)) return new Set();
  const laid = laidOut(network, patch, region);
  return new Set(laid && laid.size > 1 ? [...laid.values()].map((each) => each.patch) : []);
}

/** The patches that the rectangle of a force reaches, by their places in its plane; null where it cannot lie flat. */
function laidOut(
  network: Network,
  patch: number,
  { u = UNIT, v = UNIT }: Pick<Force, "u" | "v">,
): ReadonlyMap<string, Unfolded> | null {
  const home: Unfolded = { patch, origin: [0, 0], along: [1, 0], across: [0, 1] };
  const laid = new Map([["0 0", home]]);
  // What is laid meanwhile comes in its turn.
  for (const from of laid.values()) {
    const [x, y] = cellOf(from);
    for (let side = 0; side < 4; side += 1) {
      const beside = across(network, from, side);
      if (!beside) continue;
      const [left, low] = cellOf(beside);
      const goesOn = left < x ? u[0] < x : left > x ? u[1] > left : low < y ? v[0] < y : v[1] > low;
      if (!goesOn) continue;
      const cell = `${left} ${low}`;
      const known = laid.get(cell);
      if (known && !liesAlike(known, beside)) return null;
      laid.set(cell, known ?? beside);
    }
  }
  return laid;
}

/** Where a point of the unit square of the first patch lies. */
export function laidAt({ origin, along, across }: Unfolded, u: number, v: number): Pair {
  return [origin[0] + u * along[0] + v * across[0], origin[1] + u * along[1] + v * across[1]];
}

/** What of a force may come to lie on a patch, and how that patch is laid out from the one that has it. */
interface Push {
  readonly laid: Unfolded;
  readonly force: Force;
  readonly height: Triple;
}

const pushed = new WeakMap<Network["patches"], ReadonlyMap<number, readonly Push[]>>();

/** What pushes each patch; wherever its points are moved to it is the same. */
function pushesOf(network: Network): ReadonlyMap<number, readonly Push[]> {
  const known = pushed.get(network.patches);
  if (known) return known;
  const found = new Map<number, Push[]>();
  for (const [place, patch] of network.patches.entries()) {
    if (!patch.forces?.length) continue;
    for (const laid of unfolded(network, place)) {
      const own = patch.forces.map((force) => ({ laid, force, height: heightOf(patch, force) }));
      found.set(laid.patch, [...(found.get(laid.patch) ?? []), ...own]);
    }
  }
  pushed.set(network.patches, found);
  return found;
}

/** How much of its height a force has at a place of the laid out patches. */
function shareAt({ u = UNIT, v = UNIT, falloff = "sine" }: Force, [x, y]: Pair): number {
  const [p, q] = [(x - u[0]) / (u[1] - u[0]), (y - v[0]) / (v[1] - v[0])];
  if (!(p > 0 && p < 1 && q > 0 && q < 1)) return 0;
  const sine = Math.sin(Math.PI * p) * Math.sin(Math.PI * q);
  return falloff === "smooth" ? sine ** 2 : sine;
}

/** A point of a patch with what pushes it: where it is seen. */
export function seenOn(network: Network, patch: number, u: number, v: number): Triple {
  let [x, y, z] = pointOn(network, patch, u, v);
  for (const { laid, force, height } of pushesOf(network).get(patch) ?? []) {
    const share = shareAt(force, laidAt(laid, u, v));
    [x, y, z] = [x + share * height[0], y + share * height[1], z + share * height[2]];
  }
  return [x, y, z];
}

/** The point of the surface at a place of the laid out patches; null beyond them. */
export function pointAt(network: Network, laid: readonly Unfolded[], [x, y]: Pair): Triple | null {
  const near = 1e-9;
  for (const each of laid) {
    const [dx, dy] = [x - each.origin[0], y - each.origin[1]];
    const u = dx * each.along[0] + dy * each.along[1];
    const v = dx * each.across[0] + dy * each.across[1];
    if (u >= -near && u <= 1 + near && v >= -near && v <= 1 + near) return seenOn(network, each.patch, u, v);
  }
  return null;
}

/** Of several places those that there are. */
export function pointsAt(network: Network, laid: readonly Unfolded[], places: readonly Pair[]): readonly Triple[] {
  return places.map((place) => pointAt(network, laid, place)).filter((point) => point !== null);
}

/** A smooth force on the rectangle between two places of the laid out patches. */
export function regionBetween(patch: Patch, from: Pair, to: Pair, height: Triple): Force {
  const range = (axis: 0 | 1): Pair => {
    const [low, high] = [Math.min(from[axis], to[axis]), Math.max(from[axis], to[axis])].map(neat) as [number, number];
    if (high - low >= NARROWEST) return [low, high];
    const middle = (low + high) / 2;
    return [neat(middle - NARROWEST / 2), neat(middle + NARROWEST / 2)];
  };
  return { f0: forceFor(patch, height), u: range(0), v: range(1), falloff: "smooth" };
}

/** The middle of what a force pushes. */
export function crestOf({ u = UNIT, v = UNIT }: Force): Pair {
  return [(u[0] + u[1]) / 2, (v[0] + v[1]) / 2];
}

/** The rim of what it pushes, in so many steps a side. */
export function rimOf({ u = UNIT, v = UNIT }: Force, steps: number): readonly Pair[] {
  const shares = Array.from({ length: steps }, (_, each) => each / steps);
  const mix = ([from, to]: Pair, share: number) => from + share * (to - from);
  return [
    ...shares.map((share): Pair => [mix(u, share), v[0]]),
    ...shares.map((share): Pair => [u[1], mix(v, share)]),
    ...shares.map((share): Pair => [mix(u, 1 - share), v[1]]),
    ...shares.map((share): Pair => [u[0], mix(v, 1 - share)]),
  ];
}

const OUT: readonly Pair[] = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
];
const STARTS: readonly Pair[] = [
  [0, 0],
  [1, 0],
  [0, 1],
  [0, 0],
];

function across(network: Network, from: Unfolded, side: number): Unfolded | null {
  const vertices = sideOf((network.patches[from.patch] as Patch).frame, side);
  const other = edgesOf(network)
    .get(keyOf(vertices))
    ?.sides.find((each) => each.patch !== from.patch || each.side !== side);
  if (!other) return null;
  const way: Pair = side % 2 === 0 ? [1, 0] : [0, 1];
  const start = STARTS[side] as Pair;
  const out = OUT[side] as Pair;
  const same = other.vertices[0] === vertices[0];
  const turn = ([x, y]: Pair): Pair => [x * from.along[0] + y * from.across[0], x * from.along[1] + y * from.across[1]];
  const edge = laidAt(from, ...(same ? start : ([start[0] + way[0], start[1] + way[1]] as const)));
  const on = turn(same ? way : [-way[0] + 0, -way[1] + 0]);
  const away = turn(out);
  const [first, second] = other.side % 2 === 0 ? [on, away] : [away, on];
  // Sides at v = 0 and u = 0 have the patch ahead of them; the others behind.
  const ahead = other.side === 0 || other.side === 3;
  const back: Pair = [-away[0] + 0, -away[1] + 0];
  const origin: Pair = ahead ? edge : [edge[0] + away[0], edge[1] + away[1]];
  if (ahead) return { patch: other.patch, origin, along: first, across: second };
  return other.side === 2
    ? { patch: other.patch, origin, along: on, across: back }
    : { patch: other.patch, origin, along: back, across: on };
}

/** Of two in one cell. */
function liesAlike(one: Unfolded, other: Unfolded): boolean {
  const ways = ({ along, across }: Unfolded) => `${along} ${across}`;
  return one.patch === other.patch && ways(one) === ways(other);
}

/** The lower left corner of its unit square. */
function cellOf(each: Unfolded): Pair {
  const corners = [laidAt(each, 0, 0), laidAt(each, 1, 1)];
  return [Math.min(...corners.map(([x]) => x)), Math.min(...corners.map(([, y]) => y))];
}

function neat(value: number): number {
  return Math.round(1000 * value) / 1000 + 0;
}
