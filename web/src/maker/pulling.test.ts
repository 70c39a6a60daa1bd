import { readFile } from "node:fs/promises";
import init, { derivatives, evaluate, link } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { BOTTLE, WRITTEN } from "../../testing/bottle";
import { type Brush, bumpOf, NEW_BRUSH, SPREADS, WIDTHS } from "../document/brush";
import { curvesOf, spanOf } from "../document/curves";
import { SHELVES } from "../document/gallery";
import { wavesOf } from "../document/radial-pull";
import type { BoundaryValue, Rings, Sent, Shape } from "../document/types";
import type { Move } from "./messages";
import { pulling } from "./pulling";

beforeAll(async () => {
  await init(
    await WebAssembly.compile(await readFile(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url))),
  );
});

const SIDE: Brush = { ...NEW_BRUSH, spread: "side", width: 60 };
const ALL: Brush = { ...NEW_BRUSH, spread: "all" };
const PETALS: Brush = { ...NEW_BRUSH, spread: "petals", petals: 5 };
const ANGLES = [0, 0.7, 1.9, 3.1, 4.4, 5.6];
const STILL: Move = { out: 0, up: 0, round: 0 };

const designOf = (shape: Shape) => ({ pasu: 1, parts: [{ shape }] }) as unknown as Sent;
const point = (shape: Shape, at: readonly number[]) =>
  [...evaluate(designOf(shape), 0, at)] as [number, number, number];
const away = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((x, i) => x - (b[i] ?? 0)));
const pulled = (shape: Shape, at: readonly [number, number], by: Partial<Move>, brush: Brush) =>
  pulling({ kind: "pull", shape, at, by: { ...STILL, ...by }, brush, keep: [] });

test("of every surface of the gallery a point comes out by as much as the hand, at one side, all round and at petals", () => {
  // The sections of a blend and the points of a network have handles of their own, and an octant has none.
  const surfaces = SHELVES.flatMap(({ exhibits }) => exhibits).filter(
    ({ shape }) => !["blend", "vertex-frame", "octant"].includes(shape.kind),
  );
  for (const { id, shape } of surfaces) {
    const at = [0.4, 0.3 * spanOf(shape)] as const;
    const before = point(shape, at);
    const radius = Math.hypot(before[0], before[1]);
    const out = 0.1 * radius;
    for (const spread of SPREADS) {
      const { shape: after, at: arrived, behind } = pulled(shape, at, { out }, { ...NEW_BRUSH, spread });
      const factor = (radius + out) / radius;
      const wanted = [before[0] * factor, before[1] * factor, before[2]];
      expect(away(point(after, arrived), wanted), `${id} ${spread}`).toBeLessThan(behind + 1e-4 * radius);
      if (shape.kind === "rings" || shape.kind === "boundary-value") {
        expect(behind, `${id} ${spread}`).toBeLessThan(1e-4 * radius);
        // A ring under the hand is taken; where there is none, one is put.
        const added = curvesOf(shape).some(({ u }) => Math.abs(u - at[0]) <= 1 / 64) ? 0 : 1;
        expect(curvesOf(after)).toHaveLength(curvesOf(shape).length + added);
      }
    }
  }
});

test("what is drawn of a bump is what the solver adds", () => {
  for (const brush of [
    SIDE,
    { ...SIDE, width: WIDTHS.least },
    { ...SIDE, width: 140 },
    PETALS,
    { ...PETALS, petals: 12 },
    ALL,
  ]) {
    const round: Rings = {
      ...BOTTLE,
      rings: BOTTLE.rings.map(({ u, r, z }) => ({ u, r: { mean: r.mean }, z: { mean: z.mean } })),
    };
    const { shape } = pulled(round, [0.35, 0], { out: 1 }, brush);
    const ring = (shape as Rings).rings[1];
    const waves = wavesOf(bumpOf(brush));
    expect(ring?.r.mean).toBeCloseTo(6 + (waves[0]?.amplitude ?? 0), 4);
    // What is smaller than the digits that are kept is left out.
    const rest = waves.slice(1).filter(({ amplitude }) => amplitude > 1e-5);
    expect((ring?.r.waves ?? []).slice(0, rest.length).map(({ n }) => n)).toEqual(rest.map(({ n }) => n));
    expect(ring?.r.waves?.length ?? 0).toBeLessThanOrEqual(waves.length - 1);
    for (const [i, { amplitude }] of rest.entries()) expect(ring?.r.waves?.[i]?.cos).toBeCloseTo(amplitude, 4);
  }
});

test("all round and at petals, boundary data that are written out move away from the axis", () => {
  const radii = (shape: Shape) => [0, 1, 2, 3, 4, 5].map((k) => Math.hypot(...point(shape, [0.35, k]).slice(0, 2)));
  for (const r of radii(pulled(WRITTEN, [0.35, 1], { out: 0.5 }, ALL).shape)) expect(r).toBeCloseTo(6.5, 10);
  const petals = pulled(WRITTEN, [0.35, 1], { out: 0.5, up: 0.25 }, PETALS).shape;
  for (let petal = 0; petal < 5; petal += 1) {
    const v = 1 + (petal * 2 * Math.PI) / 5;
    const [x, y, z] = point(petals, [0.35, v]);
    expect(Math.hypot(x, y)).toBeCloseTo(6.5, 10);
    expect(z).toBeCloseTo(6.25, 10);
    const [a, b] = point(petals, [0.35, v + Math.PI / 5]);
    expect(Math.hypot(a, b)).toBeCloseTo(6, 10);
  }
  // Where there is no ring yet one is put where the surface is.
  const between = pulled(WRITTEN, [0.5, 0], { out: 0.5 }, ALL).shape as BoundaryValue;
  expect(between.rings?.map(({ u }) => u)).toEqual([0.35, 0.5, 0.7]);
  expect(away(point(between, [0.35, 1]), point(WRITTEN, [0.35, 1]))).toBeLessThan(1e-10);
});

test("all other rings keep their numbers, and a pull keeps the link short", () => {
  const { shape } = pulled(BOTTLE, [0.7, 2], { out: 0.8 }, SIDE);
  const rings = (shape as Rings).rings;
  for (const index of [0, 1, 3]) expect(rings[index]).toEqual(BOTTLE.rings[index]);
  expect(link(designOf(shape)).length).toBeLessThan(300);
});

test("a ring as a whole is turned against its neighbours, with all its waves", () => {
  const { shape, at } = pulled(BOTTLE, [0.35, 0], { round: 0.3 }, ALL);
  expect(at).toEqual([0.35, 0.3]);
  for (const v of [0, 1, 4]) {
    const [x, y] = point(shape, [0.35, v + 0.3]);
    const [a, b] = point(BOTTLE, [0.35, v]);
    expect(Math.hypot(x, y)).toBeCloseTo(Math.hypot(a, b), 5);
  }
});

test("up moves up, and round the axis moves what is pulled", () => {
  const up = pulled(BOTTLE, [1, 0], { up: -1.5 }, ALL);
  expect((up.shape as Rings).rings[3]?.z.mean).toBeCloseTo(18.5, 5);
  const turned = pulled(WRITTEN, [0.7, 0], { round: 0.2 }, SIDE);
  const [x, y] = point(turned.shape, turned.at);
  expect(Math.atan2(y, x)).toBeCloseTo(0.2, 6);
});

test("slopes that are kept stay at both ends, all round, while a ring is pulled, and before it the pot is as it was", () => {
  const round: Rings = { ...BOTTLE, rings: BOTTLE.rings.map(({ u, r, z }) => ({ u, r: { mean: r.mean }, z })) };
  // What waves of a radius are shifted round the axis by, between rings, is lost as it is where a ring is put.
  for (const [shape, lost] of [
    [round, 1e-9],
    [WRITTEN, 1e-9],
    [BOTTLE, 5e-3],
  ] as const) {
    const du = (of: Shape, u: number) =>
      derivatives(
        designOf(of),
        0,
        ANGLES.flatMap((v) => [u, v]),
      ).du;
    const off = (one: ArrayLike<number>, other: ArrayLike<number>) =>
      Math.max(...Array.from(one, (value, index) => Math.abs(value - (other[index] ?? 0))));
    const held = (by: Partial<Move>, brush: Brush) =>
      pulling({ kind: "pull", shape, at: [0.7, 1], by: { ...STILL, ...by }, brush, keep: ["slopes"] }).shape;
    const still = held({}, SIDE);
    for (const u of [0.1, 0.5, 0.9])
      for (const v of ANGLES) expect(away(point(still, [u, v]), point(shape, [u, v]))).toBeLessThan(lost);
    for (const brush of [SIDE, ALL, PETALS]) {
      const [after, loose] = [
        held({ out: 0.8, up: 0.3 }, brush),
        pulled(shape, [0.7, 1], { out: 0.8, up: 0.3 }, brush),
      ];
      for (const u of [0, 1]) {
        expect(off(du(after, u), du(still, u))).toBeLessThan(1e-8);
        expect(off(du(loose.shape, u), du(still, u))).toBeGreaterThan(0.1);
      }
    }
  }
});

test("of written data an end that is kept stays, and the hand goes on alone", () => {
  for (const brush of [SIDE, ALL, PETALS]) {
    const ask = { kind: "pull", shape: WRITTEN, at: [1, 0], by: { ...STILL, out: 0.5, up: 0.25 }, brush } as const;
    const whole = pulling({ ...ask, keep: ["x", "y", "z"] });
    expect(away(point(whole.shape, [1, 0]), point(WRITTEN, [1, 0]))).toBeLessThan(1e-12);
    expect(whole.behind).toBeCloseTo(Math.hypot(0.5, 0.25), 9);
    const level = pulling({ ...ask, keep: ["z"] });
    expect(point(level.shape, [1, 0])[2]).toBeCloseTo(20, 9);
    expect(point(level.shape, [1, 0])[0]).toBeCloseTo(2.7, 9);
  }
});
