import { evaluate } from "pasu";
import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { type Look, USUAL } from "../document/blend/looking";
import type { Blend, Design, Section, Sent } from "../document/types";
import { joined } from "./inside";

const { maker } = realMaker({ free: true });

const section = (form: "disc" | "rectangle-reversed" | "disc-in-square", z: number, radius = 2): Section => ({
  form,
  radius: [radius, 2],
  z,
  taper: 0,
  dz: 3,
});

async function seen(start: Section, end: Section, look: Partial<Look>, more: Partial<Blend> = {}) {
  const shape: Blend = { kind: "blend", start, end, ...more };
  const design: Design = { pasu: 1, parts: [{ shape }] };
  const found = await maker.ask({ kind: "inside", design, part: 0, look: { ...USUAL, ...look } });
  if (found.state !== "done") throw new Error(JSON.stringify(found));
  return found.value;
}

test("half of a cylinder: its room grows with the distance from the middle", async () => {
  const half = await seen(section("disc", 0), section("disc", 3), {});
  // X_u x X_v . X_w = 2 pi r^2 u times the height.
  expect(half.greatest).toBeCloseTo(2 * Math.PI * 4 * 3, 3);
  expect(half.least).toBeCloseTo(0, 9);
  expect(half.folded).toBe(false);
  expect(half.values.length).toBe(half.positions.length / 3);
  // v from a half to 1 is where x is negative.
  for (let place = 0; place < half.positions.length; place += 3) {
    expect(half.positions[place]).toBeLessThan(1e-6);
  }
});

test("what the equation leaves is nothing of an exact blend, and something of one by sines", async () => {
  const exact = await seen(section("disc", 0), section("disc", 3), { map: "residual", at: [1, 0.4, 0.8] });
  expect([exact.holds, exact.worst < 1e-6]).toEqual([true, true]);
  const sines = await seen(
    section("disc", 0),
    section("disc", 3, 1),
    { map: "residual", shown: "surfaces", at: [0.5, 0.3, 0.4] },
    { method: "collocation", terms: [3, 3, 2] },
  );
  expect([sines.holds, sines.worst > 1]).toEqual([false, true]);
  expect(sines.greatest).toBeGreaterThan(sines.least);
});

test("the solids that it joins have its tangents where they meet it", async () => {
  for (const [from, to] of [
    [
      { ...section("disc", 0), taper: 0.4 },
      { ...section("disc", 3, 1), taper: -0.3 },
    ],
    [
      { ...section("rectangle-reversed", 0), taper: 0.4 },
      { ...section("disc-in-square", 3, 1), taper: -0.3, dz: 1 },
    ],
  ] as const) {
    const blend: Blend = { kind: "blend", start: from, end: to, terms: [5, 4, 3] };
    const design = { pasu: 1, parts: [{ shape: blend }] } as unknown as Sent;
    for (const [w, sign] of [
      [0, 1],
      [1, -1],
    ] as const) {
      const step = 1e-5;
      const at = (w: number) => Float64Array.from([0.7, 0.2, w, 0.3, 0.9, w, 1, 0.6, w]);
      const along = (far: number) => new Float64Array(3).fill(far);
      const [here, inner] = [evaluate(design, 0, at(w)), evaluate(design, 0, at(w + sign * step))];
      const outer = joined(design, 0, blend, { at: at(w), along: along(-sign * step) });
      for (const [axis, place] of here.entries()) {
        const [leaves, comes] = [((inner[axis] ?? 0) - place) / step, (place - (outer[axis] ?? 0)) / step];
        expect(Math.abs(leaves - comes)).toBeLessThan(5e-3);
      }
      // And a corner there would be seen.
      const { dz } = w === 0 ? from : to;
      expect(Math.abs((here[2] ?? 0) - (outer[2] ?? 0)) / step).toBeCloseTo(Math.abs(dz), 3);
    }
  }
  const shown = await seen(section("disc", 0), section("disc", 3, 1), { shown: "joined" });
  const z = shown.positions.filter((_, place) => place % 3 === 2);
  expect(z.reduce((least, each) => Math.min(least, each))).toBeCloseTo(-0.45, 5);
  expect(z.reduce((most, each) => Math.max(most, each))).toBeCloseTo(3.45, 5);
  expect(shown.indices.reduce((most, each) => Math.max(most, each), 0)).toBe(shown.values.length - 1);
});

test("a disc over a square has no number on its border, and one everywhere else", async () => {
  const found = await seen(section("disc-in-square", 0), section("rectangle-reversed", 3), {
    map: "residual",
    at: [1, 1, 1],
  });
  const grey = found.values.filter((value) => Number.isNaN(value)).length;
  expect(grey).toBeGreaterThan(100);
  expect(grey).toBeLessThan(found.values.length / 2);
  expect(Number.isFinite(found.greatest)).toBe(true);
});
