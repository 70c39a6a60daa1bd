import { expect, test } from "vitest";
import { countsOf, mendsOf, toldOf } from "./breaches";
import type { Breach, Design } from "./types";

const breach = (code: string, part: number, other: number, severity: Breach["severity"] = "error"): Breach => ({
  code,
  severity,
  part,
  other,
  group: [part],
  message: "",
  args: {},
  at: null,
  distance: null,
  isProved: true,
});

const design = (...objects: readonly number[]): Design => ({
  pasu: 1,
  parts: objects.map((object) => ({ object, shape: { kind: "octant", exponents: [2, 2, 2] } })),
});

test("the worst is told first, and what is wholly inside another is not told twice", () => {
  const breaches = [
    breach("contact", 3, 2, "note"),
    breach("undecided-interference", 3, 1, "warning"),
    breach("interference", 1, 0),
    breach("within", 0, 1),
    breach("interference", 2, 0),
  ];
  expect(toldOf({ breaches }).map(({ code, part, other }) => [code, part, other])).toEqual([
    ["within", 0, 1],
    ["interference", 2, 0],
    ["undecided-interference", 3, 1],
    ["contact", 3, 2],
  ]);
  expect(countsOf({ breaches, leftOut: 2, isKept: false, slack: 1e-6 })).toEqual({ broken: 5, undecided: 1 });
});

test("what would mend it goes by what it is, and by what is glued", () => {
  expect(mendsOf(breach("interference", 1, 0), design(0, 1))).toEqual(["apart", "glue"]);
  expect(mendsOf(breach("within", 1, 0), design(0, 1))).toEqual(["remove", "apart"]);
  // Glued, it would only come loose.
  expect(mendsOf(breach("within", 1, 0), design(0, 0))).toEqual(["remove"]);
  expect(mendsOf(breach("same-place", 1, 0), design(0, 0))).toEqual(["remove"]);
  expect(mendsOf(breach("undecided-interference", 1, 0, "warning"), design(0, 1))).toEqual(["apart"]);
  expect(mendsOf(breach("not-connected", 1, 0), design(0, 0))).toEqual(["together", "separate"]);
  for (const code of ["contact", "undecided-within", "undecided-connection", "of a later version"])
    expect(mendsOf(breach(code, 1, 0), design(0, 1))).toEqual([]);
});
