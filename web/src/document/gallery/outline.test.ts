import { expect, test } from "vitest";
import type { Component } from "../types";
import { turned } from "./outline";

/** A component's boundary curve at the foot. */
function foot(component: Component, v: number): number {
  return component.modes.reduce(
    (sum, { n, cos, sin }) => sum + (cos?.start ?? 0) * Math.cos(n * v) + (sin?.start ?? 0) * Math.sin(n * v),
    0,
  );
}

test.each([1, 2, 3, 8])("a wave of %d in the radius is one in polar form", (n) => {
  const pot = turned({
    equation: [1, 0, 0],
    radius: { foot: 5 },
    petals: [{ n, cos: { foot: 0.4 }, sin: { foot: -0.3 } }],
    height: { rim: 20 },
  });
  for (let v = 0; v < 6.2; v += 0.3) {
    const radius = 5 + 0.4 * Math.cos(n * v) - 0.3 * Math.sin(n * v);
    expect(foot(pot.x, v)).toBeCloseTo(radius * Math.cos(v), 12);
    expect(foot(pot.y, v)).toBeCloseTo(radius * Math.sin(v), 12);
  }
});

test("each harmonic appears once, in ascending order", () => {
  const pot = turned({
    equation: [1, 2, 1],
    radius: { foot: 5, force: [1] },
    petals: [
      { n: 2, cos: { foot: 0.4, force: [0, 2] } },
      { n: 4, cos: { foot: 0.2 } },
    ],
    height: { rim: 20 },
    axis: { rim: 1 },
  });
  expect(pot.x.modes.map((mode) => mode.n)).toEqual([0, 1, 3, 5]);
  expect(pot.x.modes[1]?.cos).toEqual({ start: 5.2, end: 0, start_u: 0, end_u: 0, force: [1, 1] });
});
