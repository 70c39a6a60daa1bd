import { readFile } from "node:fs/promises";
import init, { measure } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import { NEW_BRUSH } from "../document/brush";
import type { Lock } from "../document/locks";
import type { Rings, Sent, Wall } from "../document/types";
import type { Move } from "./messages";
import { pulling } from "./pulling";

beforeAll(async () => {
  await init(
    await WebAssembly.compile(await readFile(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url))),
  );
});

const WALL: Wall = { thickness: 0.4, base: 0.5 };

function holds(shape: Rings): number {
  const design = { pasu: 1, parts: [{ shape, wall: WALL }] } as Sent;
  return measure(design, { product: "pot" }).capacity?.brim.value ?? Number.NaN;
}

function pulled(u: number, by: Partial<Move>, keep: readonly string[], locked: readonly Lock[] | null): Rings {
  const shape = pulling({
    kind: "pull",
    shape: BOTTLE,
    at: [u, 0.4],
    by: { out: 0, up: 0, round: 0, ...by },
    brush: { ...NEW_BRUSH, spread: "side" },
    keep,
    ...(locked && { hold: { wall: WALL, locked } }),
  }).shape;
  if (shape.kind !== "rings") throw new Error("it is a pot of rings");
  return shape;
}

test.each([
  [0.35, { out: 1.2 }, [], ["capacity"]],
  [0.35, { out: -1 }, [], ["foot", "capacity"]],
  [0.5, { out: 0.8 }, [], ["capacity"]],
  [1, { out: 0.6, up: 3 }, [], ["capacity"]],
  [0.7, { out: 0.5 }, [], ["rim", "foot", "height", "capacity"]],
] as const)(
  "at %f a pot that is pulled by %o holds nearly what it held before",
  (u, by, keep, locked) => {
    const goal = holds(BOTTLE);
    const [free, held] = [holds(pulled(u, by, keep, null)), holds(pulled(u, by, keep, locked))];
    expect(Math.abs(free / goal - 1)).toBeGreaterThan(0.005);
    expect(Math.abs(held / goal - 1)).toBeLessThan(0.1 * Math.abs(free / goal - 1));
  },
  60_000,
);

test("where no other ring is free the hand is followed all the same", () => {
  const bulged = pulling({
    kind: "pull",
    shape: { ...BOTTLE, rings: [BOTTLE.rings[0], BOTTLE.rings[1], BOTTLE.rings[3]].flatMap((ring) => ring ?? []) },
    at: [0.35, 0],
    by: { out: 0.7, up: 0, round: 0 },
    brush: { ...NEW_BRUSH, spread: "all" },
    keep: [],
    hold: { wall: WALL, locked: ["rim", "foot", "capacity"] },
  }).shape as Rings;
  expect(bulged.rings[1]?.r.mean).toBeCloseTo(6.7, 5);
});
