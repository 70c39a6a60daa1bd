import { expect, test } from "vitest";
import type { Spot } from "./knot";
import { mirrored, sidesOf } from "./sides";

/** Half a vase: foot, belly, neck. */
const HALF: readonly Spot[] = Array.from({ length: 101 }, (_, i) => ({
  x: 300 + 50 * Math.sin((Math.PI * i) / 60),
  y: 400 - 3 * i,
}));

test("a line from foot to rim is one side, whichever way it was drawn and on whichever side", () => {
  const right = sidesOf(HALF, false, 240);
  expect(right).toEqual({ right: HALF, left: null, axis: null });
  expect(sidesOf([...HALF].reverse(), false, 240)).toEqual(right);
  expect(sidesOf(mirrored(HALF, 240), false, 240)?.right.map(({ x, y }) => [x, y])).toEqual(
    HALF.map(({ x, y }) => [x, y]),
  );
});

test("without an axis it is where the line begins, as turners draw it, or beside the line", () => {
  const turned = [{ x: 200, y: 400 }, { x: 250, y: 400 }, ...HALF];
  const found = sidesOf(turned, false, null);
  expect(found?.axis).toBe(200);
  // The floor is no side.
  expect(found?.right[0]).toEqual(HALF[0]);
  const beside = sidesOf(HALF, false, null);
  expect(beside?.axis).toBeLessThan(Math.min(...HALF.map(({ x }) => x)));
});

test("an outline has two sides, with the axis in the middle, and neither floor nor mouth", () => {
  const outline = [...HALF, ...mirrored([...HALF].reverse(), 240)];
  for (const line of [outline, [...outline].reverse(), [...outline.slice(57), ...outline.slice(0, 57)]]) {
    const sides = sidesOf(line, true, null);
    expect(sides?.axis).toBeCloseTo(240, 6);
    for (const side of [sides?.right, sides?.left]) {
      const [first, last] = [side?.[0], side?.at(-1)];
      expect(first?.y).toBeCloseTo(400, 0);
      expect(last?.y).toBeCloseTo(100, 0);
      expect(Math.abs((first?.x ?? 0) - 240)).toBeCloseTo(60, -0.5);
    }
    expect(Math.min(...(sides?.right ?? []).map(({ x }) => x))).toBeGreaterThan(240);
    expect(Math.max(...(sides?.left ?? []).map(({ x }) => x))).toBeLessThan(240);
  }
});

test("from rim to rim in one stroke there are two sides", () => {
  const stroke = [...mirrored([...HALF].reverse(), 240), ...HALF];
  const sides = sidesOf(stroke, false, 240);
  expect(sides?.right).toEqual(HALF);
  expect(sides?.left?.map(({ x, y }) => [x, y])).toEqual(mirrored(HALF, 240).map(({ x, y }) => [x, y]));
});

test("what is level or no line has no sides", () => {
  expect(
    sidesOf(
      [
        { x: 0, y: 5 },
        { x: 9, y: 5 },
      ],
      false,
      null,
    ),
  ).toBeNull();
  expect(sidesOf([], false, null)).toBeNull();
  expect(sidesOf([{ x: 1, y: 1 }], true, 0)).toBeNull();
});
