import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { NETWORKED } from "../gallery/networks";
import type { Pair } from "../types";
import { edgesOf, type Network, sizeOf } from "./network";
import { liesFlat, seenOn } from "./sculpting";
import { pointOn } from "./surface";

interface Case {
  readonly name: string;
  readonly shape: Network;
  readonly points: readonly { patch: number; u: number; v: number; position: readonly number[] }[];
}

const apart = (one: readonly number[], other: readonly number[]) =>
  Math.hypot(...one.map((value, axis) => value - (other[axis] ?? 0)));

test("what is sculpted is seen where the reference has it", () => {
  const cases = JSON.parse(
    readFileSync(new URL("../../../../tests/reference/frames.json", import.meta.url), "utf8"),
  ) as readonly Case[];
  const { shape, points } = cases.find(({ name }) => name === "sculpted") as Case;
  expect(points.length).toBeGreaterThan(4);
  for (const { patch, u, v, position } of points)
    expect(apart(seenOn(shape, patch, u, v), position)).toBeLessThan(1e-11 * sizeOf(shape));
});

test("a region goes on over the edges of its patch: from both sides they are seen in one place", () => {
  const face = NETWORKED.find(({ id }) => id === "own-face")?.shape as Network;
  const along = (side: number, share: number): Pair =>
    side === 0 ? [share, 0] : side === 1 ? [1, share] : side === 2 ? [share, 1] : [0, share];
  let lifted = 0;
  for (const { sides } of edgesOf(face).values()) {
    const [one, other] = sides;
    if (!one || !other) continue;
    for (const share of [0.2, 0.5, 0.7]) {
      const here = along(one.side, share);
      const there = along(other.side, one.vertices[0] === other.vertices[0] ? share : 1 - share);
      const seen = seenOn(face, one.patch, ...here);
      expect(apart(seen, seenOn(face, other.patch, ...there))).toBeLessThan(1e-9);
      if (apart(seen, pointOn(face, one.patch, ...here)) > 0.1) lifted += 1;
    }
  }
  expect(lifted).toBeGreaterThan(3);
});

test("a region lies flat round a corner of four patches, and not round one of three", () => {
  // Point 0 in the middle, six round it, and a middle on every edge of the patches between them.
  const frames = [
    [0, 7, 1, 10, 2, 11, 3, 8],
    [0, 8, 3, 12, 4, 13, 5, 9],
    [0, 9, 5, 14, 6, 15, 1, 7],
  ] as const;
  const three = { kind: "vertex-frame", vertices: [], patches: frames.map((frame) => ({ frame })) } as Network;
  expect(liesFlat(three, 0, { u: [-0.2, 0.8], v: [0.1, 0.9] })).toBe(true);
  expect(liesFlat(three, 0, { u: [0.1, 0.9], v: [-0.2, 0.8] })).toBe(true);
  expect(liesFlat(three, 0, { u: [-0.2, 0.8], v: [-0.2, 0.8] })).toBe(false);
  expect(liesFlat(three, 0, { u: [0.2, 1.3], v: [0.2, 1.3] })).toBe(true);
  const face = NETWORKED.find(({ id }) => id === "own-face")?.shape as Network;
  for (const patch of face.patches.keys()) expect(liesFlat(face, patch, { u: [-1, 2], v: [-1, 2] })).toBe(true);
});
