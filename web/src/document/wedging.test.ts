import { expect, test } from "vitest";
import { WET_DENSITY, wedging } from "./wedging";

test("a pot begins as large as the clay shrinks, and with what is trimmed", () => {
  // 10 % in each direction: 1 / 0.9^3 of the volume.
  const { pot, allowance, all } = wedging(729, 10, 20);
  expect(pot).toBeCloseTo(1000 * WET_DENSITY, 9);
  expect(allowance).toBeCloseTo(200 * WET_DENSITY, 9);
  expect(all).toBeCloseTo(1200 * WET_DENSITY, 9);
});

test("clay that does not shrink and is not trimmed is what the pot is", () => {
  expect(wedging(100, 0, 0)).toEqual({ pot: 100 * WET_DENSITY, allowance: 0, all: 100 * WET_DENSITY });
});
