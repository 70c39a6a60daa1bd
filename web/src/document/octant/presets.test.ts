import { expect, test } from "vitest";
import { alike, PRESETS, presetOf } from "./presets";

test("every named octant is known by its exponents, and others by none", () => {
  for (const { id, exponent } of PRESETS) expect(presetOf(alike(exponent))).toBe(id);
  expect(presetOf({ kind: "octant", exponents: [2, 2, 3] })).toBe(null);
  expect(presetOf(alike(7))).toBe(null);
});
