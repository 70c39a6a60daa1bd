/** A pot as its picture needs it: without the face that the design's own surface shows already, and with what the glaze goes by. */

import { farthestOf } from "../document/extents";
import { DEFAULTS } from "../document/tables.gen";
import type { Design, Part } from "../document/types";
import { boundsOf } from "../solver/bounds";
import type { Solid, Spare } from "./messages";

/** What the package hands over. */
export interface SolidArrays {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly indices: Uint32Array;
  readonly faces: readonly Face[];
}

export interface Face {
  readonly kind: string;
  readonly part: number;
  /** In indices. */
  readonly first: number;
  readonly count: number;
}

/** A distance to an edge that there is not. */
const FAR = 1e9;

/** Below this the glaze stops: what the pot stands on is bare. */
const BARE = -FAR;

/** The glaze on a rim is as thin as that so far below a sharp one, in radii of the mouth. */
const RIM_SHARE = 0.15;

/** Numbers per vertex: lining, distance to rim, distance to foot, depth in radii of the mouth. */
const SIZE = 4;

/** The arrays of `spare` that are long enough are written over. */
export function solidOf(
  { parts }: Design,
  { positions, normals, indices, faces }: SolidArrays,
  spare: Pick<Spare, "wares"> | null = null,
): Solid {
  const kept = faces.filter((face) => face.kind !== shownFace(parts[face.part]));
  const length = (SIZE * positions.length) / 3;
  // As long as there is room for positions, which may be views of longer arrays.
  const room = (SIZE * (positions.buffer.byteLength / positions.BYTES_PER_ELEMENT)) / 3;
  const wares = spare && spare.wares.length >= length ? spare.wares : new Float32Array(room);
  const groups: number[] = [];
  const whole = kept.length === faces.length;
  const drawn = whole ? indices : new Uint32Array(kept.reduce((sum, face) => sum + face.count, 0));
  const rims = new Map<number, Rim>();
  let at = 0;
  for (const face of kept) {
    const rim = rims.get(face.part) ?? rimOf(face.part, faces, positions, indices);
    rims.set(face.part, rim);
    if (!whole) drawn.set(indices.subarray(face.first, face.first + face.count), at);
    groups.push(at, face.count, face.part);
    at += face.count;
    glaze(face, rim, positions, indices, wares);
  }
  return {
    positions: all(positions),
    normals: all(normals),
    wares,
    indices: whole ? new Uint32Array(indices.buffer) : drawn,
    groups: Uint32Array.from(groups),
    bounds: boundsOf(positions),
    farthest: farthestOf(positions),
    sides: parts.map(({ wall }) => (wall ? (wall.side ?? DEFAULTS.side) : null)),
    outsides: parts.map((_, part) => outsideOf(part, kept, positions, indices)),
  };
}

/** All of the array that this is the beginning of: what is on the graphics card is written over only where it is as long as before. */
function all(view: Float32Array): Float32Array {
  return new Float32Array(view.buffer);
}

/** The face that is the design's own surface. */
function shownFace(part: Part | undefined): string {
  return part?.wall?.side === "outside" ? "lining" : "outer";
}

interface Rim {
  readonly height: number;
  readonly radius: number;
  /** The lowest point of the part. */
  readonly foot: number;
}

/** From which height to which the outer side of a part stands; null where the design's own surface is that. */
function outsideOf(
  part: number,
  kept: readonly Face[],
  positions: Float32Array,
  indices: Uint32Array,
): readonly [number, number] | null {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const face of kept) {
    if (face.part !== part || face.kind !== "outer") continue;
    for (let i = face.first; i < face.first + face.count; i += 1) {
      const z = positions[3 * (indices[i] ?? 0) + 2] ?? 0;
      low = Math.min(low, z);
      high = Math.max(high, z);
    }
  }
  return low < high ? [low, high] : null;
}

/** The mean height of the rim and how wide the mouth is. */
function rimOf(part: number, faces: readonly Face[], positions: Float32Array, indices: Uint32Array): Rim {
  let [height, count, foot, top] = [0, 0, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  let [west, east] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const face of faces) {
    if (face.part !== part) continue;
    for (let i = face.first; i < face.first + face.count; i += 1) {
      const vertex = 3 * (indices[i] ?? 0);
      const z = positions[vertex + 2] ?? 0;
      foot = Math.min(foot, z);
      top = Math.max(top, z);
      if (face.kind !== "rim") continue;
      height += z;
      count += 1;
      west = Math.min(west, positions[vertex] ?? 0);
      east = Math.max(east, positions[vertex] ?? 0);
    }
  }
  return count > 0 ? { height: height / count, radius: (east - west) / 2, foot } : { height: top, radius: 0, foot };
}

/** Fills what the glaze goes by for the vertices of a face. */
function glaze(face: Face, rim: Rim, positions: Float32Array, indices: Uint32Array, wares: Float32Array): void {
  const within = face.kind === "lining" || face.kind === "floor" || face.kind === "drain";
  const bare = face.kind === "underside" || face.kind === "foot-ring" || face.kind === "recess";
  for (let i = face.first; i < face.first + face.count; i += 1) {
    const vertex = indices[i] ?? 0;
    const z = positions[3 * vertex + 2] ?? 0;
    const below = Math.max(0, rim.height - z);
    wares[SIZE * vertex] = within ? 1 : 0;
    wares[SIZE * vertex + 1] = face.kind === "rim" ? RIM_SHARE * rim.radius : below;
    wares[SIZE * vertex + 2] = bare ? BARE : within || face.kind === "rim" ? FAR : z - rim.foot;
    wares[SIZE * vertex + 3] = rim.radius > 0 ? below / rim.radius : FAR;
  }
}
