import { expect, test } from "vitest";
import { type Choices, FORMATS, makingOf } from "../document/saving";
import type { Measures } from "../document/types";
import { opensAgain, problemWords, sizesOf } from "./saving";

const MEASURES = {
  height: { value: 10, error: 0 },
  width: { greatest: { value: 6, error: 0 } },
  capacity: { brim: { value: 125, error: 0 } },
} as Measures;

const CHOICES: Choices = { product: "pot", size: "designed", measure: "", shrinkage: "", tolerance: "" };
const making = (choices: Partial<Choices>) => makingOf({ ...CHOICES, ...choices }, MEASURES, "cm");

test("as designed, nothing is applied", () => {
  expect(sizesOf({}, MEASURES, "cm")).toEqual({
    file: "60\u00a0mm\u00a0wide, 100\u00a0mm\u00a0high",
    fired: null,
    applied: "",
  });
});

test("clay that shrinks is made larger, and both sizes are told", () => {
  const made = making({ shrinkage: "12,5", size: "height", measure: "20" });
  if ("field" in made) throw new Error(made.code);
  expect(sizesOf(made, MEASURES, "cm")).toEqual({
    file: "137.1\u00a0mm\u00a0wide, 228.6\u00a0mm\u00a0high",
    fired: "120\u00a0mm\u00a0wide, 200\u00a0mm\u00a0high",
    applied: "scaled by 2, made 14.3\u00a0% larger for the shrinkage",
  });
});

test("of every format it is told whether the file opens the design again", () => {
  for (const { format } of FORMATS) {
    expect(opensAgain(format), format).toMatch(
      format === "stl" ? /an STL does not open/ : /the file opens the design again/,
    );
  }
});

test("what a field refuses is told with its range", () => {
  const made = making({ shrinkage: "60" });
  expect("field" in made && problemWords(made)).toBe("A percentage from 0 to less than 50.");
});
