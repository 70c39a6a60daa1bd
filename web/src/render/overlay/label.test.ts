import { expect, it } from "vitest";
import { clearOf } from "./label";

const SIZE = [80, 20] as const;
const CAPTION = { left: 10, top: 340, right: 200, bottom: 390 };

it("a word moves off what lies at the edges of the stage, and only as far as it has to", () => {
  expect(clearOf({ x: 100, y: 350 }, SIZE, [CAPTION], 400)).toEqual({ x: 100, y: 330 });
  expect(clearOf({ x: 100, y: 25 }, SIZE, [{ ...CAPTION, top: 6, bottom: 30 }], 400)).toEqual({ x: 100, y: 40 });
});

it("a word that is clear of it stays", () => {
  for (const spot of [
    { x: 100, y: 330 },
    { x: 240, y: 360 },
  ])
    expect(clearOf(spot, SIZE, [CAPTION], 400)).toEqual(spot);
});
