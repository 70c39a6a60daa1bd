import { expect, test } from "vitest";
import { boxOf } from "./box";
import { boxAround, handy, longestOf, middleOf, roundStep, roundTo, tableUnder } from "./boxes";

test("the box of points, and of boxes", () => {
  const box = boxOf([1, 2, 3, -1, 5, 0]);
  expect(box).toEqual({ min: [-1, 2, 0], max: [1, 5, 3] });
  expect(boxOf([])).toBeNull();
  expect(boxAround([])).toBeNull();
  const all = boxAround([
    { min: [-1, 2, 0], max: [1, 5, 3] },
    { min: [0, 0, -2], max: [4, 1, 0] },
  ]);
  expect(all).toEqual({ min: [-1, 0, -2], max: [4, 5, 3] });
  expect(all && middleOf(all)).toEqual([1.5, 2.5, 0.5]);
  expect(all && longestOf(all)).toBe(5);
});

test("numbers of a hand are round", () => {
  expect(handy([3.00000012, -1e-9, 0.12345], 10)).toEqual([3, 0, 0.12]);
  expect(roundTo(1.26, 0.25)).toBe(1.25);
  expect([0.34, 0.5, 1, 1.9, 2, 7, 49].map(roundStep)).toEqual([0.2, 0.5, 1, 1, 2, 5, 20]);
});

test("the table is where the others stand, and never in the air", () => {
  expect(tableUnder([])).toBe(0);
  expect(tableUnder([{ min: [0, 0, 15], max: [1, 1, 18] }])).toBe(0);
  expect(tableUnder([{ min: [0, 0, -3], max: [1, 1, 18] }])).toBe(-3);
});
