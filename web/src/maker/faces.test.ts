import { expect, test } from "vitest";
import { NETWORKED } from "../document/gallery/networks";
import { readObj, writeObj } from "../document/network/obj";
import { networkOfFaces, readFaces } from "./faces";

const read = (text: string) => readFaces(new TextEncoder().encode(text));

test.each(NETWORKED.map(({ id, shape }) => [id, shape] as const))(
  "%s is the same network on both sides",
  (_, shape) => {
    if (shape.kind !== "vertex-frame") throw new Error(shape.kind);
    const text = writeObj(shape);
    const faces = read(text);
    if ("trouble" in faces) throw new Error(faces.trouble.code);
    expect({ network: networkOfFaces(faces) }).toEqual(readObj(text));
  },
);

test("what is no network is told as it is found, a mark before the text or not", () => {
  expect(read("v 0 0 0\nf 1 2 3\n")).toEqual({ trouble: { code: "corners", line: 2, corners: 3 } });
  expect(read("")).toEqual({ trouble: { code: "empty" } });
  const quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  expect(read(`\ufeff${quad}`)).toEqual(read(quad));
});
