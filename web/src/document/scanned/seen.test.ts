import { expect, test } from "vitest";
import type { Levels } from "../types";
import { directionsOf, frontOf, piecesSeen, seenAt, widestOf } from "./seen";

const [DIRECTIONS, COLUMNS] = [180, 60];
const round = new Float64Array(DIRECTIONS).fill(3);
/** With something that stands out to one side. */
const spouted = round.map((radius, k) => (k === 45 ? 5 : radius));
const SCAN: Levels = {
  axis: [0, 0],
  bottom: 0,
  height: 2,
  heights: Float64Array.of(0, 1, 2),
  radii: [round, spouted, round],
};

test("a scan is seen with what stands out of it at the side", () => {
  expect(directionsOf(SCAN)).toBe(DIRECTIONS);
  expect(widestOf(SCAN)).toBe(5);
  expect(frontOf(SCAN)).toBe(45);
  expect(seenAt(spouted, 45)).toBe(5);
  // From the front a spout hides in what is behind it.
  expect(seenAt(spouted, 0)).toBeCloseTo(3, 12);
  expect(seenAt(round, 17)).toBeCloseTo(3, 12);
});

test("half of the outside is seen, from the back to the front, with how far off it is", () => {
  const even: Levels = { ...SCAN, radii: [round, round, round] };
  // One direction of the middle level is off.
  const away = new Float32Array(3 * COLUMNS);
  away[COLUMNS + 45] = 8;
  const pieces = piecesSeen(even, away, 0);
  expect(pieces).toHaveLength(COLUMNS);
  expect(pieces.every(({ corners }) => corners.every(([x, y]) => Math.abs(x) <= 3 && y >= 0 && y <= 2))).toBe(true);
  // At a quarter turn back it is in the middle, nearest to the eye, in four pieces.
  const off = pieces.filter((piece) => piece.away !== 0);
  expect(off.map((piece) => piece.away)).toEqual([2, 2, 2, 2]);
  expect(off.every(({ corners }) => corners.every(([x]) => Math.abs(x) < 0.4))).toBe(true);
  expect(pieces.slice(-4)).toEqual(off);
  // From the other side it is not.
  expect(piecesSeen(even, away, DIRECTIONS / 2).filter((piece) => piece.away !== 0)).toEqual([]);
});
