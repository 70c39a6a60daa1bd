/** Faces of an OBJ file as a network. Numbers alone are sent to the page: a hundred thousand patches as objects would take it as long as to read them. */

import type { Frame, Network } from "../document/network/network";
import { type ObjTrouble, readObj } from "../document/network/obj";
import type { Triple } from "../document/types";

/** The points, three numbers each, and the eight of them that each patch names. */
export interface Faces {
  readonly points: Float64Array;
  readonly frames: Uint32Array;
}

export type ReadFaces = Faces | { readonly trouble: ObjTrouble };

export function readFaces(bytes: Uint8Array): ReadFaces {
  const read = readObj(new TextDecoder().decode(bytes));
  if ("trouble" in read) return read;
  const { vertices, patches } = read.network;
  const points = new Float64Array(3 * vertices.length);
  for (const [index, vertex] of vertices.entries()) points.set(vertex, 3 * index);
  const frames = new Uint32Array(8 * patches.length);
  for (const [index, { frame }] of patches.entries()) frames.set(frame, 8 * index);
  return { points, frames };
}

export function networkOfFaces({ points, frames }: Faces): Network {
  const at = (index: number) => points[index] as number;
  const vertices = Array.from({ length: points.length / 3 }, (_, index): Triple => {
    const first = 3 * index;
    return [at(first), at(first + 1), at(first + 2)];
  });
  const patches = Array.from({ length: frames.length / 8 }, (_, index) => ({
    frame: Array.from(frames.subarray(8 * index, 8 * index + 8)) as unknown as Frame,
  }));
  return { kind: "vertex-frame", vertices, patches };
}
