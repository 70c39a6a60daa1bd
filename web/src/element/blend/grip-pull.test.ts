import { expect, test } from "vitest";
import type { Triple } from "../../document/types";
import { followed } from "./grip-pull";

/** Seen from the front: x to the right, z up, ten pixels for each unit. */
const front = ([x, , z]: Triple) => ({ x: 10 * x, y: -10 * z });

test("a grip of one way goes along it, whatever else the hand does", () => {
  expect(followed(front, [1, 0, 0], [[0, 0, 1]], { x: 55, y: -20 })).toEqual([2]);
  expect(followed(front, [1, 0, 0], [[2, 0, 0]], { x: 30, y: 7 })).toEqual([1.5]);
});

test("a grip of two ways is under the hand", () => {
  const [out, up] = followed(
    front,
    [3, 0, 1],
    [
      [0.5, 0.5, 0],
      [0, 0, 0.25],
    ],
    { x: 10, y: -5 },
  );
  expect(out).toBeCloseTo(2, 10);
  expect(up).toBeCloseTo(2, 10);
});

test("what is seen end on stays, and what is out of sight too", () => {
  expect(followed(front, [1, 0, 0], [[0, 1, 0]], { x: 55, y: -20 })).toEqual([0]);
  expect(followed(() => null, [1, 0, 0], [[0, 0, 1]], { x: 1, y: 1 })).toEqual([0]);
  const [across, up] = followed(
    front,
    [1, 0, 0],
    [
      [0, 1, 0],
      [0, 0, 1],
    ],
    { x: 5, y: -20 },
  );
  expect([across, up]).toEqual([0, 2]);
});
