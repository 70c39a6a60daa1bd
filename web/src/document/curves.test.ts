import init, { evaluate } from "pasu/drawing";
import { beforeAll, expect, test } from "vitest";
import { BOTTLE, WRITTEN } from "../../testing/bottle";
import { curvesOf, curveUnder, pointOn, withoutCurve } from "./curves";
import type { BoundaryValue, Rings, Sent, Shape } from "./types";

const JUST_A_VASE: Shape = { kind: "second-order", r: [1, 0.1, 0.6, 0.06] };

beforeAll(() => init());

const onSurface = (shape: Shape, u: number, v: number) =>
  evaluate({ pasu: 1, parts: [{ shape }] } as unknown as Sent, 0, [u, v]);

test("a curve is where the solver has it", () => {
  for (const shape of [BOTTLE, WRITTEN]) {
    for (const { u, index } of curvesOf(shape)) {
      for (const v of [0, 0.7, 2, 5.5]) {
        const point = pointOn(shape, index, v) ?? [];
        expect(point).toHaveLength(3);
        for (const [axis, value] of onSurface(shape, u, v).entries()) expect(point[axis]).toBeCloseTo(value, 10);
      }
    }
  }
});

test("ends come first and last, and a family of numbers has none", () => {
  expect(curvesOf(BOTTLE).map(({ u, end }) => [u, end])).toEqual([
    [0, true],
    [0.35, false],
    [0.7, false],
    [1, true],
  ]);
  expect(curvesOf(WRITTEN)).toEqual(curvesOf(BOTTLE));
  expect(curvesOf(JUST_A_VASE)).toEqual([]);
  expect(pointOn(JUST_A_VASE, 0, 0)).toBeNull();
  expect(pointOn(BOTTLE, 4, 0)).toBeNull();
});

test("a hand takes hold of the ring that is near", () => {
  expect(curveUnder(BOTTLE, 0.36)?.index).toBe(1);
  expect(curveUnder(WRITTEN, 0.99)?.index).toBe(3);
  expect(curveUnder(BOTTLE, 0.5)).toBeNull();
  expect(curveUnder(JUST_A_VASE, 0)).toBeNull();
});

test("a ring goes with all its data, and an end stays", () => {
  const less = withoutCurve(BOTTLE, 1) as Rings;
  expect(less.rings.map(({ u }) => u)).toEqual([0, 0.7, 1]);
  expect(withoutCurve(BOTTLE, 0)).toBe(BOTTLE);
  expect(withoutCurve(WRITTEN, 3)).toBe(WRITTEN);
  expect(withoutCurve(JUST_A_VASE, 1)).toBe(JUST_A_VASE);
  const written = withoutCurve(WRITTEN, 1) as BoundaryValue;
  expect(written.rings).toEqual([{ u: 0.7 }]);
  expect(written.x.modes[0]?.cos).toEqual({ start: 3, end: 2.2, rings: [1.6] });
  const none = withoutCurve(written, 1) as BoundaryValue;
  expect("rings" in none).toBe(false);
  expect(none.y.modes[0]?.sin).toEqual({ start: 3, end: 2.2 });
  // What is left is a design.
  for (const shape of [less, written, none]) expect(onSurface(shape, 0.5, 1).every(Number.isFinite)).toBe(true);
});
