import { readFile } from "node:fs/promises";
import init, { at, constraints } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { ringed } from "../document/ringed";
import type { Design, Part, Sent, Triple } from "../document/types";
import { type PushAsk, type Pushed, push } from "./pushing";

beforeAll(async () => {
  await init(await readFile(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url)));
});

/** A round pot of radius 3 with a wall of 0.4 inwards. */
const MUG: Part = {
  name: "Mug",
  shape: ringed([3, 3, 3], [0, 3, 6]),
  wall: { thickness: 0.4, base: 0.5 },
};
const bar = (x: number, width = 1): Part => ({
  name: "Bar",
  object: 1,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale: [1.5, width, 1], shift: [x, -width / 2, 2] },
});
/** The corners of the end that goes first. */
const end = (x: number, width = 1): readonly Triple[] =>
  [0, 0.5, 1].flatMap((y) => [2, 2.5, 3].map((z): Triple => [x, width * (y - 0.5), z]));

const scene = (...parts: readonly Part[]): Design => ({ pasu: 1, parts });
const ask = (design: Design, points: readonly Triple[], more: Partial<PushAsk> = {}): PushAsk => ({
  kind: "push",
  design,
  moving: [1],
  onto: 0,
  towards: [-1, 0, 0],
  back: 0,
  points,
  size: 1.5,
  ...more,
});
const after = (design: Design, pushed: Pushed | null): Design => {
  if (!pushed) throw new Error("it meets nothing");
  const parts = design.parts.map((part, place) => {
    if (!pushed.moving.includes(place)) return part;
    const shift = (part.place?.shift ?? [0, 0, 0]).map((x, axis) => x + (pushed.by[axis] as number));
    return { ...part, object: 0, place: { ...part.place, shift: shift as unknown as Triple } };
  });
  return { ...design, parts };
};
const inMug = (point: Triple) => at(scene(MUG) as Sent, [...point]).length > 0;

test("all of the end comes into the clay, and none of it through the wall", () => {
  const design = scene(MUG, bar(5));
  const pushed = push(ask(design, end(5)));
  expect(pushed?.isSet).toBe(true);
  const x = 5 + (pushed?.by[0] ?? 0);
  // The edge of the end is behind its middle by 3 - sqrt(9 - 1/4), which is 0.042.
  expect(x).toBeLessThan(3 - 0.042);
  expect(x).toBeGreaterThan(2.6);
  for (const point of end(x)) expect(inMug(point)).toBe(true);
  expect(constraints(after(design, pushed) as Sent).isKept).toBe(true);
});

test("what is in the wall already, or within the pot, is drawn back first", () => {
  const design = scene(MUG, bar(1));
  const pushed = push(ask(design, end(1), { back: 6 }));
  expect(1 + (pushed?.by[0] ?? 0)).toBeGreaterThan(2.6);
  expect(1 + (pushed?.by[0] ?? 0)).toBeLessThan(2.96);
});

test("an end that is too wide for the wall goes in as far as it may, and that is said", () => {
  const design = scene(MUG, bar(5, 4));
  const pushed = push(ask(design, end(5, 4), { size: 4 }));
  expect(pushed?.isSet).toBe(false);
  const x = 5 + (pushed?.by[0] ?? 0);
  expect(x).toBeLessThan(3);
  expect(x).toBeGreaterThan(2.6);
});

test("beside the other it meets nothing, and a solid is entered a little", () => {
  const aside = scene(MUG, { ...bar(5), place: { scale: [1.5, 1, 1], shift: [5, 8, 2] } });
  expect(push(ask(aside, [[5, 8.5, 2.5]]))).toBeNull();
  expect(push(ask(aside, []))).toBeNull();
  const solid = scene({ ...bar(0, 4), object: 0 }, bar(5));
  const pushed = push(ask(solid, end(5)));
  expect(5 + (pushed?.by[0] ?? 0)).toBeGreaterThan(1.4);
  expect(5 + (pushed?.by[0] ?? 0)).toBeLessThan(1.5);
});
