import { expect, test } from "vitest";
import type { Network } from "./network";
import { NOTHING, withPatch, withVertex } from "./selection";

/** Two patches beside each other, and one apart. */
const NETWORK: Network = {
  kind: "vertex-frame",
  vertices: Array.from({ length: 21 }, (_, index) => [index, 0, 0] as const),
  patches: [
    { frame: [0, 1, 2, 3, 4, 5, 6, 7] },
    { frame: [2, 8, 9, 10, 11, 12, 4, 3] },
    { frame: [13, 14, 15, 16, 17, 18, 19, 20] },
  ],
};

test("a patch that is picked beside points leaves them picked, and goes without them", () => {
  const point = withVertex(NOTHING, 15, false);
  const both = withPatch(NETWORK, point, 0, true);
  expect([...both.vertices].sort((a, b) => a - b)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 15]);
  expect(withPatch(NETWORK, both, 0, true)).toEqual(point);
  // Of two that have points in common these stay with the one that is left.
  const two = withPatch(NETWORK, both, 1, true);
  expect([...withPatch(NETWORK, two, 0, true).vertices].sort((a, b) => a - b)).toEqual([2, 3, 4, 8, 9, 10, 11, 12, 15]);
  expect(withPatch(NETWORK, both, 1, false).vertices.has(15)).toBe(false);
});
