import { expect, test } from "vitest";
import type { Design } from "../document/types";
import type { SolvedParts } from "../solver/solved";
import { stageModel } from "./stage-model";

const box = (x: number, wide: number) => ({ min: [x, 0, 0], max: [x + wide, 2, 4] });
const shape = { kind: "octant", exponents: [2, 2, 2] };
const middles = (parts: readonly object[], boxes: readonly (object | null)[]) => {
  const solved = { parts: boxes.map((each, id) => ({ id, box: each })), bounds: null };
  const design = { pasu: 1, parts } as unknown as Design;
  return stageModel(design, solved as unknown as SolvedParts).parts.map(({ middle }) => middle);
};

test("parts know the middle of their object, where there are several", () => {
  const parts = [{ shape }, { shape, object: 1 }, { shape }];
  expect(middles(parts, [box(0, 2), box(10, 2), box(2, 2)])).toEqual([
    [2, 1, 2],
    [11, 1, 2],
    [2, 1, 2],
  ]);
  expect(middles([{ shape }, { shape }], [box(0, 2), box(10, 2)])).toEqual([undefined, undefined]);
  // What fills nothing has no middle.
  expect(middles(parts, [box(0, 2), null, box(2, 2)])).toEqual([undefined, undefined, undefined]);
});
