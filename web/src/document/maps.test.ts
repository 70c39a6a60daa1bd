import { expect, test } from "vitest";
import { MAPS, mapOf, scaleOf } from "./maps";

test("colours with a middle have 0 there, where values are on both sides", () => {
  const map = mapOf("mean-curvature");
  expect(scaleOf(map, -1, 3)).toMatchObject({ low: -3, high: 3, ramp: map.ramp, rises: false });
  expect(scaleOf(map, 1, 3)).toMatchObject({ low: 1, high: 3, ramp: mapOf("thickness").ramp });
  expect(scaleOf(map, 1, 3).rises).toBe(true);
});

test("a range is never empty", () => {
  for (const map of MAPS) {
    for (const value of [0.3, 0, -2]) {
      const { low, high } = scaleOf(map, value, value);
      expect(high).toBeGreaterThan(low);
    }
  }
  expect(scaleOf(mapOf("thickness"), 0.2, 0.3)).toMatchObject({ low: 0.2, high: 0.3 });
});

test("overhangs are compared with all that there can be", () => {
  expect(scaleOf(mapOf("overhang"), 3, 20)).toMatchObject({ low: 0, high: 90 });
});
