import { expect, test } from "vitest";
import { longest } from "./solved";

test("how large something is goes by its bounds where it has no foot and no rim, and is 1 while nothing is known", () => {
  const bounds = { min: [-1, 0, 2], max: [3, 9, 4], centre: [1, 4.5, 3], radius: 5 } as const;
  expect(longest({ facts: null, bounds })).toBe(9);
  expect(longest({ facts: null, bounds: null })).toBe(1);
  expect(longest(undefined)).toBe(1);
});
