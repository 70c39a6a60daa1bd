import { expect, test } from "vitest";
import { paintedOf } from "./painted";

test("the range is that of nearly all values", () => {
  const values = Float32Array.from({ length: 1001 }, (_, i) => (i === 7 ? 1e6 : i));
  const painted = paintedOf({ values, least: 0, greatest: 1e6 });
  expect(painted.low).toBeCloseTo(20, -1);
  expect(painted.high).toBeCloseTo(980, -1);
  expect(painted.greatest).toBe(1e6);
});

test("no values and values that are none have a range too", () => {
  expect(paintedOf({ values: new Float32Array(), least: 0, greatest: 0 })).toMatchObject({ low: 0, high: 0 });
  const values = new Float32Array([Number.NaN, 2, 2]);
  expect(paintedOf({ values, least: 2, greatest: 2 })).toMatchObject({ low: 2, high: 2 });
});
