import { evaluate } from "pasu/drawing";
import { beforeAll, expect, test } from "vitest";
import { library } from "../../testing/references";
import type { Rings, Sent } from "../document/types";
import { curvesOf } from "./curves";

beforeAll(library);

const JUG: Rings = {
  kind: "rings",
  rings: [
    { u: 0, r: { mean: 4 }, z: { mean: 0 } },
    { u: 0.6, r: { mean: 6, waves: [{ n: 3, cos: 0.5, sin: 0.2 }] }, z: { mean: 8 } },
    { u: 1, r: { mean: 4.5 }, z: { mean: 14, waves: [{ n: 2, cos: 1 }] } },
  ],
  rim: { r: { mean: 2 }, z: { mean: 9 } },
};

/** Whether a curve lies on the surface at that `u`, point by point. */
function lies(curve: Float32Array | undefined, u: number): void {
  const count = (curve?.length ?? 0) / 3;
  expect(count).toBeGreaterThan(100);
  const at = Array.from({ length: count }, (_, step) => [u, (2 * Math.PI * step) / (count - 1)]).flat();
  const points = evaluate({ pasu: 1, parts: [{ shape: JUG }] } as unknown as Sent, 0, at);
  for (const [index, value] of points.entries()) expect(curve?.[index]).toBeCloseTo(value, 5);
}

test.each([
  [["rings[0].r.mean"], [0]],
  [["rings[1].r.waves[0].cos"], [0.6]],
  [["rings[1].u"], [0.6]],
  [["rim.r.mean"], [1]],
  [
    ["rings[0].r.mean", "rings[2].z.mean"],
    [0, 1],
  ],
] as const)("the curves of %j lie on the pot", (places, us) => {
  const curves = curvesOf(JUG, places);
  expect(curves).toHaveLength(us.length);
  us.forEach((u, index) => void lies(curves[index], u));
});

test("a number of the equation itself is on no curve", () => {
  expect(curvesOf(JUG, ["a"])).toEqual([]);
  expect(curvesOf(JUG, [])).toEqual([]);
});
