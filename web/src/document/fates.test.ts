import { expect, test } from "vitest";
import { FATES, fatesOf, groupsOf } from "./fates";
import type { Difference } from "./types";

const DIFFERENCE: Difference = {
  isSame: false,
  kept: [{ before: 0, after: 3 }],
  moved: [
    { before: 1, after: 0 },
    { before: 2, after: 1 },
  ],
  changed: [{ before: 4, after: 4 }],
  gone: [3],
  added: [2],
  reglued: [
    { before: 1, after: 0 },
    { before: 0, after: 3 },
  ],
};

test("every part of either scene has one fate, the most telling", () => {
  expect([...fatesOf(DIFFERENCE, "after")].sort()).toEqual([
    [0, "moved"],
    [1, "moved"],
    [2, "added"],
    [3, "reglued"],
    [4, "changed"],
  ]);
  expect([...fatesOf(DIFFERENCE, "before")].sort()).toEqual([
    [0, "reglued"],
    [1, "moved"],
    [2, "moved"],
    [3, "gone"],
    [4, "changed"],
  ]);
});

test("groups are told in one order, and none is left out", () => {
  expect(groupsOf(DIFFERENCE).map(({ which }) => which)).toEqual(FATES);
  const count = groupsOf(DIFFERENCE).reduce((sum, { parts }) => sum + parts.length, 0);
  expect(count).toBe(8);
});
