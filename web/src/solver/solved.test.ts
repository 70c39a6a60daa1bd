import { expect, test } from "vitest";
import { JAR, POT } from "../../testing/jar";
import { IDENTITY } from "../document/placement";
import type { Design } from "../document/types";
import { boundsWith, longest, type SolvedPart } from "./solved";

test("how large something is goes by its bounds where it has no foot and no rim, and is 1 while nothing is known", () => {
  const bounds = { min: [-1, 0, 2], max: [3, 9, 4], centre: [1, 4.5, 3], radius: 5 } as const;
  expect(longest({ facts: null, bounds })).toBe(9);
  expect(longest({ facts: null, bounds: null })).toBe(1);
  expect(longest(undefined)).toBe(1);
});

test("parts without a wall fill what they fill besides the walls", () => {
  const [pot, jar] = [POT.parts[0], JAR.parts[0]];
  if (!pot || !jar) throw new Error("both have a part");
  const at = (x: number) => {
    const [min, max] = [[x - 1, -1, 0] as const, [x + 1, 1, 2] as const];
    const own = { min, max, centre: [x, 0, 1] as const, radius: 1.5 };
    return { matrix: IDENTITY, own, box: { min, max } } as unknown as SolvedPart;
  };
  const walls = { min: [-2, -2, 0], max: [2, 2, 3], centre: [0, 0, 1.5], radius: 3 } as const;
  const design = (...parts: Design["parts"]): Design => ({ ...POT, parts });
  // That of a pot is within its wall, or around it.
  expect(boundsWith(walls, design(pot, pot), [at(0), at(9)])).toEqual(walls);
  const all = boundsWith(walls, design(pot, jar), [at(0), at(9)]);
  expect(all).toMatchObject({ min: [-2, -2, 0], max: [10, 2, 3] });
  expect(all?.radius).toBeGreaterThanOrEqual(6);
  expect(boundsWith(null, design(jar), [at(9)])).toMatchObject({ min: [8, -1, 0], max: [10, 1, 2] });
});
