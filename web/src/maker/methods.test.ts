import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import type { Blend, Design, Section } from "../document/types";

const { maker } = realMaker({ free: true });

async function compared(start: Section, end: Section, more: Partial<Blend> = {}) {
  const design: Design = { pasu: 1, parts: [{ shape: { kind: "blend", start, end, ...more } }] };
  const found = await maker.ask({ kind: "methods", design, part: 0 });
  if (found.state !== "done") throw new Error(JSON.stringify(found));
  return found.value;
}

test("every method that solves a blend is told with its time, its terms and what it leaves", async () => {
  const disc = (z: number, radius: number): Section => ({ form: "disc", radius: [radius, 1], z, taper: -0.1, dz: 2 });
  const [exact, modal, collocation] = await compared(disc(0, 2), disc(2, 1), { terms: [8, 8, 3] });
  expect([exact?.method, modal?.method, collocation?.method]).toEqual(["exact", "modal", "collocation"]);
  expect([exact?.terms, modal?.terms, collocation?.terms]).toEqual([[], [8, 8], [8, 8, 3]]);
  expect(exact?.residual).toBeLessThan(1e-9);
  expect(modal?.mean).toBeGreaterThan(1);
  expect(modal?.mean).toBeLessThan(collocation?.mean ?? 0);
  // The first is the one that the blend is solved by.
  expect(exact?.apart).toBe(0);
  expect(modal?.apart).toBeGreaterThan(0.01);
  expect(exact?.fromLoft).toBeGreaterThan(0.1);
  for (const each of [exact, modal, collocation]) expect(each?.milliseconds).toBeGreaterThan(0);
});

test("what the equation leaves alone is a loft by every method", async () => {
  const box = (z: number): Section => ({ form: "rectangle", radius: [2, 1], z, taper: 0.2, dz: 2 });
  for (const each of await compared(box(0), box(2))) {
    expect([each.residual, each.fromLoft < 1e-12]).toEqual([0, true]);
  }
});

test("a disc over a square has no exact solution, and none is told", async () => {
  const section = (form: "disc-in-square" | "rectangle-reversed", z: number): Section => ({
    form,
    radius: [2, 1],
    z,
    taper: 0,
    dz: 2,
  });
  const found = await compared(section("disc-in-square", 0), section("rectangle-reversed", 2));
  expect(found.map(({ method }) => method)).toEqual(["modal", "collocation"]);
});
