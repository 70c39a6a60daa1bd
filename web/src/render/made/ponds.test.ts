import { expect, test } from "vitest";
import { ponds } from "./ponds";

test("triangles that share vertices are one pond, in whatever order they come", () => {
  const square = (x: number) => [x, 0, 1, x + 2, 0, 1, x + 2, 2, 1, x, 2, 1];
  const positions = new Float32Array([...square(0), ...square(10)]);
  const { indices, ranges } = ponds(positions, Uint32Array.of(0, 1, 2, 4, 5, 6, 2, 3, 0, 6, 7, 4));
  expect(ranges).toEqual([
    { at: [1, 1], range: [0, 6] },
    { at: [11, 1], range: [6, 6] },
  ]);
  expect([...indices]).toEqual([0, 1, 2, 2, 3, 0, 4, 5, 6, 6, 7, 4]);
});

test("no water is no pond", () => {
  expect(ponds(new Float32Array(), new Uint32Array()).ranges).toEqual([]);
});
