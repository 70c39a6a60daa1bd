/** Where the patches of a network are, for what is drawn over them and held by hand: the crate's own closed form (docs/frames.md), without forces. */

import type { Triple } from "../types";
import { at, edgesOf, type Frame, type Network } from "./network";

/** The cubic terms of each patch, along `u` and along `v`. */
type Cubic = readonly [Triple, Triple];

const ONES: Triple = [1, 1, 1];
const NONE: Triple = [0, 0, 0];

const known = new WeakMap<Network, readonly Cubic[]>();

/** A point of a patch. */
export function pointOn(network: Network, patch: number, u: number, v: number): Triple {
  const frame = network.patches[patch]?.frame;
  if (!frame) return [0, 0, 0];
  const [along, across] = cubicOf(network)[patch] ?? [NONE, NONE];
  const weights = weightsAt(u, v);
  const bend = [u * (u - 0.5) * (u - 1), v * (v - 0.5) * (v - 1)] as const;
  const sum = (axis: 0 | 1 | 2) => {
    let value = bend[0] * along[axis] + bend[1] * across[axis];
    for (const [place, index] of frame.entries())
      value += (weights[place] ?? 0) * (network.vertices[index]?.[axis] ?? 0);
    return value;
  };
  return [sum(0), sum(1), sum(2)];
}

/** The direction of `X_u x X_v`, or null where there is none. */
export function normalOn(network: Network, patch: number, u: number, v: number): Triple | null {
  const step = 1e-3;
  const between = (from: Triple, to: Triple): Triple => [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  const along = between(pointOn(network, patch, u - step, v), pointOn(network, patch, u + step, v));
  const across = between(pointOn(network, patch, u, v - step), pointOn(network, patch, u, v + step));
  return unit(cross(along, across));
}

/** The mean of the normals that the patches round a vertex have there, all turned as the first. */
export function normalAt(network: Network, vertex: number): Triple | null {
  let sum: Triple = [0, 0, 0];
  for (const [patch, { frame }] of network.patches.entries()) {
    const place = frame.indexOf(vertex);
    if (place < 0) continue;
    const [u, v] = PLACES[place] ?? [0, 0];
    const normal = normalOn(network, patch, u, v);
    if (!normal) continue;
    const sign = dot(sum, normal) < 0 ? -1 : 1;
    sum = [sum[0] + sign * normal[0], sum[1] + sign * normal[1], sum[2] + sign * normal[2]];
  }
  return unit(sum);
}

/** Where the points of a frame are on its patch. */
export const PLACES: readonly (readonly [u: number, v: number])[] = [
  [0, 0],
  [0.5, 0],
  [1, 0],
  [1, 0.5],
  [1, 1],
  [0.5, 1],
  [0, 1],
  [0, 0.5],
];

/** How much of each point of the frame is in the quadratic through all of them. */
function weightsAt(u: number, v: number): readonly number[] {
  const [p, q] = [1 - u, 1 - v];
  return [
    p * q * (1 - 2 * u - 2 * v),
    4 * u * p * q,
    u * q * (2 * u - 2 * v - 1),
    4 * u * v * q,
    u * v * (2 * u + 2 * v - 3),
    4 * u * p * v,
    p * v * (2 * v - 2 * u - 1),
    4 * p * v * q,
  ];
}

export function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function unit(a: Triple): Triple | null {
  const length = Math.hypot(...a);
  return length > 1e-12 ? [a[0] / length, a[1] / length, a[2] / length] : null;
}

/** One cubic term for each strip of patches that are joined from edge to opposite edge. */
function cubicOf(network: Network): readonly Cubic[] {
  const before = known.get(network);
  if (before) return before;
  const { patches } = network;
  const { root, sign, twisted } = strips(network);
  const order = orderOf(network);
  const sums = new Map<number, { over: [number, number, number]; under: [number, number, number]; decides: number }>();
  for (const [patch, { frame, a1 = ONES, a2 = ONES }] of patches.entries()) {
    for (const way of [0, 1] as const) {
      const node = 2 * patch + way;
      const strip = root(node);
      const sum = sums.get(strip) ?? { over: [0, 0, 0], under: [0, 0, 0], decides: Number.POSITIVE_INFINITY };
      sums.set(strip, sum);
      const rank = order?.[patch] ?? 0;
      if (rank > sum.decides) continue;
      if (rank < sum.decides) Object.assign(sum, { over: [0, 0, 0], under: [0, 0, 0], decides: rank });
      const [own, other] = way === 0 ? [a1, a2] : [a2, a1];
      const mixed = mixedOf(network, frame, way);
      for (const axis of [0, 1, 2] as const) {
        sum.over[axis] -= (sign(node) * own[axis] * other[axis] * mixed[axis]) / 3;
        sum.under[axis] += own[axis] ** 2;
      }
    }
  }
  const termOf = (node: number): Triple => {
    const strip = root(node);
    const sum = sums.get(strip);
    if (!sum || twisted.has(strip)) return NONE;
    const s = sign(node);
    const term = (axis: 0 | 1 | 2) => (sum.under[axis] === 0 ? 0 : (s * sum.over[axis]) / sum.under[axis]);
    return [term(0), term(1), term(2)];
  };
  const terms = patches.map((_, patch): Cubic => [termOf(2 * patch), termOf(2 * patch + 1)]);
  known.set(network, terms);
  return terms;
}

/** How the second derivative along the edges differs from one side to the opposite one. */
function mixedOf(network: Network, frame: Frame, way: 0 | 1): Triple {
  const bend = (places: Triple): Triple => {
    const [a, b, c] = places.map((place) => at(network, frame[place] as number)) as [Triple, Triple, Triple];
    const one = (axis: 0 | 1 | 2) => 2 * (a[axis] - 2 * b[axis] + c[axis]);
    return [one(0), one(1), one(2)];
  };
  const [far, near] = way === 0 ? [bend([2, 3, 4]), bend([0, 7, 6])] : [bend([6, 5, 4]), bend([0, 1, 2])];
  return [far[0] - near[0], far[1] - near[1], far[2] - near[2]];
}

/** Which directions of which patches run on in one another, and where turned: the directions are 2 p and 2 p + 1 of patch p. */
function strips(network: Network) {
  const parents = Array.from({ length: 2 * network.patches.length }, (_, node) => node);
  const signs = parents.map(() => 1);
  const twisted = new Set<number>();
  const find = (node: number): readonly [number, number] => {
    let [here, sign] = [node, 1];
    while (parents[here] !== here) {
      sign *= signs[here] ?? 1;
      here = parents[here] ?? here;
    }
    parents[node] = here;
    if (here !== node) signs[node] = sign;
    return [here, sign];
  };
  for (const { sides } of edgesOf(network).values()) {
    const [one, other] = sides;
    if (!one || !other) continue;
    const same = one.vertices[0] === other.vertices[0] ? 1 : -1;
    const [a, b] = [one, other].map(({ patch, side }) => find(2 * patch + (side % 2))) as [
      readonly [number, number],
      readonly [number, number],
    ];
    const between = a[1] * b[1] * same;
    if (a[0] === b[0]) {
      if (between < 0) twisted.add(a[0]);
    } else {
      parents[b[0]] = a[0];
      signs[b[0]] = between;
      if (twisted.has(b[0])) twisted.add(a[0]);
    }
  }
  return { root: (node: number) => find(node)[0], sign: (node: number) => find(node)[1], twisted };
}

/** How soon each patch comes after the one that decides first; null where all decide together. */
export function orderOf(network: Network): readonly number[] | null {
  const { rule = "global", patches } = network;
  if (rule === "global") return null;
  const beside = neighboursOf(network);
  const order: number[] = patches.map(() => -1);
  let rank = 0;
  const from = [rule.seed, ...patches.keys()];
  for (const seed of from) {
    if (order[seed] !== -1) continue;
    let level = [seed];
    while (level.length > 0) {
      level = [...new Set(level)].filter((patch) => order[patch] === -1).sort((a, b) => a - b);
      for (const patch of level) {
        order[patch] = rank;
        rank += 1;
      }
      level = level.flatMap((patch) => beside[patch] ?? []);
    }
  }
  return order;
}

/** The patches across the edges of each. */
function neighboursOf(network: Network): readonly (readonly number[])[] {
  const beside: number[][] = network.patches.map(() => []);
  for (const { sides } of edgesOf(network).values()) {
    for (const one of sides) for (const other of sides) if (one !== other) beside[one.patch]?.push(other.patch);
  }
  return beside;
}
