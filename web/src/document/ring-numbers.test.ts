import { expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import {
  type Hoop,
  madeRound,
  restOf,
  SWING_NAMES,
  swingOf,
  withFreeEnd,
  withMean,
  withSharp,
  withSwing,
} from "./ring-numbers";

const ROUND: Hoop = { u: 0.5, r: { mean: 5 }, z: { mean: 8 } };

test("every swing comes back as it was given, and goes without a trace", () => {
  for (const name of SWING_NAMES) {
    const none = swingOf(ROUND, name);
    expect(none.size).toBe(0);
    const given = { n: none.n, size: 0.4, turn: 17 };
    const swung = withSwing(ROUND, name, none, given);
    const found = swingOf(swung, name);
    expect(found.n).toBe(given.n);
    expect(found.size).toBeCloseTo(0.4, 10);
    expect(found.turn).toBeCloseTo(17, 9);
    expect(restOf(swung)).toBe(0);
    expect(withSwing(swung, name, found, { ...found, size: 0 })).toEqual(ROUND);
  }
});

test("another number of petals takes the place of those that are there, and leaves the rest", () => {
  const oval = withSwing(ROUND, "oval", swingOf(ROUND, "oval"), { n: 2, size: 1, turn: 30 });
  const five = withSwing(oval, "petals", swingOf(oval, "petals"), { n: 5, size: 0.5, turn: 10 });
  const seven = withSwing(five, "petals", swingOf(five, "petals"), { ...swingOf(five, "petals"), n: 7 });
  expect(seven.r.waves?.map(({ n }) => n)).toEqual([2, 7]);
  expect(swingOf(seven, "oval")).toMatchObject({ size: 1, turn: 30 });
  expect(swingOf(seven, "petals")).toMatchObject({ n: 7, size: 0.5 });
});

test("what a hand has pulled is told apart, and a ring made round has none of it", () => {
  const pulled: Hoop = { ...ROUND, r: { mean: 5, waves: [1, 2, 3, 4].map((n) => ({ n, cos: 1 / n })) } };
  // An oval and three petals have names; a shift to one side and what has four crests besides have none.
  expect(restOf(pulled)).toBe(2);
  expect(madeRound(pulled)).toEqual(ROUND);
  expect(restOf(BOTTLE.rings[1] as Hoop)).toBe(0);
});

test("a ring becomes sharp and smooth again, wider and higher", () => {
  expect(withSharp(withSharp(ROUND, true), false)).toEqual(ROUND);
  expect(withSharp(ROUND, true).sharp).toBe(true);
  expect(withMean(ROUND, "r", 7).r.mean).toBe(7);
  expect(withMean(ROUND, "z", 8)).toBe(ROUND);
});

test("an end is freed of its slope alone", () => {
  const slopes = { r: { mean: 1 }, z: { mean: 9 } };
  const pot = { ...BOTTLE, foot: slopes, rim: slopes };
  expect(withFreeEnd(pot, "foot")).toEqual({ ...BOTTLE, rim: slopes });
  expect(withFreeEnd(withFreeEnd(pot, "rim"), "foot")).toEqual(BOTTLE);
});
