import { expect, test } from "vitest";
import { colourAt, DIVERGING, MAPS, mapOf, scaleOf } from "./maps";

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

test("colours go from one of the ramp to the next, and end where it ends", () => {
  expect([-1, 0, 0.5, 1, 7].map((share) => colourAt(DIVERGING, share))).toEqual([
    DIVERGING[0],
    DIVERGING[0],
    DIVERGING[2],
    DIVERGING[4],
    DIVERGING[4],
  ]);
  expect(
    colourAt(
      [
        [0, 10, 100],
        [100, 20, 0],
      ],
      0.25,
    ),
  ).toEqual([25, 13, 75]);
});
