/** Frame models as OBJ: faces of quads, whose edges get middles, and faces of eight points, which are patches as they are. */

import type { Triple } from "../types";
import { compacted, type Frame, faultOf, type Network, type Patch } from "./network";

export type ObjTrouble = "empty" | "faces" | "crowded" | "broken";

export type ReadObj = { readonly network: Network } | { readonly trouble: ObjTrouble };

const DIGITS = 9;

export function readObj(text: string): ReadObj {
  const vertices: Triple[] = [];
  const faces: (readonly number[])[] = [];
  for (const line of text.replace(/\\\r?\n/g, " ").split(/\r?\n/)) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") {
      const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = rest.map(Number);
      if (![x, y, z].every(Number.isFinite)) return { trouble: "broken" };
      vertices.push([x, y, z]);
    } else if (word === "f") {
      // Counted from 1, or from the last one back; what follows a slash are textures and normals.
      const face = rest
        .map((each) => Number.parseInt(each, 10))
        .map((index) => (index < 0 ? vertices.length + index : index - 1));
      if (face.some((index) => vertices[index] === undefined)) return { trouble: "broken" };
      if (face.length !== 4 && face.length !== 8) return { trouble: "faces" };
      faces.push(face);
    }
  }
  if (faces.length === 0) return { trouble: "empty" };
  const middles = new Map<string, number>();
  // Middles that faces of eight bring along are those of their edges for quads beside them too.
  for (const face of faces) {
    if (face.length === 8)
      for (const side of [0, 2, 4, 6]) middles.set(keyOf(face[side], face[(side + 2) % 8]), face[side + 1] as number);
  }
  const middleOf = (from: number, to: number): number => {
    const key = keyOf(from, to);
    const known = middles.get(key);
    if (known !== undefined) return known;
    const [a, b] = [vertices[from] as Triple, vertices[to] as Triple];
    const made = vertices.push([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2]) - 1;
    middles.set(key, made);
    return made;
  };
  const patches = faces.map((face): Patch => {
    if (face.length === 8) return { frame: face as unknown as Frame };
    const [a, b, c, d] = face as readonly [number, number, number, number];
    return { frame: [a, middleOf(a, b), b, middleOf(b, c), c, middleOf(c, d), d, middleOf(d, a)] };
  });
  const { network } = compacted({ kind: "vertex-frame", vertices, patches });
  const fault = faultOf(network);
  if (fault === null) return { network };
  return { trouble: fault === "crowded" ? "crowded" : "broken" };
}

/** Points and patches; parameters and forces have no place in this format. */
export function writeObj({ vertices, patches }: Network): string {
  const points = vertices.map((point) => `v ${point.map((value) => Number(value.toPrecision(DIGITS))).join(" ")}`);
  const faces = patches.map(({ frame }) => `f ${frame.map((index) => index + 1).join(" ")}`);
  return `${[...points, ...faces].join("\n")}\n`;
}

function keyOf(from: number | undefined, to: number | undefined): string {
  return [from ?? 0, to ?? 0].sort((a, b) => a - b).join(" ");
}
