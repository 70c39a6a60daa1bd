import init, { evaluate } from "pasu/drawing";
import { beforeAll, expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import type { Rings, Sent } from "./types";
import { changed, heightOf, PETALS_AT, UNCHANGED, type Whole, widthOf } from "./whole-pot";

beforeAll(() => init());

const point = (shape: Rings, u: number, v: number) =>
  evaluate({ pasu: 1, parts: [{ shape }] } as unknown as Sent, 0, [u, v]);

const SLIDERS: readonly Partial<Whole>[] = [
  { height: 1.4 },
  { width: 0.7 },
  { twist: 35 },
  { lean: 0.2 },
  { oval: 0.3 },
  { taper: -0.4 },
  ...PETALS_AT.map((at) => ({ depth: 0.2, petals: 6, at })),
  { flutes: 0.1, fluteCount: 16 },
];

test("a slider there and back leaves the same pot", () => {
  for (const slider of SLIDERS) {
    expect(changed(BOTTLE, { ...UNCHANGED, ...slider })).not.toEqual(BOTTLE);
    const [name] = Object.keys(slider) as [keyof Whole];
    expect(changed(BOTTLE, { ...UNCHANGED, ...slider, [name]: UNCHANGED[name] })).toBe(BOTTLE);
  }
});

test("each is linear: half of a slider is half of the way, everywhere on the surface", () => {
  const part = (slider: Partial<Whole>, share: number): Whole => {
    const values = Object.entries(slider).map(([name, value]) => {
      const none = UNCHANGED[name as keyof Whole];
      const moves = typeof value === "number" && typeof none === "number" && name !== "petals" && name !== "fluteCount";
      return [name, moves ? none + share * (value - none) : value];
    });
    return { ...UNCHANGED, ...Object.fromEntries(values) };
  };
  for (const slider of SLIDERS.filter((each) => !("twist" in each))) {
    for (const [u, v] of [
      [0.2, 0.4],
      [0.5, 3],
      [0.9, 5],
    ] as const) {
      const [none, half, all] = [0, 0.5, 1].map((share) => point(changed(BOTTLE, part(slider, share)), u, v));
      for (let axis = 0; axis < 3; axis += 1)
        expect(half?.[axis]).toBeCloseTo(((none?.[axis] ?? 0) + (all?.[axis] ?? 0)) / 2, 8);
    }
  }
});

test("height and width are what is asked for, and the foot stays on the table", () => {
  const tall = changed(BOTTLE, { ...UNCHANGED, height: 1.5 });
  expect(heightOf(tall)).toBeCloseTo(30, 10);
  expect(tall.rings[0]?.z.mean).toBe(0);
  expect(widthOf(changed(BOTTLE, { ...UNCHANGED, width: 0.5 }))).toBeCloseTo(6, 10);
});

test("a twist carries the waves of every ring round, by its height", () => {
  const twisted = changed(BOTTLE, { ...UNCHANGED, twist: 60 });
  // The belly is at three tenths of the height: its waves go on by 18 degrees.
  const turn = (18 * Math.PI) / 180;
  for (const v of [0, 1, 2.5]) {
    const [x, y] = point(twisted, 0.35, v + turn);
    const [a, b] = point(BOTTLE, 0.35, v);
    expect(Math.hypot(x ?? 0, y ?? 0)).toBeCloseTo(Math.hypot(a ?? 0, b ?? 0), 10);
  }
});

test("petals are where they are asked for", () => {
  const depths = (at: Whole["at"]) =>
    changed(BOTTLE, { ...UNCHANGED, depth: 0.1, petals: 6, at }).rings.map(
      ({ r }) => (r.waves?.find(({ n }) => n === 6)?.cos ?? 0) / r.mean,
    );
  expect(depths("all").map((depth) => Number(depth.toFixed(6)))).toEqual([0.1, 0.1, 0.1, 0.1]);
  expect(depths("rim")[0]).toBe(0);
  expect(depths("foot")[3]).toBe(0);
  expect(depths("belly")[0]).toBe(0);
  expect(depths("belly")[1]).toBeGreaterThan(depths("foot")[1] ?? 0);
});

test("flutes are as many and as deep as is asked for, round in the grooves and sharper on the ridges", () => {
  const fluted = changed(BOTTLE, { ...UNCHANGED, flutes: 0.1, fluteCount: 12 });
  const mean = BOTTLE.rings[1]?.r.mean ?? 0;
  // Of the belly, beside what goes round it already.
  const out = (angle: number) => {
    const [before, after] = [BOTTLE, fluted].map((pot) => {
      const [x = 0, y = 0] = point(pot, BOTTLE.rings[1]?.u ?? 0, angle);
      return Math.hypot(x, y);
    });
    return ((after ?? 0) - (before ?? 0)) / mean;
  };
  for (let flute = 0; flute < 12; flute += 1) {
    const groove = (flute * Math.PI) / 6;
    expect(out(groove + Math.PI / 12) - out(groove)).toBeCloseTo(0.1, 9);
    // A quarter of the way from the groove it has risen by less than a quarter turn of a plain wave would.
    expect(out(groove + Math.PI / 24) - out(groove)).toBeLessThan(0.05);
  }
});
