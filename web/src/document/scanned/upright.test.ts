import { expect, test } from "vitest";
import type { Levels } from "../types";
import { UPS, unroundness, upright } from "./upright";

/** What becomes of a point whose only number other than 0 is `value` at `axis`. */
const turned = (axis: number, value: number, up: (typeof UPS)[number]) => {
  const point = new Float32Array(3);
  point[axis] = value;
  return [...upright(point, up)].map((each) => each + 0);
};

test.each(UPS)("where %s is up it is so after that, and nothing is seen in the mirror", (up) => {
  const axis = "xyz".indexOf(up.at(-1) as string);
  expect(turned(axis, up.startsWith("-") ? -7 : 7, up)).toEqual([0, 0, 7]);
  const [[a = 0, b = 0, c = 0], [d = 0, e = 0, f = 0], [g = 0, h = 0, i = 0]] = [0, 1, 2].map((k) =>
    turned(k, 1, up),
  ) as [number[], number[], number[]];
  expect(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)).toBe(1);
});

test("every triangle is turned, as modellers have it", () => {
  expect([...upright(Float32Array.of(1, 2, 3, 0, 1, 0, 0, 0, 1), "y")]).toEqual([1, -3, 2, 0, -0, 1, 0, -1, 0]);
});

test("circles are round, and what is not closed all round counts against it", () => {
  const levels = (heights: readonly number[], radius: (k: number) => number): Levels => ({
    axis: [0, 0],
    bottom: 0,
    height: 2,
    heights: Float64Array.from(heights),
    radii: heights.map(() => Float64Array.from({ length: 180 }, (_, k) => radius(k))),
    holes: 0,
  });
  expect(unroundness(levels([0, 1, 2], () => 5))).toBe(0);
  const wavy = (k: number) => 5 + Math.cos((Math.PI * k) / 30);
  expect(unroundness(levels([0, 1, 2], wavy))).toBeCloseTo(0.2 * Math.SQRT1_2, 12);
  expect(unroundness(levels([0, 1], wavy))).toBeCloseTo(0.4 * Math.SQRT1_2, 12);
});
