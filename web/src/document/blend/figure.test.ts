import { expect, test } from "vitest";
import { type Figure, figureOf, outlineOf, PLAIN, restOf, withFigure } from "./figure";

const ROUND: Figure = { radius: [2, 2], turn: 0, middle: [0, 0], ornament: PLAIN };

test.each<[string, Partial<Figure>]>([
  ["a circle", {}],
  ["an oval", { radius: [3, 1] }],
  ["an oval that is turned and beside the axis", { radius: [1, 3], turn: 25, middle: [0.5, -1] }],
  ["a turned circle", { turn: -140 }],
  ["petals", { ornament: { count: 7, petals: 0.2, corners: 0, turn: 10 } }],
  ["a square", { ornament: { count: 4, petals: 0, corners: 0.9, turn: 45 } }],
  ["a triangle as sharp as can be", { ornament: { count: 3, petals: 0, corners: 1, turn: -20 } }],
  [
    "a star on an oval, turned",
    { radius: [4, 2.5], turn: 80, ornament: { count: 6, petals: 0.3, corners: 0.5, turn: 30 } },
  ],
])("%s is read as it was written", (_, change) => {
  const figure: Figure = { ...ROUND, ...change };
  const outline = outlineOf(figure);
  const found = figureOf(outline);
  for (const i of [0, 1] as const) {
    expect(found.radius[i]).toBeCloseTo(figure.radius[i], 8);
    expect(found.middle[i]).toBeCloseTo(figure.middle[i], 8);
  }
  expect(found.turn).toBeCloseTo(figure.turn, 6);
  expect(found.ornament.count).toBe(figure.ornament.count);
  expect(found.ornament.petals).toBeCloseTo(figure.ornament.petals, 8);
  expect(found.ornament.corners).toBeCloseTo(figure.ornament.corners, 8);
  expect(found.ornament.turn).toBeCloseTo(figure.ornament.turn, 6);
  expect(restOf(outline)).toBe(0);
});

test("the disc of the papers is a circle of one wave, and a square goes out to its corners", () => {
  expect(outlineOf(ROUND)).toEqual({ x: [{ n: 1, sin: 2 }], y: [{ n: 1, cos: 2 }] });
  const square = outlineOf({ ...ROUND, ornament: { count: 4, petals: 0, corners: 1, turn: 45 } });
  const at = (v: number) => {
    const sum = (series: typeof square.x) =>
      series.reduce(
        (all, { n, cos = 0, sin = 0 }) =>
          all + cos * Math.cos(2 * Math.PI * n * v) + sin * Math.sin(2 * Math.PI * n * v),
        0,
      );
    return [sum(square.x), sum(square.y)] as const;
  };
  // In the middle of a side and at a corner: a square has 1 to the root of 2.
  const [side, corner] = [Math.hypot(...at(0)), Math.hypot(...at(1 / 8))];
  expect(corner / side).toBeGreaterThan(1.37);
  expect(corner / side).toBeLessThan(Math.SQRT2);
  // Its sides are level.
  expect(at(0.05)[1] / at(0)[1]).toBeCloseTo(1, 2);
});

test("what has no name goes with the rest, and what begins elsewhere or runs the other way stays so", () => {
  const drawn = {
    x: [
      { n: 1, cos: 2 },
      { n: 2, sin: 0.3, cos: 0.1 },
      { n: 5, sin: 0.05 },
    ],
    y: [
      { n: 1, sin: 1.5 },
      { n: 3, sin: 0.1 },
    ],
  };
  expect(restOf(drawn)).toBe(3);
  // It begins a quarter round, and is the same as one that begins where ours do and is turned.
  const { radius, turn } = figureOf(drawn);
  expect([...radius, Math.abs(turn)]).toEqual([1.5, 2, 90]);
  const again = withFigure(drawn, {});
  for (const axis of ["x", "y"] as const) {
    expect(again[axis].map(({ n }) => n)).toEqual(drawn[axis].map(({ n }) => n));
    for (const [index, wave] of again[axis].entries()) {
      const { cos = 0, sin = 0 }: { cos?: number; sin?: number } = drawn[axis][index] ?? {};
      expect(wave.cos ?? 0).toBeCloseTo(cos, 8);
      expect(wave.sin ?? 0).toBeCloseTo(sin, 8);
    }
  }
  const wide = withFigure(drawn, { radius: [1.5, 4] });
  expect(wide.x.find(({ n }) => n === 2)?.sin).toBeCloseTo(0.6, 8);
  expect(wide.y.find(({ n }) => n === 3)?.sin).toBeCloseTo(0.1, 8);
  const turned = withFigure(drawn, { turn: turn + 90 });
  expect(turned.y.find(({ n }) => n === 1)?.cos).toBeCloseTo(2, 8);
  expect(figureOf(turned).turn).toBeCloseTo(turn + 90, 6);
});
