import { expect, test } from "vitest";
import { NETWORKED } from "../gallery/networks";
import { edgesOf, isFree } from "./network";
import { readObj, writeObj } from "./obj";

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
  if ("trouble" in read) throw new Error(read.trouble);
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
    if ("trouble" in read) throw new Error(read.trouble);
    expect(read.network.vertices).toEqual(shape.vertices);
    expect(read.network.patches.map(({ frame }) => frame)).toEqual(shape.patches.map(({ frame }) => frame));
  }
});

test("files that hold no network say why", () => {
  const points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
  expect(readObj(points)).toEqual({ trouble: "empty" });
  expect(readObj(`${points}f 1 2 3\n`)).toEqual({ trouble: "faces" });
  expect(readObj(`${points}f 1 2 3 99\n`)).toEqual({ trouble: "broken" });
  expect(readObj(`${points}f 1 2 3 1\n`)).toEqual({ trouble: "broken" });
  expect(readObj("v 0 0 x\n")).toEqual({ trouble: "broken" });
  expect(readObj(`${points}f 1 2 3 4\nf 1 2 6 5\nf 1 2 8 7\n`)).toEqual({ trouble: "crowded" });
});
