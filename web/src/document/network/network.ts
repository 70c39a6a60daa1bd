/** Networks of four-sided patches: which edges they have in common, and what no network may be. */

import type { Triple, VertexFrame } from "../types";

export type Network = VertexFrame;
export type Patch = Network["patches"][number];
export type Frame = Patch["frame"];

/** A side of a patch: its vertices in the direction in which `u` or `v` grows. */
export interface Side {
  readonly patch: number;
  /** 0 and 2 run along `u` (at `v` = 0 and 1), 1 and 3 along `v` (at `u` = 1 and 0). */
  readonly side: number;
  readonly vertices: Triple;
}

/** Three vertices that one patch has as a side, or two have. */
export interface Edge {
  /** Which edge it is: of two edges with the same ends and another middle each is one of its own. */
  readonly key: string;
  readonly sides: readonly Side[];
}

/** The places of a frame along each of its sides. */
export const SIDES: readonly Triple[] = [
  [0, 1, 2],
  [2, 3, 4],
  [6, 5, 4],
  [0, 7, 6],
];

/** Where in a frame corners stand. */
export const CORNERS = [0, 2, 4, 6] as const;

/** What the solver refuses, as far as no number has to be solved for. */
export type Fault = "empty" | "crowded" | "repeated" | "collapsed" | "infinite";

export function sideOf(frame: Frame, side: number): Triple {
  const [from, middle, to] = SIDES[side] ?? [0, 1, 2];
  return [frame[from] as number, frame[middle] as number, frame[to] as number];
}

export function keyOf([from, middle, to]: Triple): string {
  return from < to ? `${from} ${middle} ${to}` : `${to} ${middle} ${from}`;
}

const known = new WeakMap<Network["patches"], ReadonlyMap<string, Edge>>();

/** All edges by their keys. */
export function edgesOf({ patches }: Network): ReadonlyMap<string, Edge> {
  const before = known.get(patches);
  if (before) return before;
  const edges = new Map<string, { readonly key: string; readonly sides: Side[] }>();
  for (const [patch, { frame }] of patches.entries()) {
    for (let side = 0; side < 4; side += 1) {
      const vertices = sideOf(frame, side);
      const key = keyOf(vertices);
      const edge = edges.get(key) ?? { key, sides: [] };
      edge.sides.push({ patch, side, vertices });
      edges.set(key, edge);
    }
  }
  known.set(patches, edges);
  return edges;
}

/** The patches that have each vertex: those of one begin where `starts` says, and end where those of the next begin. */
interface Round {
  readonly starts: Uint32Array;
  readonly patches: Uint32Array;
}

const rounds = new WeakMap<Network["patches"], Round>();

function roundOf({ patches }: Network): Round {
  const before = rounds.get(patches);
  if (before) return before;
  let most = 0;
  for (const { frame } of patches) for (const vertex of frame) most = Math.max(most, vertex);
  const starts = new Uint32Array(most + 2);
  for (const { frame } of patches) for (const vertex of frame) starts[vertex + 1] = (starts[vertex + 1] ?? 0) + 1;
  for (let vertex = 0; vertex <= most; vertex += 1)
    starts[vertex + 1] = (starts[vertex + 1] ?? 0) + (starts[vertex] ?? 0);
  const next = starts.slice();
  const all = new Uint32Array(8 * patches.length);
  for (const [patch, { frame }] of patches.entries()) {
    for (const vertex of frame) {
      all[next[vertex] ?? 0] = patch;
      next[vertex] = (next[vertex] ?? 0) + 1;
    }
  }
  const found = { starts, patches: all };
  rounds.set(patches, found);
  return found;
}

/** The patches that have one of these vertices, ascending. */
export function patchesRound(network: Network, vertices: Iterable<number>): readonly number[] {
  const { starts, patches } = roundOf(network);
  const found = new Set<number>();
  for (const vertex of vertices) {
    for (let place = starts[vertex] ?? 0; place < (starts[vertex + 1] ?? 0); place += 1) found.add(patches[place] ?? 0);
  }
  return [...found].sort((a, b) => a - b);
}

export function isFree(edge: Edge): boolean {
  return edge.sides.length === 1;
}

/** Whether it goes round something: no edge has a patch on one side alone. */
export function isClosed(network: Network): boolean {
  for (const edge of edgesOf(network).values()) if (isFree(edge)) return false;
  return true;
}

/** The edges whose middles these vertices are. */
export function edgesThrough(network: Network, vertices: ReadonlySet<number>): readonly Edge[] {
  return [...edgesOf(network).values()].filter(({ sides }) => sides[0] && vertices.has(sides[0].vertices[1]));
}

export function at({ vertices }: Network, index: number): Triple {
  return vertices[index] ?? [0, 0, 0];
}

/** What is wrong with a network, or null. */
export function faultOf(network: Network): Fault | null {
  const { vertices, patches } = network;
  if (patches.length === 0) return "empty";
  for (const point of vertices) if (!point.every(Number.isFinite)) return "infinite";
  for (const { frame } of patches) {
    if (new Set(frame).size < frame.length) return "repeated";
    for (const one of CORNERS) {
      for (const other of CORNERS) {
        if (one >= other) continue;
        const [a, b] = [at(network, frame[one]), at(network, frame[other])];
        if (a[0] === b[0] && a[1] === b[1] && a[2] === b[2]) return "collapsed";
      }
    }
  }
  for (const { sides } of edgesOf(network).values()) if (sides.length > 2) return "crowded";
  return null;
}

const sizes = new WeakMap<Network["vertices"], number>();

/** How far it reaches from its middle. */
export function sizeOf({ vertices }: Network): number {
  const known = sizes.get(vertices);
  if (known !== undefined) return known;
  const [low, high] = [
    [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY],
    [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY],
  ] as [[number, number, number], [number, number, number]];
  for (const point of vertices) {
    for (const axis of [0, 1, 2] as const) {
      const value = point[axis];
      if (value < low[axis]) low[axis] = value;
      if (value > high[axis]) high[axis] = value;
    }
  }
  const size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2;
  const found = size > 0 && Number.isFinite(size) ? size : 1;
  sizes.set(vertices, found);
  return found;
}

/** Without the vertices that nothing uses, and where each of the old ones is now. */
export function compacted(network: Network): { readonly network: Network; readonly places: readonly number[] } {
  const used = new Set(network.patches.flatMap(({ frame }) => frame));
  const places: number[] = [];
  const vertices: Triple[] = [];
  for (const [index, point] of network.vertices.entries()) {
    places.push(used.has(index) ? vertices.length : -1);
    if (used.has(index)) vertices.push(point);
  }
  if (vertices.length === network.vertices.length) return { network, places };
  const moved = ({ frame, ...rest }: Patch): Patch => ({
    ...rest,
    frame: frame.map((index) => places[index] ?? -1) as unknown as Frame,
  });
  return { network: { ...network, vertices, patches: network.patches.map(moved) }, places };
}
