import { expect, test } from "vitest";
import type { Spot } from "../drawn/knot";
import { MOST_WAVES, outlineBy, outlineThrough } from "./drawn";
import { figureOf } from "./figure";

const round = (count: number, at: (angle: number) => Spot) =>
  Array.from({ length: count }, (_, i) => at((2 * Math.PI * i) / count));
const CIRCLE = round(720, (angle) => ({ x: 200 + 100 * Math.cos(angle), y: 240 + 100 * Math.sin(angle) }));
const SQUARE: readonly Spot[] = [
  { x: 100, y: 100 },
  { x: 300, y: 100 },
  { x: 300, y: 300 },
  { x: 100, y: 300 },
];

test("a circle is one wave about its middle, whichever way and from wherever it was drawn", () => {
  for (const line of [CIRCLE, [...CIRCLE].reverse(), [...CIRCLE.slice(300), ...CIRCLE.slice(0, 300)]]) {
    const drawn = outlineThrough(line, 0.1);
    expect(drawn?.waves).toBe(1);
    expect(drawn?.off).toBeLessThan(0.01);
    expect(drawn?.middle.x).toBeCloseTo(200, 2);
    expect(drawn?.middle.y).toBeCloseTo(240, 2);
    expect(drawn?.reach).toBeCloseTo(100, 2);
    const figure = drawn && figureOf(drawn);
    expect(figure?.turn).toBeCloseTo(0, 6);
    expect(figure?.radius[0]).toBeCloseTo(100, 2);
    expect(figure?.radius[1]).toBeCloseTo(100, 2);
  }
});

test("what is wide on the sheet is wide in x, and what is up is behind", () => {
  // A drop with its tip up.
  const drop = round(400, (angle) => ({
    x: 200 + 120 * Math.sin(angle),
    y: 200 - 60 * Math.cos(angle) - 25 * Math.cos(2 * angle),
  }));
  const drawn = outlineThrough(drop, 0.5);
  const [width, depth] = drawn ? figureOf(drawn).radius : [0, 0];
  expect(width).toBeGreaterThan(1.4 * depth);
  const at = (v: number) =>
    (drawn?.y ?? []).reduce(
      (sum, { n, cos = 0, sin = 0 }) => sum + cos * Math.cos(2 * Math.PI * n * v) + sin * Math.sin(2 * Math.PI * n * v),
      0,
    );
  expect(at(0)).toBeGreaterThan(0);
  expect(at(0)).toBeGreaterThan(-at(0.5));
});

test("the error that is told holds, falls with the tolerance, and is honest where waves run out", () => {
  const [rough, fine] = [outlineThrough(SQUARE, 6), outlineThrough(SQUARE, 2)];
  if (!rough || !fine) throw new Error("a square goes round an area");
  expect(rough.off).toBeLessThanOrEqual(6);
  expect(fine.off).toBeLessThanOrEqual(2);
  expect(fine.waves).toBeGreaterThan(rough.waves);
  // No corner of the square is further from the curve.
  for (const corner of SQUARE) {
    const nearest = Math.min(...fine.curve.map(({ x, y }) => Math.hypot(x - corner.x, y - corner.y)));
    expect(nearest).toBeLessThanOrEqual(fine.off + 1);
  }
  const finest = outlineThrough(SQUARE, 1e-9);
  expect(finest?.waves).toBe(MOST_WAVES);
  expect(finest?.off).toBeGreaterThan(1e-3);
});

test("no corner is further from the curve than is told, wherever it lies between the places that are looked at", () => {
  for (let sides = 3; sides < 24; sides += 2) {
    // Sides of unequal lengths.
    const polygon = round(sides, (angle) => ({
      x: 200 + (100 + 30 * Math.sin(3.7 * angle)) * Math.cos(angle),
      y: 200 + (100 + 30 * Math.sin(3.7 * angle)) * Math.sin(angle),
    }));
    const drawn = outlineThrough(polygon, 0.3);
    if (!drawn) throw new Error("it goes round an area");
    const sum = (series: typeof drawn.x, angle: number) =>
      series.reduce((all, { n, cos = 0, sin = 0 }) => all + cos * Math.cos(n * angle) + sin * Math.sin(n * angle), 0);
    const { x, y, middle, off } = drawn;
    const curve = round(4096, (angle) => ({ x: middle.x + sum(x, angle), y: middle.y - sum(y, angle) }));
    for (const corner of polygon) {
      const pieces = curve.map((from, at) => [from, curve[(at + 1) % curve.length] ?? from] as const);
      const nearest = Math.min(...pieces.map((piece) => distanceTo(corner, piece)));
      expect(nearest).toBeLessThanOrEqual(off + 5e-3);
    }
  }
});

function distanceTo({ x, y }: Spot, [from, to]: readonly [Spot, Spot]): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const part = ((x - from.x) * dx + (y - from.y) * dy) / (dx * dx + dy * dy || 1);
  const held = Math.min(Math.max(part, 0), 1);
  return Math.hypot(x - from.x - held * dx, y - from.y - held * dy);
}

test("what is not turned is not turned after it was rounded", () => {
  const blob = round(500, (angle) => ({
    x: 200 + (90 + 20 * Math.cos(3 * angle + 0.4)) * Math.cos(angle),
    y: 200 + (90 + 20 * Math.cos(3 * angle + 0.4)) * Math.sin(angle) * 0.8,
  }));
  const drawn = outlineThrough(blob, 1);
  const small = drawn && outlineBy(drawn, 0.0731);
  const figure = small && figureOf(small);
  // Its ellipse may lie at a slant; all of it begins where its axis does.
  const wave = small?.x.find(({ n }) => n === 1);
  const other = small?.y.find(({ n }) => n === 1);
  expect(wave?.cos ?? 0).toBe(other?.sin ?? 0);
  expect(figure?.radius[0]).toBeGreaterThan(5);
});

test("a line that goes round nothing is none, and another size is another size", () => {
  expect(outlineThrough([{ x: 0, y: 0 }], 1)).toBeNull();
  expect(
    outlineThrough(
      [
        { x: 0, y: 0 },
        { x: 50, y: 0 },
        { x: 100, y: 0 },
      ],
      1,
    ),
  ).toBeNull();
  expect(outlineBy({ x: [{ n: 1, sin: 2 }], y: [{ n: 1, cos: 3, sin: 0.5 }] }, 2)).toEqual({
    x: [{ n: 1, sin: 4 }],
    y: [{ n: 1, cos: 6, sin: 1 }],
  });
});
