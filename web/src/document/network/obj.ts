/** Frame models as OBJ: faces of quads, whose edges get middles, and faces of eight points, which are patches as they are. */

import { LIMITS } from "../tables.gen";
import type { Triple } from "../types";
import { compacted, type Frame, faultOf, type Network, type Patch } from "./network";

/** Why a text is no network, and where that can be said in which line, counted from 1. */
export type ObjTrouble =
  | { readonly code: "empty" | "crowded" }
  /** So many faces, which are more than a network has patches. */
  | { readonly code: "many"; readonly faces: number }
  /** A line that has not the three coordinates of a point. */
  | { readonly code: "point"; readonly line: number }
  /** A face of so many corners. */
  | { readonly code: "corners"; readonly line: number; readonly corners: number }
  /** What a face names that none of so many points is. */
  | { readonly code: "no-point"; readonly line: number; readonly named: string; readonly points: number }
  /** A face that names a point twice, or two corners of which are in one place. */
  | { readonly code: "repeated" | "collapsed"; readonly line: number };

export type ReadObj = { readonly network: Network } | { readonly trouble: ObjTrouble };

const DIGITS = 9;

interface Face {
  readonly line: number;
  /** As they are written, and which points these are, counted from 0. */
  readonly named: readonly string[];
  readonly points: readonly number[];
}

export function readObj(text: string): ReadObj {
  const vertices: Triple[] = [];
  const read: Face[] = [];
  // A line that ends with a backslash goes on in the next one, which is counted all the same.
  const lines = text.replace(/\\(\r\n|\r|\n)/g, "\\").split(/\r\n|\r|\n/);
  let line = 0;
  for (const each of lines) {
    line += 1;
    const begun = line;
    for (let at = each.indexOf("\\"); at >= 0; at = each.indexOf("\\", at + 1)) line += 1;
    const said = (each.includes("#") ? (each.split("#", 1)[0] as string) : each).replaceAll("\\", " ").trim();
    if (!/^[vf](\s|$)/.test(said)) continue;
    const [word, ...rest] = said.split(/\s+/);
    if (word === "v") {
      const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = [Number(rest[0]), Number(rest[1]), Number(rest[2])];
      if (!(Number.isFinite(x) && Number.isFinite(y) && Number.isFinite(z)))
        return { trouble: { code: "point", line: begun } };
      vertices.push([x, y, z]);
    } else {
      // Counted from 1, or from the last one back; what follows a slash are textures and normals.
      const points = rest
        .map((named) => (/^[+-]?\d+(\/|$)/.test(named) ? Number.parseInt(named, 10) : 0))
        .map((index) => (index < 0 ? vertices.length + index : index - 1));
      if (points.length !== 4 && points.length !== 8)
        return { trouble: { code: "corners", line: begun, corners: points.length } };
      read.push({ line: begun, named: rest, points });
    }
  }
  // Points may come after the faces that name them.
  const count = vertices.length;
  for (const { line, named, points } of read) {
    const wrong = points.findIndex((index) => vertices[index] === undefined);
    if (wrong >= 0) return { trouble: { code: "no-point", line, named: named[wrong] ?? "", points: count } };
    if (new Set(points).size < points.length) return { trouble: { code: "repeated", line } };
    if (isCollapsed(points, vertices)) return { trouble: { code: "collapsed", line } };
  }
  const faces = read.map(({ points }) => points);
  if (faces.length === 0) return { trouble: { code: "empty" } };
  if (faces.length > LIMITS.patches) return { trouble: { code: "many", faces: faces.length } };
  const middles = new Map<number, number>();
  const keyOf = (from: number, to: number) => Math.min(from, to) * count + Math.max(from, to);
  // Middles that faces of eight bring along are those of their edges for quads beside them too.
  for (const face of faces) {
    if (face.length === 8)
      for (const side of [0, 2, 4, 6])
        middles.set(keyOf(face[side] as number, face[(side + 2) % 8] as number), face[side + 1] as number);
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
  // What else can be wrong was told by its line.
  return faultOf(network) === null ? { network } : { trouble: { code: "crowded" } };
}

/** Points and patches; parameters and forces have no place in this format. */
export function writeObj({ vertices, patches }: Network): string {
  const points = vertices.map((point) => `v ${point.map((value) => Number(value.toPrecision(DIGITS))).join(" ")}`);
  const faces = patches.map(({ frame }) => `f ${frame.map((index) => index + 1).join(" ")}`);
  return `${[...points, ...faces].join("\n")}\n`;
}

/** Whether two corners of a face are in one place. */
function isCollapsed(points: readonly number[], vertices: readonly Triple[]): boolean {
  const step = points.length / 4;
  const corner = (place: number) => vertices[points[place * step] as number] as Triple;
  for (let one = 0; one < 4; one += 1) {
    const [x, y, z] = corner(one);
    for (let other = one + 1; other < 4; other += 1) {
      const [a, b, c] = corner(other);
      if (x === a && y === b && z === c) return true;
    }
  }
  return false;
}
