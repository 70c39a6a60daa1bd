import { expect, it } from "vitest";
import { extentsOf } from "../../document/extents";
import { boundsOf } from "../../solver/bounds";
import type { Triple } from "../triple";
import { dimensionsOf } from "./dimensions";

const OVAL = new Float32Array([-1, -2, 0, 1, -2, 6, 1, 2, 6, -1, 2, 0, 0, -2.2, 0, 0, 2.2, 0]);

/** The bounds and the size of points. */
function both(points: Float32Array) {
  const [bounds, size] = [boundsOf(points), extentsOf(points)];
  if (!bounds || !size) throw new Error("no points");
  return { bounds, size };
}

it("measures height, greatest and least width beside the pot, wherever the eye is", () => {
  const { bounds, size } = both(OVAL);
  for (let a = 0; a < 6.3; a += 0.3) {
    const towards = [Math.cos(a), Math.sin(a)] as const;
    const dimensions = dimensionsOf(bounds, towards, size);
    // From corner to corner, the longest way; square to the long sides, the shortest.
    expect(dimensions.map((d) => d.length)).toEqual([6, size.greatest.width, size.least.width]);
    expect(size.greatest.width).toBeCloseTo(Math.hypot(2, 4), 6);
    expect(size.least.width).toBeCloseTo(2, 6);
    for (const { label, segments, length } of dimensions) {
      expect(Math.abs(label[0]) > 1 || Math.abs(label[1]) > 2.2).toBe(true);
      const [x, y, z, p, q, r] = segments as [number, number, number, number, number, number];
      expect(Math.hypot(p - x, q - y, r - z)).toBeCloseTo(length, 5);
    }
    // The widths lie on the sides that face the eye, the height at the left of the picture.
    const [height, greatest, least] = dimensions.map((d) => d.label) as [Triple, Triple, Triple];
    for (const [x, y] of [greatest, least]) expect(x * towards[0] + y * towards[1]).toBeGreaterThanOrEqual(-1e-9);
    expect(height[0] * towards[1] - height[1] * towards[0]).toBeGreaterThan(0);
  }
});

it("says the number that it is given, and one width of what is round", () => {
  const { bounds, size } = both(OVAL);
  const measured = {
    ...size,
    height: 6.1,
    greatest: { ...size.greatest, width: 4 },
    least: { ...size.least, width: 4 },
  };
  expect(dimensionsOf(bounds, [1, 0], measured).map((d) => d.length)).toEqual([6.1, 4]);
});

it("leaves out what has no length", () => {
  const { bounds, size } = both(new Float32Array([0, 0, 1, 3, 0, 1]));
  expect(dimensionsOf(bounds, [1, 0], size).map((d) => d.length)).toEqual([3]);
});
