import { expect, test } from "vitest";
import { curveThrough } from "./curve";
import { between, evenly, lengthOf, type Spot } from "./knot";
import { awayFrom, knotsOf } from "./stroke";

/** How far the points of one line are from another at most. */
function off(line: readonly Spot[], from: readonly Spot[]): number {
  const away = (spot: Spot) => Math.min(...from.slice(1).map((end, i) => awayFrom(spot, from[i] as Spot, end)));
  return Math.max(...line.map(away));
}

/** A belly above a foot, as a hand draws it: trembling, unevenly fast. */
function belly(tremble: number): readonly Spot[] {
  return Array.from({ length: 300 }, (_, i) => {
    const share = (i / 299) ** 1.3;
    const shake = tremble * Math.sin(i * 12.9898) * Math.cos(i * 78.233);
    return { x: 300 + 60 * Math.sin(Math.PI * share) + shake, y: 430 - 380 * share - shake };
  });
}

test("a line is run through evenly, from end to end", () => {
  const even = evenly(
    [
      { x: 0, y: 0 },
      { x: 3, y: 0 },
      { x: 3, y: 0 },
      { x: 3, y: 9 },
    ],
    2,
  );
  expect(even).toHaveLength(7);
  for (let i = 1; i < even.length; i += 1)
    expect(between(even[i] as Spot, even[i - 1] as Spot)).toBeCloseTo(i === 2 ? Math.hypot(1, 1) : 2, 9);
  expect(even[0]).toEqual({ x: 0, y: 0 });
  expect(even.at(-1)).toEqual({ x: 3, y: 9 });
  expect(
    evenly(
      [
        { x: 1, y: 1 },
        { x: 1, y: 1 },
      ],
      2,
    ),
  ).toEqual([]);
  expect(evenly([], 2)).toEqual([]);
});

test("few knots follow a smooth line, without a corner", () => {
  const knots = knotsOf(belly(0), 0);
  expect(knots.length).toBeLessThan(14);
  expect(knots.every(({ sharp }) => !sharp)).toBe(true);
  expect(off(curveThrough(knots), belly(0))).toBeLessThan(1);
  expect(knots[0]).toMatchObject({ x: 300, y: 430 });
});

test("what trembles is calmed", () => {
  const knots = knotsOf(belly(1.2), 4);
  expect(knots.length).toBeLessThan(20);
  expect(knots.every(({ sharp }) => !sharp)).toBe(true);
  expect(off(curveThrough(knots), belly(0))).toBeLessThan(1.6);
});

test("a corner stays one, where it is, and is straight to either side", () => {
  // A foot, a sharp shoulder, a neck.
  const corner = { x: 340, y: 200 };
  const drawn = [{ x: 280, y: 420 }, corner, { x: 270, y: 170 }, { x: 270, y: 60 }];
  for (const smoothing of [0, 4] as const) {
    const knots = knotsOf(drawn, smoothing);
    const sharp = knots.filter((knot) => knot.sharp);
    expect(sharp).toHaveLength(2);
    expect(between(sharp[0] as Spot, corner)).toBeLessThan(2.1);
    expect(off(curveThrough(knots), drawn)).toBeLessThan(1.5);
    expect(knots.length).toBeLessThan(9);
  }
});

test("a curve goes through its knots and makes no loops of its own", () => {
  const knots = [
    { x: 10, y: 90, sharp: false },
    { x: 12, y: 88, sharp: false },
    { x: 80, y: 20, sharp: false },
    { x: 82, y: 80, sharp: false },
  ];
  const line = curveThrough(knots);
  for (const knot of knots) expect(Math.min(...line.map((spot) => between(spot, knot)))).toBeLessThan(1e-9);
  expect(lengthOf(line)).toBeLessThan(1.35 * lengthOf(knots));
  expect(curveThrough([])).toEqual([]);
  // Two knots at one place are one.
  const twice = [knots[0], knots[0], knots[2]].map((knot) => knot as (typeof knots)[0]);
  expect(curveThrough(twice).every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y))).toBe(true);
});
