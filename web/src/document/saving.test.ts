import { expect, test } from "vitest";
import { type Choices, FORMATS, makingOf, opensAgain, scaleOf, sizesOf } from "./saving";
import type { Measures } from "./types";

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
  expect(sizesOf({}, MEASURES, "cm")).toEqual({
    file: "60\u00a0mm\u00a0wide, 100\u00a0mm\u00a0high",
    fired: null,
    applied: "",
  });
});

test.each([
  [{ size: "height", measure: "20" }, { height: 20 }, 2],
  [{ size: "width", measure: "3" }, { width: 3 }, 0.5],
  [{ size: "capacity", measure: "1000" }, { capacity: 1000 }, 2],
] as const)("%j", (choices, size, factor) => {
  const made = making(choices);
  expect(made).toEqual({ product: "pot", size });
  if ("field" in made) throw new Error(made.text);
  expect(scaleOf(made, MEASURES, "cm").size).toBeCloseTo(factor, 12);
});

test("a capacity is chosen in millilitres whatever the unit", () => {
  const made = makingOf({ ...CHOICES, size: "capacity", measure: "1" }, MEASURES, "mm");
  expect(made).toEqual({ product: "pot", size: { capacity: 1000 } });
});

test("clay that shrinks is made larger, and both sizes are told", () => {
  const made = making({ shrinkage: "12,5", size: "height", measure: "20" });
  if ("field" in made) throw new Error(made.text);
  expect(sizesOf(made, MEASURES, "cm")).toEqual({
    file: "137.1\u00a0mm\u00a0wide, 228.6\u00a0mm\u00a0high",
    fired: "120\u00a0mm\u00a0wide, 200\u00a0mm\u00a0high",
    applied: "scaled by 2, made 14.3\u00a0% larger for the shrinkage",
  });
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

test("of every format it is told whether the file opens the design again", () => {
  for (const { format } of FORMATS) {
    expect(opensAgain(format), format).toMatch(
      format === "stl" ? /an STL does not open/ : /the file opens the design again/,
    );
  }
});
