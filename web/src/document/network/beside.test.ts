import { expect, test } from "vitest";
import { besideOneAnother, USUAL } from "./beside";
import type { Network } from "./network";
import { pointOn } from "./surface";

test("all three have the boundary of the first, and differ inside", () => {
  const [equation, coons, nurbs] = besideOneAnother({ ...USUAL, a1: 4, a2: -1.5 }).parts.map(
    ({ shape }) => shape as unknown as Network,
  );
  if (!equation || !coons || !nurbs) throw new Error("three");
  const far = (one: readonly number[], other: readonly number[]) =>
    Math.hypot(...one.map((x, k) => x - (other[k] ?? 0)));
  // Patch 8 row + column of a woven one, and its own parameters.
  const dense = (of: Network, u: number, v: number) => {
    const [row, column] = [u, v].map((t) => Math.min(7, Math.floor(8 * t))) as [number, number];
    return pointOn(of, 8 * row + column, 8 * u - row, 8 * v - column);
  };
  for (let step = 0; step <= 32; step += 1) {
    const t = step / 32;
    for (const [u, v] of [
      [0, t],
      [1, t],
      [t, 0],
      [t, 1],
    ] as const) {
      const edge = pointOn(equation, 0, u, v);
      expect(far(dense(coons, u, v), edge)).toBeLessThan(2e-3);
      expect(far(dense(nurbs, u, v), edge)).toBeLessThan(2e-3);
    }
  }
  expect(far(dense(coons, 0.25, 0.25), dense(nurbs, 0.25, 0.25))).toBeGreaterThan(0.05);
  expect(equation.patches[0]?.forces).toHaveLength(1);
  // The crest rises by what is asked for.
  const f0 = equation.patches[0]?.forces?.[0]?.f0[2] ?? 0;
  expect(-f0 / (Math.PI ** 2 * (4 - 1.5))).toBeCloseTo(USUAL.height, 6);
});
