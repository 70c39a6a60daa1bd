import { expect, it } from "vitest";
import { boundsOf } from "../../solver/bounds";
import type { Triple } from "../triple";
import { dimensionsOf } from "./dimensions";

const bounds = boundsOf(new Float32Array([-1, -2, 0, 1, 2, 6]));

it("measures height, width and depth beside the pot, wherever the eye is", () => {
  if (!bounds) throw new Error("bounds");
  for (let a = 0; a < 6.3; a += 0.3) {
    const towards = [Math.cos(a), Math.sin(a)] as const;
    const dimensions = dimensionsOf(bounds, towards);
    expect(dimensions.map((d) => d.length)).toEqual([6, 2, 4]);
    for (const { label } of dimensions) {
      // Never inside the box.
      expect(Math.abs(label[0]) > 1 || Math.abs(label[1]) > 2).toBe(true);
    }
    // Width and depth lie on the sides that face the eye, the height at the left of the picture.
    const [height, width, depth] = dimensions.map((d) => d.label) as [Triple, Triple, Triple];
    expect(width[1] * towards[1]).toBeGreaterThanOrEqual(-1e-9);
    expect(depth[0] * towards[0]).toBeGreaterThanOrEqual(-1e-9);
    expect(height[0] * towards[1] - height[1] * towards[0]).toBeGreaterThan(0);
  }
});

it("leaves out what has no length", () => {
  const flat = boundsOf(new Float32Array([0, 0, 1, 3, 0, 1]));
  if (!flat) throw new Error("bounds");
  expect(dimensionsOf(flat, [1, 0]).map((d) => d.length)).toEqual([3]);
});
