import { expect, test } from "vitest";
import type { Levels } from "./levels";
import { DIRECTIONS } from "./section";
import { frontOf, seenAt, widestOf } from "./seen";

const round = new Float64Array(DIRECTIONS).fill(3);
/** With something that stands out to one side. */
const spouted = round.map((radius, k) => (k === 45 ? 5 : radius));
const SCAN: Levels = { axis: [0, 0], bottom: 0, height: 2, heights: [0, 1, 2], radii: [round, spouted, round] };

test("a scan is seen with what stands out of it at the side", () => {
  expect(widestOf(SCAN)).toBe(5);
  expect(frontOf(SCAN)).toBe(45);
  expect(seenAt(spouted, 45)).toBe(5);
  // From the front a spout hides in what is behind it.
  expect(seenAt(spouted, 0)).toBeCloseTo(3, 12);
  expect(seenAt(round, 17)).toBeCloseTo(3, 12);
});
