import { expect, test } from "vitest";
import type { Design } from "../document/types";
import { type Face, type SolidArrays, solidOf } from "./solid";

/** One triangle for each kind of face, at heights 0, 1, 2 ..., each with vertices of its own. */
function made(kinds: readonly string[], part = 0): SolidArrays {
  const positions = kinds.flatMap((_, i) => [0, 0, i, 2, 0, i, 0, 2, i]);
  const faces: Face[] = kinds.map((kind, i) => ({ kind, part, first: 3 * i, count: 3 }));
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(positions.length),
    indices: Uint32Array.from({ length: 3 * kinds.length }, (_, i) => i),
    faces,
  };
}

const design = (side?: "inside" | "outside"): Design =>
  ({ pasu: 1, parts: [{ shape: {}, wall: { thickness: 1, base: 1, ...(side && { side }) } }] }) as unknown as Design;

const KINDS = ["underside", "outer", "floor", "lining", "rim"];

test("the face that the surface shows already is left out", () => {
  const inside = solidOf(design(), made(KINDS));
  expect([...inside.indices]).toEqual([0, 1, 2, 6, 7, 8, 9, 10, 11, 12, 13, 14]);
  expect([...inside.groups]).toEqual([0, 3, 0, 3, 3, 0, 6, 3, 0, 9, 3, 0]);
  expect(inside.sides).toEqual(["inside"]);
  const outside = solidOf(design("outside"), made(KINDS));
  expect([...outside.indices].includes(3)).toBe(true);
  expect([...outside.indices].includes(9)).toBe(false);
});

test("it tells from which height to which the outside stands, where the surface does not show it", () => {
  expect(solidOf(design(), made(KINDS)).outsides).toEqual([null]);
  const { positions, ...rest } = made(KINDS);
  // The first corner of the outer face, which is at a height of 1.
  positions[3 * 3 + 2] = -2;
  expect(solidOf(design("outside"), { positions, ...rest }).outsides).toEqual([[-2, 1]]);
});

test("the glaze knows the lining, thins at the rim and leaves what stands on the table bare", () => {
  const { wares } = solidOf(design(), made(KINDS));
  const of = (kind: string) => [...wares.subarray(12 * KINDS.indexOf(kind), 12 * KINDS.indexOf(kind) + 4)];
  expect(of("lining")[0]).toBe(1);
  expect(of("floor")[0]).toBe(1);
  expect(of("rim")[0]).toBe(0);
  expect(of("rim")[1]).toBeLessThan(of("lining")[1] ?? 0);
  expect(of("underside")[2]).toBeLessThan(0);
  // The mouth is 1 in radius and 4 high.
  expect(of("floor")[3]).toBe(2);
});

test("a design without a solid has nothing to draw", () => {
  const { indices, bounds } = solidOf(design(), made([]));
  expect(indices.length).toBe(0);
  expect(bounds).toBeNull();
});
