import { expect, test } from "vitest";
import { arrowOf, reachOf } from "./handles";

test("an arrow is a step, with shift ten, and no other key is one", () => {
  expect(arrowOf({ key: "ArrowUp", shiftKey: false })).toEqual({ right: 0, up: 1 });
  expect(arrowOf({ key: "ArrowLeft", shiftKey: true })).toEqual({ right: -10, up: 0 });
  expect(arrowOf({ key: "Enter", shiftKey: true })).toBeNull();
});

test("handles share what is between them, and none is too small for a finger or larger than it needs to be", () => {
  const here = { x: 10, y: 10 };
  expect(reachOf(here, [], 7, 15)).toBe(15);
  expect(
    reachOf(
      here,
      [
        { x: 10, y: 90 },
        { x: 30, y: 10 },
      ],
      7,
      15,
    ),
  ).toBe(10);
  expect(reachOf(here, [here], 7, 15)).toBe(7);
});
