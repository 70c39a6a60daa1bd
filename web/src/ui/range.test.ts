import { expect, test } from "vitest";
import { reaching, usable } from "./range";

test.each([
  [1, 50, 20, 1, 50],
  [1, 50, 50, 1, 50],
  [1, 50, 80, 1, 100],
  [1, 50, 0.3, 0, 50],
  [0, 0.2, 1, 0, 1],
  [-5, 5, -5.01, -10, 5],
  [-5, 5, 7e9, -5, 1e10],
  [0, 1, 1.7e308, 0, 1.7e308],
  [2, 3, 5e-324, 0, 3],
  [-3, -2, -1, -3, 0],
])("from %d to %d and %d: from %d to %d", (low, high, value, from, to) => {
  expect(reaching({ low, high }, value)).toEqual({ low: from, high: to });
});

test("a range that reaches as far is the same one", () => {
  const range = { low: 0, high: 1 };
  expect(reaching(range, 0.5)).toBe(range);
  expect(reaching(range, Number.NaN)).toBe(range);
});

test.each([
  // Far wider than usual, and the number is within the usual one.
  [[0, 10], [0, 1000], 5, "usual"],
  [[0, 10], [-50, 10], 10, "usual"],
  [[0, 10], [0, 50], 5, "kept"],
  [[0, 10], [0, 1000], 11, "kept"],
  [[0, 10], [0, 1000], Number.NaN, "kept"],
  [[2, 2], [0, 5], 2, "usual"],
] as const)("with %j as usual and %j as kept, %d has the one that is %s", (ends, wide, value, which) => {
  const [usual, kept] = [ends, wide].map(([low, high]) => ({ low, high }));
  if (!usual || !kept) throw new Error("two ranges are compared");
  expect(usable(kept, usual, value)).toBe(which === "usual" ? usual : kept);
});
