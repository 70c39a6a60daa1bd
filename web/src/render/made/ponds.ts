/** The ponds that a level surface is of: triangles that hang together, each pond's after one another. */

import { at } from "../triple";

/** Where the middle of a pond is, seen from above, and which indices are its triangles. */
export interface Pond {
  readonly at: readonly [x: number, y: number];
  readonly range: readonly [first: number, count: number];
}

/** `positions` are x, y and z of every vertex, `indices` three to a triangle. */
export function ponds(
  positions: ArrayLike<number>,
  indices: Uint32Array,
): { readonly indices: Uint32Array; readonly ranges: readonly Pond[] } {
  const root = Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  const rootOf = (vertex: number): number => {
    let now = vertex;
    while (at(root, now) !== now) {
      root[now] = at(root, at(root, now));
      now = at(root, now);
    }
    return now;
  };
  for (let k = 0; k < indices.length; k += 3) {
    const first = rootOf(at(indices, k));
    root[rootOf(at(indices, k + 1))] = first;
    root[rootOf(at(indices, k + 2))] = first;
  }
  const members = new Map<number, number[]>();
  for (let k = 0; k < indices.length; k += 3) {
    const pond = rootOf(at(indices, k));
    const own = members.get(pond) ?? [];
    own.push(at(indices, k), at(indices, k + 1), at(indices, k + 2));
    members.set(pond, own);
  }
  const sorted = new Uint32Array(indices.length);
  const ranges: Pond[] = [];
  let first = 0;
  for (const own of members.values()) {
    sorted.set(own, first);
    ranges.push({ at: middleOf(positions, own), range: [first, own.length] });
    first += own.length;
  }
  return { indices: sorted, ranges };
}

function middleOf(positions: ArrayLike<number>, vertices: readonly number[]): readonly [number, number] {
  const along = (axis: number) => {
    let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (const vertex of vertices) {
      const x = positions[3 * vertex + axis] ?? 0;
      [low, high] = [Math.min(low, x), Math.max(high, x)];
    }
    return (low + high) / 2;
  };
  return [along(0), along(1)];
}
