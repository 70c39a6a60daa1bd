import type { StageMesh } from "./mesh";
import { at } from "./triple";

/** A part of a mesh that is a grid of vertices, row by row: row along the profile, column round it. */
export interface Grid {
  /** The first vertex. */
  first: number;
  rows: number;
  columns: number;
}

/** The vertices that a run of indices uses, as the first one and the one after the last. */
export function vertexRange(indices: Uint32Array, start: number, count: number): { first: number; end: number } {
  let first = Infinity;
  let last = -1;
  for (let i = start; i < start + count; i++) {
    const vertex = at(indices, i);
    if (vertex < first) first = vertex;
    if (vertex > last) last = vertex;
  }
  return last < 0 ? { first: 0, end: 0 } : { first, end: last + 1 };
}

/**
 * Recognises the grid in a range of vertices by its parameters: `u` is constant along a row. Null for anything else (a part
 * that is not a two-sided surface), which is then drawn without what needs a profile.
 */
export function gridOf(mesh: StageMesh, first: number, end: number): Grid | null {
  const { uvs } = mesh;
  const count = end - first;
  if (count < 4) return null;
  const u = (vertex: number) => at(uvs, 2 * vertex);
  let columns = 1;
  while (columns < count && u(first + columns) === u(first)) columns++;
  const rows = count / columns;
  if (columns < 2 || rows < 2 || !Number.isInteger(rows)) return null;
  for (let row = 0; row < rows; row++) {
    const start = first + row * columns;
    if (u(start) !== u(start + columns - 1)) return null;
    if (row > 0 && !(u(start) > u(start - 1))) return null;
  }
  return { first, rows, columns };
}
