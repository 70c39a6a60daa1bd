import { expect, test } from "vitest";
import { type Outline, placeOf } from "./places";

/** A bottle: a foot of 2, a belly of 4, a shoulder that leans in, a narrow neck and a rim that flares. */
const BOTTLE: Outline = [
  [0, 2],
  [2, 3.4],
  [4, 4],
  [5, 3.6],
  [6, 2],
  [7, 1.2],
  [9, 1.1],
  [10, 1.5],
];
/** A bowl, widest at its rim. */
const BOWL: Outline = [
  [0, 1],
  [1, 3],
  [3, 4.5],
  [5, 5],
];

test.each([
  [0.2, "foot"],
  [1.5, "foot"],
  [3, "belly"],
  [4.2, "belly"],
  [5.6, "shoulder"],
  [6.5, "shoulder"],
  [8, "neck"],
  [9.2, "neck"],
  [9.9, "rim"],
] as const)("a bottle has at %d its %s", (z, name) => {
  expect(placeOf([0, 0, z], BOTTLE)).toBe(name);
});

test.each([
  [0.1, "foot"],
  [0.8, "foot"],
  [3, "middle"],
  [4.9, "rim"],
] as const)("a bowl has at %d its %s", (z, name) => {
  expect(placeOf([0, 0, z], BOWL)).toBe(name);
});

test("a plate without height and an outline without rings have a middle", () => {
  expect(placeOf([0, 0, 0], [])).toBe("middle");
  expect(placeOf([0, 0, 1], [[1, 2]])).toBe("middle");
});
