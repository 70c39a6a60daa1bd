import { expect, test } from "vitest";
import { NETWORKED } from "../gallery/networks";
import { edgesOf, isFree } from "./network";
import { type ObjTrouble, readObj, writeObj } from "./obj";

const CUBE = `# a cube
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
v 9 9 9
vn 0 0 1
f 4//1 3//1 2//1 1//1
f 5/1 6/2 7/3 8/4
f 1 2 6 5
f 2 3 7 6
f -6 -5 -2 -1
f 4 1 5 8
`.replace("f -6 -5 -2 -1", "f 3 4 -2 -3");

test("quads become patches whose edges have middles in common", () => {
  const read = readObj(CUBE);
  if ("trouble" in read) throw new Error(read.trouble.code);
  const { vertices, patches } = read.network;
  // Eight corners and twelve middles; what no face uses is left out.
  expect([vertices.length, patches.length]).toEqual([20, 6]);
  expect([...edgesOf(read.network).values()].filter(isFree)).toEqual([]);
  expect(vertices).toContainEqual([0.5, 0, 0]);
});

test("what is written is read again", () => {
  for (const { shape } of NETWORKED) {
    if (shape.kind !== "vertex-frame") throw new Error(shape.kind);
    const read = readObj(writeObj(shape));
    if ("trouble" in read) throw new Error(read.trouble.code);
    expect(read.network.vertices).toEqual(shape.vertices);
    expect(read.network.patches.map(({ frame }) => frame)).toEqual(shape.patches.map(({ frame }) => frame));
  }
});

test("files that hold no network say why", () => {
  const points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
  const trouble = (text: string) => (readObj(text) as { trouble?: ObjTrouble }).trouble;
  expect(trouble(points)).toEqual({ code: "empty" });
  expect(trouble(`${points}f 1 2 3\n`)).toEqual({ code: "corners", line: 9, corners: 3 });
  expect(trouble(`${points}f 1 2 3 4 5\n`)).toEqual({ code: "corners", line: 9, corners: 5 });
  const named = (text: string) => ({ code: "no-point", line: 9, named: text, points: 8 });
  for (const index of ["99", "0", "-9", "x", "1.5"])
    expect(trouble(`${points}f 1 2 3 ${index}\n`)).toEqual(named(index));
  expect(trouble(`${points}f 1 2 3 1\n`)).toEqual({ code: "repeated", line: 9 });
  expect(trouble(`${points}v 0 -0 0\nf 1 2 3 9\n`)).toEqual({ code: "collapsed", line: 10 });
  expect(trouble(`${points}v 0 0 0\nf 1 2 9 4 3 6 7 8\n`)).toEqual({ code: "collapsed", line: 10 });
  // Middles may be where corners are, and other points too.
  expect(trouble(`${points}v 0 0 0\nf 1 9 2 5 3 6 4 8\n`)).toBeUndefined();
  expect(trouble(`${points}f\n`)).toEqual({ code: "corners", line: 9, corners: 0 });
  expect(trouble(`vt 1 0\nvn x\nface 1\nv\n`)).toEqual({ code: "point", line: 4 });
  expect(trouble("v 0 0 1\nv 0 0 x\n")).toEqual({ code: "point", line: 2 });
  expect(trouble("v 0 0\n")).toEqual({ code: "point", line: 1 });
  expect(trouble(`${points}f 1 2 3 4\nf 1 2 6 5\nf 1 2 8 7\n`)).toEqual({ code: "crowded" });
  const many = "f 1 2 3 4\n".repeat(100_001);
  expect(trouble(points + many)).toEqual({ code: "many", faces: 100_001 });
  // Lines are counted as an editor counts them.
  expect(trouble(`${points}f 1 2 \\\n 3 4\nf 1 2 3\n`)).toEqual({ code: "corners", line: 11, corners: 3 });
});

test("a file is read whatever its lines end with, with remarks behind them, and with its points last", () => {
  const quad = "v 0 0 0\nv 1 0 0 0.5 0.5 0.5 # red\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//1 \\\n3/3 4 # one\n";
  const made = readObj(quad);
  expect("network" in made && made.network.patches).toHaveLength(1);
  for (const end of ["\r\n", "\r"]) expect(readObj(quad.replaceAll("\n", end))).toEqual(made);
  const [face, points] = [quad.slice(quad.indexOf("f ")), quad.slice(0, quad.indexOf("f "))];
  expect(readObj(face + points)).toEqual(made);
});
