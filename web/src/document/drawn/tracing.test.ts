import { expect, test } from "vitest";
import type { Spot } from "./knot";
import { lineOn, MARGIN, SHEET, type Sheet, withSymmetry } from "./sheet";
import { mirrored } from "./sides";
import type { Picture } from "./silhouette";
import { linesOnSheet, sidesSeen, withOutline, withStroke } from "./tracing";

const EMPTY: Sheet = { right: [], left: null, axis: 240, height: 20 };

/** Foot, belly, neck, on the right. */
const HALF: readonly Spot[] = Array.from({ length: 101 }, (_, i) => ({
  x: 300 + 50 * Math.sin((Math.PI * i) / 60),
  y: 400 - 3 * i,
}));
const WIDER = HALF.map(({ x, y }) => ({ x: x + 40, y }));

const mean = (line: readonly Spot[]) => line.reduce((sum, { x }) => sum + x, 0) / line.length;

test("an outline that is the same on both sides is one line, and one that is not is two", () => {
  const same = withOutline(EMPTY, { right: HALF, left: mirrored(HALF, 200), axis: 200 }, 0);
  expect(same).toMatchObject({ left: null, axis: 200, height: 20 });
  const apart = withOutline(EMPTY, { right: HALF, left: mirrored(WIDER, 240), axis: null }, 0);
  expect(apart?.axis).toBe(240);
  expect(apart?.left?.length).toBeGreaterThan(2);
  const level = HALF.slice(0, 1);
  expect(withOutline(EMPTY, { right: level, left: null, axis: null }, 0)).toBeNull();
});

test("a stroke is both sides where they are alike, else the one that it is on", () => {
  const right = withStroke(EMPTY, HALF);
  expect(right?.left).toBeNull();
  expect(mean(right ? lineOn(right, "right") : [])).toBeCloseTo(mean(HALF), 0);
  // Drawn on the left of an axis that both sides share, it is seen in the mirror.
  expect(mean(withStroke(EMPTY, mirrored(HALF, 240))?.right ?? [])).toBeGreaterThan(240);
  const both = withSymmetry(right as Sheet, false);
  const wider = withStroke(both, WIDER);
  expect(wider?.left).toBe(both.left);
  expect(mean(wider?.right ?? [])).toBeGreaterThan(mean(both.right) + 20);
  const left = withStroke(both, mirrored(WIDER, 240));
  expect(left?.right).toBe(both.right);
  expect(mean(left?.left ?? [])).toBeLessThan(mean(both.left ?? []) - 20);
  expect(withStroke(EMPTY, HALF.slice(0, 1))).toBeNull();
});

test("a pot on a photograph stands where the photograph lies on the sheet", () => {
  const [width, height] = [120, 160];
  const data = new Uint8ClampedArray(4 * width * height).fill(220);
  for (let y = 30; y < 140; y += 1)
    for (let x = 40; x < 80; x += 1) data.fill(40, 4 * (y * width + x), 4 * (y * width + x) + 3);
  const picture: Picture = { width, height, data };
  const sides = sidesSeen(picture, { x: 100, y: 50 }, 0);
  expect(sides?.left).toBeNull();
  expect(sides?.axis).toBeCloseTo(160, 0);
  const [foot, belly] = [sides?.right[0], sides?.right[50]];
  expect(foot?.y).toBeCloseTo(189.5, 0);
  expect(belly?.x).toBeCloseTo(180, 0);
  expect(sidesSeen({ width, height, data: new Uint8ClampedArray(data.length).fill(9) }, { x: 0, y: 0 }, 0)).toBeNull();
});

test("lines of whatever size fill the sheet, and what has no size is none", () => {
  const right = Float64Array.from([3, 0, 6, 10, 2, 30]);
  const left = right.map((value, i) => (i % 2 === 0 ? -value : value));
  for (const times of [1e-6, 1, 1e6]) {
    const lines = linesOnSheet([right.map((value) => times * value), left.map((value) => times * value)], 240);
    const ys = lines.flat().map(({ y }) => y);
    expect(Math.min(...ys)).toBeCloseTo(MARGIN, 6);
    expect(Math.max(...ys)).toBeCloseTo(SHEET - MARGIN, 6);
    expect(lines[1]?.[0]?.x).toBeCloseTo(480 - (lines[0]?.[0]?.x ?? 0), 6);
  }
  expect(linesOnSheet([], 240)).toEqual([]);
  expect(linesOnSheet([new Float64Array(4)], 240)).toEqual([]);
});
