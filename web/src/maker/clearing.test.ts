import { readFile } from "node:fs/promises";
import init, { constraints } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { moved } from "../document/moving";
import { UNMOVED } from "../document/placement";
import type { Design, Part, Sent, Triple } from "../document/types";
import { apart, type Move, together } from "./clearing";

beforeAll(async () => {
  await init(await readFile(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url)));
});

/** A ball of radius 1, of eight octants' worth: one octant stands for it, from 0 to 1 along every axis. */
const octant = (shift: Triple, object: number, name: string): Part => ({
  name,
  object,
  shape: { kind: "octant", exponents: [2, 2, 2] },
  place: { shift },
});
const block = (shift: Triple, object: number, name: string): Part => ({
  name,
  object,
  shape: { kind: "octant", exponents: [50, 50, 50] },
  place: { shift },
});
const scene = (...parts: readonly Part[]): Design => ({ pasu: 1, parts });

function after(design: Design, move: Move | null): Design {
  if (!move) throw new Error("nothing moves");
  const parts = design.parts.map((part, place) =>
    move.moving.includes(place) ? { ...part, place: moved({ ...UNMOVED, ...part.place }, move.by) } : part,
  );
  return { ...design, parts };
}
const codes = (design: Design) => constraints(design as Sent).breaches.map(({ code }) => code);

test("what runs into another goes no further than it has to", () => {
  const design = scene(block([0, 0, 0], 0, "table"), block([0.2, 0.2, 0.7], 1, "cup"));
  expect(codes(design)).toEqual(["interference"]);
  const ways = [{ moving: [1], towards: [0, 0, 1] as const, far: 0.6, others: [0] }];
  const move = apart({ kind: "apart", design, ways });
  expect(move?.by.slice(0, 2)).toEqual([0, 0]);
  expect(move?.by[2]).toBeGreaterThan(0.29);
  expect(move?.by[2]).toBeLessThan(0.302);
  expect(codes(after(design, move))).toEqual([]);
});

test("a way that ends in a third part is none, and the next is taken", () => {
  const design = scene(
    block([0, 0, 0], 0, "table"),
    block([0.2, 0.2, 0.7], 1, "cup"),
    block([0.2, 0.2, 1.9], 2, "shelf"),
  );
  const up = { moving: [1], towards: [0, 0, 1] as const, far: 0.4, others: [0, 2] };
  const aside = { moving: [1], towards: [1, 0, 0] as const, far: 0.9, others: [0, 2] };
  expect(apart({ kind: "apart", design, ways: [up] })).toBeNull();
  const move = apart({ kind: "apart", design, ways: [up, aside] });
  expect(move?.by[2]).toBe(0);
  expect(codes(after(design, move))).toEqual([]);
});

test("all that is glued goes along", () => {
  const design = scene(
    block([0, 0, 0], 0, "table"),
    block([0.2, 0.2, 0.7], 1, "cup"),
    octant([1.1, 0.2, 0.7], 1, "handle"),
  );
  expect(codes(design)).toContain("interference");
  const ways = [{ moving: [1, 2], towards: [0, 0, 1] as const, far: 0.6, others: [0] }];
  expect(codes(after(design, apart({ kind: "apart", design, ways })))).toEqual([]);
});

test("what is glued and loose is brought until it touches", () => {
  const design = scene(block([0, 0, 0], 0, "cup"), octant([3, 0.3, 0.1], 0, "handle"));
  const [breach] = constraints(design as Sent).breaches;
  expect(breach).toMatchObject({ code: "not-connected", part: 1, other: 0 });
  const from = breach?.at as Triple;
  const move = together({ kind: "together", design, group: [1], other: 0, from, to: [0.5, 0.5, 0.5], size: 1 });
  expect(move?.moving).toEqual([1]);
  expect(Math.hypot(...(move?.by ?? []))).toBeGreaterThan(breach?.distance ?? Number.POSITIVE_INFINITY);
  expect(Math.hypot(...(move?.by ?? []))).toBeLessThan(1.1 * (breach?.distance ?? 0) + 0.3);
  expect(codes(after(design, move))).toEqual([]);
});

test("what hangs together is brought as it is, until one of it touches", () => {
  const pair = [octant([3, 0.3, 0.1], 0, "handle"), block([3.5, 0.3, 0.1], 0, "end")] as const;
  const design = scene(block([0, 0, 0], 0, "cup"), ...pair, block([9, 9, 9], 1, "elsewhere"));
  // The larger group is what others are loose from.
  const [breach] = constraints(design as Sent).breaches;
  expect(breach).toMatchObject({ code: "not-connected", part: 0, other: 1, group: [0] });
  const from = [3, 0.5, 0.2] as const;
  const move = together({ kind: "together", design, group: [1, 2], other: 0, from, to: [0.5, 0.5, 0.5], size: 1 });
  expect(move?.moving).toEqual([1, 2]);
  expect(Math.abs(move?.by[0] ?? 0)).toBeGreaterThan(1.9);
  expect(Math.abs(move?.by[0] ?? 0)).toBeLessThan(2.2);
  expect(codes(after(design, move))).toEqual([]);
});

test("where nothing lies on the way nothing is brought", () => {
  const design = scene(block([0, 0, 0], 0, "cup"), octant([3, 0, 0], 0, "handle"));
  expect(
    together({ kind: "together", design, group: [1], other: 0, from: [3, 0, 0], to: [3, 5, 0], size: 1 }),
  ).toBeNull();
  expect(
    together({ kind: "together", design, group: [1], other: 0, from: [3, 0, 0], to: [3, 0, 0], size: 1 }),
  ).toBeNull();
});
