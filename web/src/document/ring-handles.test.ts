import { expect, test } from "vitest";
import { WRITTEN } from "../../testing/bottle";
import { moveHandle } from "./profile";
import { nearestOn, ringHandles } from "./ring-handles";
import type { Shape } from "./types";

const pot: Shape = {
  kind: "rings",
  rings: [
    { u: 0, r: { mean: 3 }, z: { mean: 0 } },
    { u: 0.4, r: { mean: 6, waves: [{ n: 3, cos: 0.4 }] }, z: { mean: 6 } },
    { u: 1, r: { mean: 2 }, z: { mean: 20 } },
  ],
};

test("each between the ends is dragged by its own radius and height, and its waves stay", () => {
  const [ring, ...others] = ringHandles(pot);
  expect(others).toEqual([]);
  const next = ring && moveHandle(pot, ring, 0.5, -1);
  expect(next?.kind === "rings" && next.rings[1]).toEqual({
    u: 0.4,
    r: { mean: 6.5, waves: [{ n: 3, cos: 0.4 }] },
    z: { mean: 5 },
  });
  expect(ringHandles(WRITTEN)).toEqual([]);
});

test("a click finds the wall that it is nearest to", () => {
  const line = [0, 0, 1, 1, 2, 4];
  expect(nearestOn(line, 1.2, 1)).toMatchObject({ u: 0.5 });
  expect(nearestOn(line, 1.2, 1).away).toBeCloseTo(0.2);
  expect(nearestOn([5, 5], 0, 0).u).toBe(0);
});
