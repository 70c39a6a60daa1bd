import { expect, test } from "vitest";
import { loftShares } from "./loft";

test("a loft has the positions and tangents of its sections", () => {
  const tapers = [0.4, -0.3] as const;
  expect([loftShares(0, tapers), loftShares(1, tapers)]).toEqual([
    [1, 0],
    [0, 1],
  ]);
  const step = 1e-6;
  for (const [w, from, leaves] of [
    [0, [1, 0], [0.4, 0]],
    [1, [0, 1], [0, -0.3]],
  ] as const) {
    const near = loftShares(w === 0 ? step : 1 - step, tapers);
    for (const end of [0, 1] as const) {
      const slope = ((near[end] - from[end]) / step) * (w === 0 ? 1 : -1);
      expect(slope).toBeCloseTo(leaves[end], 4);
    }
  }
});
