import { at, type Triple } from "./triple";

/**
 * The mesh contract of the stage, and the one check that every mesh passes before it reaches the GPU.
 *
 * `positions` and `normals` hold three floats per vertex in model units, z up, normals pointing out of the pot;
 * `uvs` two per vertex (u along the profile, v / span round it); `indices` three per triangle, counter-clockwise
 * seen from outside; `groups` (first index, index count, part) triples.
 */
export interface StageMesh {
  positions: Float32Array;
  normals: Float32Array;
  uvs: Float32Array;
  indices: Uint32Array;
  groups: Uint32Array;
}

/** What a set of points fills. `radius` is the largest distance of a point from `centre`, the middle of the box. */
export interface Bounds {
  min: Triple;
  max: Triple;
  centre: Triple;
  radius: number;
}

/** A mesh that cannot be drawn; the message says which array is wrong and how. */
export class MeshError extends RangeError {
  override readonly name = "MeshError";
}

/**
 * Refuses what WebGL would draw as garbage or crash on: lengths that do not fit together, an index or a group that
 * points outside, a number that is not finite. An empty mesh is a valid one.
 *
 * @throws {MeshError}
 */
export function checkMesh(mesh: StageMesh): void {
  const { positions, normals, uvs, indices, groups } = mesh;
  if (positions.length % 3 !== 0) throw new MeshError(`positions has ${positions.length} numbers, not a multiple of 3`);
  const vertices = positions.length / 3;
  if (normals.length !== positions.length) {
    throw new MeshError(`normals has ${normals.length} numbers where positions has ${positions.length}`);
  }
  if (uvs.length !== 2 * vertices) {
    throw new MeshError(`uvs has ${uvs.length} numbers where ${2 * vertices} are needed`);
  }
  if (indices.length % 3 !== 0) throw new MeshError(`indices has ${indices.length} numbers, not a multiple of 3`);
  if (groups.length % 3 !== 0) throw new MeshError(`groups has ${groups.length} numbers, not a multiple of 3`);
  checkFinite("positions", positions);
  checkFinite("normals", normals);
  checkFinite("uvs", uvs);
  for (let i = 0; i < indices.length; i++) {
    if (at(indices, i) >= vertices) {
      throw new MeshError(`indices[${i}] is ${at(indices, i)} but there are ${vertices} vertices`);
    }
  }
  for (let g = 0; g < groups.length; g += 3) {
    const end = at(groups, g) + at(groups, g + 1);
    if (end > indices.length) throw new MeshError(`group ${g / 3} ends at index ${end} of ${indices.length}`);
  }
}

/** @throws {MeshError} naming the first number that is NaN or infinite */
export function checkFinite(name: string, values: Float32Array): void {
  // One sum instead of a test per number: it is finite unless one of its terms is not, as single-precision terms cannot
  // overflow a double-precision sum of this length.
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += at(values, i);
  if (Number.isFinite(sum)) return;
  for (let i = 0; i < values.length; i++) {
    if (!Number.isFinite(values[i])) throw new MeshError(`${name}[${i}] is ${values[i]}`);
  }
}

/** The bounds of xyz triples, or null when there are none. */
export function boundsOf(positions: Float32Array): Bounds | null {
  if (positions.length < 3) return null;
  let [x0, y0, z0] = [Infinity, Infinity, Infinity];
  let [x1, y1, z1] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const x = at(positions, i);
    const y = at(positions, i + 1);
    const z = at(positions, i + 2);
    if (x < x0) x0 = x;
    if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    if (y > y1) y1 = y;
    if (z < z0) z0 = z;
    if (z > z1) z1 = z;
  }
  const centre: Triple = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2];
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const x = at(positions, i) - centre[0];
    const y = at(positions, i + 1) - centre[1];
    const z = at(positions, i + 2) - centre[2];
    squared = Math.max(squared, x * x + y * y + z * z);
  }
  return { min: [x0, y0, z0], max: [x1, y1, z1], centre, radius: Math.sqrt(squared) };
}
