/** What a person has picked of a network, and what hangs together with it. */

import { edgesOf, edgesThrough, isFree, keyOf, type Network, type Patch, sideOf } from "./network";
import { rowsOf } from "./topology";

export interface Picks {
  readonly vertices: ReadonlySet<number>;
  readonly patches: ReadonlySet<number>;
}

export const NOTHING: Picks = { vertices: new Set(), patches: new Set() };

/** A vertex, alone or beside what there is; once more takes it away again. */
export function withVertex({ vertices, patches }: Picks, vertex: number, more: boolean): Picks {
  if (!more) return { vertices: new Set([vertex]), patches: new Set() };
  return { vertices: toggled(vertices, vertex), patches };
}

/** A patch with its eight vertices. */
export function withPatch(network: Network, picks: Picks, patch: number, more: boolean): Picks {
  const patches = more ? toggled(picks.patches, patch) : new Set([patch]);
  return { vertices: verticesOf(network, patches), patches };
}

export function everything(network: Network): Picks {
  const patches = new Set(network.patches.keys());
  return { vertices: verticesOf(network, patches), patches };
}

export function withVertices(picks: Picks, vertices: Iterable<number>, more: boolean): Picks {
  return {
    vertices: new Set([...(more ? picks.vertices : []), ...vertices]),
    patches: more ? picks.patches : new Set(),
  };
}

/** The rim that picked edges are of; of an edge between two patches all that lie across its strip. */
export function ringThrough(network: Network, picks: Picks): Picks {
  const all = [...edgesOf(network).values()];
  const picked = edgesThrough(network, picks.vertices);
  const vertices = new Set(picks.vertices);
  const rims = rowsOf(all.filter(isFree)) ?? [];
  const seen = new Set<string>();
  const queue = picked.filter((edge) => !isFree(edge));
  for (const { edges, vertices: own } of rims) {
    if (edges.some((edge) => picked.includes(edge))) for (const vertex of own) vertices.add(vertex);
  }
  while (queue.length > 0) {
    const edge = queue.pop();
    if (!edge || seen.has(edge.key)) continue;
    seen.add(edge.key);
    for (const vertex of edge.sides[0]?.vertices ?? []) vertices.add(vertex);
    for (const { patch, side } of edge.sides) {
      const opposite = edgesOf(network).get(keyOf(sideOf((network.patches[patch] as Patch).frame, (side + 2) % 4)));
      if (opposite) queue.push(opposite);
    }
  }
  return { ...picks, vertices };
}

/** What of the picks there still is. */
export function within({ vertices, patches }: Network, picks: Picks): Picks {
  const isInside = (all: ReadonlySet<number>, count: number) => {
    for (const each of all) if (each >= count) return false;
    return true;
  };
  if (isInside(picks.vertices, vertices.length) && isInside(picks.patches, patches.length)) return picks;
  const inside = (all: ReadonlySet<number>, count: number) => new Set([...all].filter((each) => each < count));
  return { vertices: inside(picks.vertices, vertices.length), patches: inside(picks.patches, patches.length) };
}

function verticesOf({ patches }: Network, picked: ReadonlySet<number>): ReadonlySet<number> {
  return new Set([...picked].flatMap((patch) => patches[patch]?.frame ?? []));
}

function toggled(all: ReadonlySet<number>, one: number): ReadonlySet<number> {
  const next = new Set(all);
  if (!next.delete(one)) next.add(one);
  return next;
}
