import { expect, test } from "vitest";
import { boundOf, type Choices, choicesOf, hasGlued, makingOf, scaleOf, toleranceIn, trianglesOf } from "./saving";
import type { Design, Making, Measures, Part, Report } from "./types";

const MEASURES = {
  height: { value: 10, error: 0 },
  width: { greatest: { value: 6, error: 0 } },
  capacity: { brim: { value: 125, error: 0 } },
} as Measures;

const CHOICES: Choices = { product: "pot", size: "designed", measure: "", shrinkage: "", tolerance: "" };
const making = (choices: Partial<Choices>) => makingOf({ ...CHOICES, ...choices }, MEASURES, "cm");

test("as designed, nothing is applied", () => {
  expect(making({})).toEqual({ product: "pot" });
  expect(scaleOf({}, MEASURES, "cm")).toEqual({ size: 1, shrinkage: 1, millimetres: 10 });
});

test.each([
  [{ size: "height", measure: "20" }, { height: 20 }, 2],
  [{ size: "width", measure: "3" }, { width: 3 }, 0.5],
  [{ size: "capacity", measure: "1000" }, { capacity: 1000 }, 2],
] as const)("%j", (choices, size, factor) => {
  const made = making(choices);
  expect(made).toEqual({ product: "pot", size });
  if ("field" in made) throw new Error(made.code);
  expect(scaleOf(made, MEASURES, "cm").size).toBeCloseTo(factor, 12);
});

test("what the sign beside a field says may be typed into it, and another unit of length", () => {
  expect(making({ shrinkage: "12 %" })).toEqual({ product: "pot", shrinkage: 12 });
  expect(making({ shrinkage: "12½%" })).toEqual({ product: "pot", shrinkage: 12.5 });
  expect(making({ tolerance: "0.1 in" })).toEqual(making({ tolerance: "2.54" }));
  expect(making({ size: "height", measure: "100 mm" })).toEqual(making({ size: "height", measure: "10" }));
  for (const choices of [{ shrinkage: "12 cm" }, { tolerance: "0.1 %" }, { size: "height", measure: "5 %" }] as const) {
    expect(making(choices)).toHaveProperty("field");
  }
});

test("a capacity is chosen in millilitres whatever the unit", () => {
  const made = makingOf({ ...CHOICES, size: "capacity", measure: "1" }, MEASURES, "mm");
  expect(made).toEqual({ product: "pot", size: { capacity: 1000 } });
});

test("a capacity beside inches is in ounces of the United States, and may be typed in other measures", () => {
  const made = (measure: string) => makingOf({ ...CHOICES, size: "capacity", measure }, MEASURES, "in");
  // A gallon is 231 cubic inches, and 128 ounces.
  for (const measure of ["128", "1 gal", "8 US pt", "128 US\u00a0fl\u00a0oz", "3785.411784 ml"]) {
    const making = made(measure);
    if ("field" in making) throw new Error(measure);
    expect(making.size?.capacity).toBeCloseTo(231, 9);
  }
  expect(made("a cup")).toMatchObject({ field: "measure" });
  const { size, measure } = choicesOf({ size: { capacity: 231 } }, "in", true);
  expect([size, measure]).toEqual(["capacity", "128"]);
});

test("a tolerance in millimetres of the file is one of the design", () => {
  expect(making({ tolerance: "0.1" })).toEqual({ product: "pot", tolerance: 0.01 });
  expect(making({ tolerance: "0.1", size: "height", measure: "20" })).toMatchObject({ tolerance: 0.005 });
});

test("what holds nothing has no size by what it holds", () => {
  const made = makingOf({ ...CHOICES, size: "capacity", measure: "500" }, { ...MEASURES, capacity: null }, "cm");
  expect(made).toMatchObject({ field: "measure" });
});

test.each([
  [{ shrinkage: "60" }, "shrinkage"],
  [{ shrinkage: "-1" }, "shrinkage"],
  [{ shrinkage: "much" }, "shrinkage"],
  [{ size: "height", measure: "" }, "measure"],
  [{ size: "width", measure: "0" }, "measure"],
  [{ tolerance: "fine" }, "tolerance"],
  [{ tolerance: "0" }, "tolerance"],
] as const)("%j is refused at its field", (choices, field) => {
  expect(making(choices)).toMatchObject({ field });
});

test.each<Making>([
  { product: "pot" },
  { product: "solid" },
  { product: "pot", size: { height: 0.1 + 0.2 }, shrinkage: 12.5 },
  { product: "pot", size: { width: 1 / 3 }, tolerance: 0.01 },
  { product: "solid", shrinkage: 3, union: true },
  { product: "pot", size: { capacity: 500 }, shrinkage: 8, tolerance: 0.02 },
])("the fields that a file was made with ask for it again: %j", (made) => {
  for (const unit of ["cm", "mm", "in"] as const) {
    const choices: Choices = { ...choicesOf(made, unit, true), tolerance: toleranceIn(made, MEASURES, unit) };
    const again = makingOf(choices, MEASURES, unit);
    if ("field" in again) throw new Error(again.code);
    expect(Object.keys(again).sort()).toEqual(Object.keys(made).sort());
    expect(again.product).toBe(made.product);
    expect(again.union).toBe(made.union);
    expect(again.shrinkage ?? 0).toBe(made.shrinkage ?? 0);
    expect(Object.keys(again.size ?? {})).toEqual(Object.keys(made.size ?? {}));
    for (const [name, value] of Object.entries(made.size ?? {})) {
      expect(Object.entries(again.size ?? {})).toContainEqual([name, expect.closeTo(value ?? Number.NaN, 9)]);
    }
    if (made.tolerance !== undefined) expect(again.tolerance).toBeCloseTo(made.tolerance, 9);
  }
});

test("a making says nothing of a shrinkage of nothing, and a surface without a wall is a solid", () => {
  const none = { size: "designed", measure: "", shrinkage: "" };
  expect(choicesOf({ product: "pot", shrinkage: 0 }, "cm", false)).toEqual({ product: "solid", ...none });
  expect(choicesOf({}, "cm", true)).toEqual({ product: "pot", ...none });
});

test("only what is glued to something can be joined", () => {
  const octant = { kind: "octant", exponents: [2, 2, 2] } as const;
  const vase = { kind: "second-order", r: [1, 0, 1, 0] } as const;
  const wall = { thickness: 0.1, base: 0.1 };
  const of = (...parts: readonly Part[]): Design => ({ pasu: 1, parts });
  expect(hasGlued(of({ shape: octant }), "solid")).toBe(false);
  expect(hasGlued(of({ shape: octant }, { shape: octant }), "solid")).toBe(true);
  expect(hasGlued(of({ shape: octant }, { shape: octant, object: 1 }), "solid")).toBe(false);
  expect(hasGlued(of({ shape: vase, wall }, { shape: octant }), "pot")).toBe(true);
  // A surface without a wall is no part of a pot.
  expect(hasGlued(of({ shape: vase, wall }, { shape: vase }), "pot")).toBe(false);
  expect(hasGlued(of({ shape: vase, wall }, { shape: vase }), "solid")).toBe(true);
});

test("a file has the triangles of each solid and of each part that is none of one", () => {
  const meshes = [10, 20, 40].map((triangles, part) => ({ part, triangles }) as Report["meshes"][number]);
  const union = (parts: number[], triangles: number) => ({ parts, triangles }) as unknown as Report["unions"][number];
  expect(trianglesOf({ meshes, unions: [] })).toBe(70);
  expect(trianglesOf({ meshes, unions: [union([2, 0], 45)] })).toBe(65);
  expect(trianglesOf({ meshes, unions: [union([0, 2, 1], 50)] })).toBe(50);
});

test("triangles are never said to be nearer to the true faces than they are", () => {
  const report = (meshes: number[], unions: number[]) => {
    const [apart, joined] = [meshes, unions].map((bounds) => bounds.map((bound) => ({ bound })));
    return { meshes: apart, unions: joined } as unknown as Report;
  };
  expect(boundOf(report([0.04993, 0.02], []), 10)).toBeCloseTo(0.5, 12);
  expect(boundOf(report([0.04993], [0.0503]), 10)).toBeCloseTo(0.51, 12);
  expect(boundOf(report([0.02 * (1 + Number.EPSILON)], []), 1)).toBeCloseTo(0.02, 12);
  expect(boundOf(report([0.00123], []), 25.4)).toBeCloseTo(0.032, 12);
  expect(boundOf(report([0], [0]), 10)).toBe(0);
  expect(boundOf(report([], []), 10)).toBe(0);
});
