import { expect, test } from "vitest";
import { type Brush, bumpOf, NEW_BRUSH, spreadOf, squeezing, WIDTHS, widened } from "./brush";

const SIDE: Brush = { ...NEW_BRUSH, spread: "side", width: 60 };

test("a brush grows and shrinks by as much, and stays within what is offered", () => {
  expect(widened(SIDE, 1).width).toBeGreaterThan(60);
  expect(widened(widened(SIDE, 3), -3).width).toBeCloseTo(60, 0);
  expect(widened(SIDE, 100).width).toBe(WIDTHS.most);
  expect(widened(SIDE, -100).width).toBe(WIDTHS.least);
});

test("all round it has no width, at one side an angle, and petals share the turn", () => {
  expect(spreadOf({ ...SIDE, spread: "all" })).toEqual({});
  expect(spreadOf(SIDE)).toEqual({ width: Math.PI / 3 });
  expect(spreadOf({ ...SIDE, spread: "petals", petals: 4 })).toEqual({ width: Math.PI / 4, petals: 4 });
});

test("it is half as strong at half its width", () => {
  for (const width of [20, 45, 60, 120]) {
    const { degree, petals } = bumpOf({ ...SIDE, width });
    const half = Math.cos((petals * width * Math.PI) / 720) ** (2 * degree);
    expect(half).toBeGreaterThan(0.38);
    expect(half).toBeLessThan(0.62);
  }
  expect(bumpOf({ ...SIDE, spread: "all" })).toEqual({ degree: 0, petals: 1 });
  expect(bumpOf({ ...SIDE, spread: "petals", petals: 6 }).petals).toBe(6);
});

test("between two fingers what pulls at one side pulls at both, and all else is as it was", () => {
  expect(spreadOf(squeezing(SIDE))).toEqual({ width: Math.PI / 2, petals: 2 });
  for (const spread of ["all", "petals"] as const) expect(squeezing({ ...SIDE, spread })).toEqual({ ...SIDE, spread });
});
