/** What a person has picked of a network, and what hangs together with it. */

import { type Edge, edgesOf, edgesThrough, isFree, keyOf, type Network, type Patch, sideOf } from "./network";

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

/** A patch with its eight vertices, alone or beside what there is: vertices that are of no picked patch stay picked. */
export function withPatch(network: Network, picks: Picks, patch: number, more: boolean): Picks {
  const patches = more ? toggled(picks.patches, patch) : new Set([patch]);
  const own = verticesOf(network, picks.patches);
  const loose = more ? [...picks.vertices].filter((vertex) => !own.has(vertex)) : [];
  return { vertices: new Set([...loose, ...verticesOf(network, patches)]), patches };
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
  const picked = edgesThrough(network, picks.vertices);
  const found = [
    ...alongRims(network, picked.filter(isFree)),
    ...acrossStrips(
      network,
      picked.filter((edge) => !isFree(edge)),
    ),
  ];
  return {
    ...picks,
    vertices: new Set([...picks.vertices, ...found.flatMap(({ sides }) => sides[0]?.vertices ?? [])]),
  };
}

/** The free edges that go on from these. Where rims meet in a point none of them goes on beyond it. */
function alongRims(network: Network, from: readonly Edge[]): ReadonlySet<Edge> {
  if (from.length === 0) return new Set();
  const meeting = new Map<number, Edge[]>();
  for (const edge of edgesOf(network).values()) {
    if (isFree(edge)) for (const end of endsOf(edge)) meeting.set(end, [...(meeting.get(end) ?? []), edge]);
  }
  return reached(from, (edge) =>
    endsOf(edge).flatMap((end) => (meeting.get(end)?.length === 2 ? meeting.get(end) : [])),
  );
}

function acrossStrips(network: Network, from: readonly Edge[]): ReadonlySet<Edge> {
  const edges = edgesOf(network);
  return reached(from, ({ sides }) =>
    sides.map(({ patch, side }) => edges.get(keyOf(sideOf((network.patches[patch] as Patch).frame, (side + 2) % 4)))),
  );
}

function reached(from: readonly Edge[], beside: (edge: Edge) => readonly (Edge | undefined)[]): ReadonlySet<Edge> {
  const found = new Set<Edge>();
  const queue: (Edge | undefined)[] = [...from];
  while (queue.length > 0) {
    const edge = queue.pop();
    if (!edge || found.has(edge)) continue;
    found.add(edge);
    queue.push(...beside(edge));
  }
  return found;
}

function endsOf({ sides }: Edge): readonly number[] {
  const [from = 0, , to = 0] = sides[0]?.vertices ?? [];
  return [from, to];
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
