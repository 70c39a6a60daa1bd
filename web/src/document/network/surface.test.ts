import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { type Network, sizeOf } from "./network";
import { normalOn, pointOn } from "./surface";

interface Case {
  readonly name: string;
  readonly shape: Network;
  readonly points: readonly {
    readonly patch: number;
    readonly u: number;
    readonly v: number;
    readonly position: readonly number[];
  }[];
}

const cases = JSON.parse(
  readFileSync(new URL("../../../../tests/reference/frames.json", import.meta.url), "utf8"),
) as readonly Case[];

// Of what is sculpted only the surface below the forces is found here, and the case in every direction weighs its two parameters differently (docs/frames.md).
const told = cases.filter(({ name }) => name !== "sculpted" && name !== "2 x 4, global, every direction");

test.each(told.map((each) => [each.name, each] as const))(
  "%s is where the reference has it",
  (_, { shape, points }) => {
    expect(points.length).toBeGreaterThan(4);
    for (const { patch, u, v, position } of points) {
      const found = pointOn(shape, patch, u, v);
      for (const [axis, value] of position.entries())
        expect(Math.abs((found[axis] ?? 0) - value)).toBeLessThan(1e-11 * sizeOf(shape));
    }
  },
);

test("a flat patch has the normal of its plane", () => {
  const vertices = [
    [0, 0, 0],
    [1, 0, 0],
    [2, 0, 0],
    [2, 1, 0],
    [2, 2, 0],
    [1, 2, 0],
    [0, 2, 0],
    [0, 1, 0],
  ] as const;
  const flat: Network = { kind: "vertex-frame", vertices, patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }] };
  expect(normalOn(flat, 0, 0.3, 0.6)?.map((value) => Math.round(1e9 * value) / 1e9)).toEqual([0, 0, 1]);
});
