import { describe, expect, test } from "vitest";
import { fieldWords } from "../words/parameters";
import { PAPERS } from "./gallery/papers";
import { filled } from "./kinds";
import { pathText } from "./path";
import { type Family, familyOf, fieldValue, GROUPS, rowsOf, sizeFactor, withField } from "./schema";

const FAMILIES = (["second-order", "mixed-order", "fourth-order", "bloor-wilson"] as const).map(
  (kind) => familyOf(kind) as Family,
);

/** Every number of a shape by its path, to see that none was forgotten. */
function numbersOf(value: unknown, path: (string | number)[] = []): string[] {
  if (typeof value === "number") return [pathText(path)];
  if (Array.isArray(value)) return value.flatMap((item, index) => numbersOf(item, [...path, index]));
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, item]) => numbersOf(item, [...path, key]));
}

describe.each(FAMILIES.map((family) => [family.kind, family] as const))("%s", (_kind, family) => {
  test("has a field for every number, and no other", () => {
    const paths = family.fields.map((field) => pathText(field.path)).sort();
    expect(paths).toEqual(numbersOf(filled(family.reset)).sort());
  });

  test("has sensible ranges and texts", () => {
    for (const field of family.fields) {
      expect(field.min).toBeLessThan(field.max);
      expect(field.step).toBeGreaterThan(0);
      expect(field.step).toBeLessThanOrEqual((field.max - field.min) / 3);
      expect(fieldWords(family.kind, field.key).help).toMatch(/\.$/);
      const reset = fieldValue(family.reset, field);
      expect(reset).toBeGreaterThanOrEqual(field.min);
      expect(reset).toBeLessThanOrEqual(field.max);
    }
  });

  test("puts every field into exactly one row, x and y of a parameter together", () => {
    const rows = GROUPS.flatMap((group) => rowsOf(family, group));
    expect(rows.flatMap((row) => row.fields).length).toBe(family.fields.length);
    expect(new Set(rows.map((row) => row.id)).size).toBe(rows.length);
    for (const { fields } of rows) {
      if (fields.length === 2) expect(fields.map((field) => field.symbol.slice(-2))).toEqual(["_x", "_y"]);
    }
  });

  test("names every number differently", () => {
    const rows = GROUPS.flatMap((group) => rowsOf(family, group));
    expect(new Set(rows.map((row) => fieldWords(family.kind, row.fields[0].key).name)).size).toBe(rows.length);
  });

  test("sets what it reads, and keeps the shape when nothing changes", () => {
    for (const field of family.fields) {
      const next = withField(family.reset, field, 0.125);
      expect(fieldValue(next, field)).toBe(0.125);
      expect(withField(next, field, 0.125)).toBe(next);
      expect(withField(family.reset, field, fieldValue(family.reset, field))).toBe(family.reset);
    }
  });
});

test("the sliders of the papers' pots are the papers' own", () => {
  for (const { shape } of PAPERS) {
    const family = familyOf(shape.kind);
    if (family) expect(sizeFactor(family, shape)).toBeLessThanOrEqual(1);
  }
});

test("a large pot has sliders of its size", () => {
  const family = FAMILIES[2] as Family;
  const big = { ...family.reset, h1: 42, r0: 8 } as typeof family.reset;
  expect(sizeFactor(family, big)).toBe(5);
});
