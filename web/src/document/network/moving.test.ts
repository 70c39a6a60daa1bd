import { expect, test } from "vitest";
import { NETWORKED } from "../gallery/networks";
import { frozen } from "../path";
import {
  imagesOf,
  middleOf,
  moved,
  onGrid,
  scaleBy,
  shiftBy,
  shiftExactly,
  shiftOnto,
  turnBy,
  unlessStill,
} from "./moving";
import { type Network, patchesRound } from "./network";
import { crestOf, forceFor, heightOf, laidAt, pointAt, regionBetween, rimOf, unfolded } from "./sculpting";
import { pointOn } from "./surface";

function model(id: string): Network {
  const shape = NETWORKED.find((each) => each.id === id)?.shape;
  if (shape?.kind !== "vertex-frame") throw new Error(id);
  return shape;
}

const leaf = model("own-leaf");

test("what is picked is moved, turned and scaled, and nothing else", () => {
  const picked = new Set([0, 2]);
  const up = moved(leaf, picked, shiftBy([0, 0, 1.5]));
  expect(up.vertices.map(([, , z], place) => z - (leaf.vertices[place]?.[2] ?? 0))).toEqual([
    1.5, 0, 1.5, 0, 0, 0, 0, 0,
  ]);
  expect(middleOf(leaf, picked)).toEqual([0, -6, 0]);
  const turned = moved(leaf, picked, turnBy([0, -6, 0], [0, 0, 1], Math.PI / 2));
  expect([turned.vertices[0], turned.vertices[2]]).toEqual([
    [0, -12, 0],
    [0, 0, 0],
  ]);
  const wide = moved(leaf, picked, scaleBy([0, -6, 0], 2, [1, 0, 0]));
  expect([wide.vertices[0], wide.vertices[2]]).toEqual([
    [-12, -6, 0],
    [12, -6, 0],
  ]);
  expect(moved(leaf, picked, scaleBy([0, 0, 0], 0.5, null)).vertices[0]).toEqual([-3, -3, 0]);
});

test("where nothing moves along an axis its number stays, and what is typed is kept to its last digit", () => {
  const fine: Network = {
    ...leaf,
    vertices: leaf.vertices.map((point, at) => (at === 0 ? [-6.123456, -6.123456, 0.123456] : point)),
  };
  const picked = new Set([0]);
  expect(moved(fine, picked, shiftBy([0, 0, 0.4321987])).vertices[0]?.slice(0, 2)).toEqual([-6.123456, -6.123456]);
  expect(moved(fine, picked, shiftExactly([1.234567 + 6.123456, 0, 0])).vertices[0]).toEqual([
    1.234567, -6.123456, 0.123456,
  ]);
});

test("corners that would meet stay apart", () => {
  expect(moved(leaf, new Set([0]), () => leaf.vertices[2] ?? [0, 0, 0])).toBe(leaf);
});

test("what meets another point is where that is, to the last digit, and corners that would meet stay apart", () => {
  const fine: Network = { ...leaf, vertices: leaf.vertices.with(2, [6.12345678901, -6, 0.333333333333]) };
  const [first = [0, 0, 0], , third = [0, 0, 0]] = fine.vertices;
  expect(moved(fine, new Set([1]), shiftOnto(fine.vertices[1] ?? first, third)).vertices[1]).toEqual(third);
  expect(moved(fine, new Set([0]), shiftOnto(first, third))).toBe(fine);
});

test("the image in a mirror follows, and what is in it stays there", () => {
  expect([...imagesOf(leaf, "x")].sort()).toEqual([
    [0, 2],
    [1, 1],
    [2, 0],
    [3, 7],
    [4, 6],
    [5, 5],
    [6, 4],
    [7, 3],
  ]);
  const pulled = moved(leaf, new Set([3]), shiftBy([1, 2, 3]), "x");
  expect([pulled.vertices[3], pulled.vertices[7]]).toEqual([
    [8, 2, 1],
    [-8, 2, 1],
  ]);
  const held = moved(leaf, new Set([1]), shiftBy([1, 2, 3]), "x");
  expect(held.vertices[1]).toEqual([0, -5, 6]);
});

test("a motion after which every point is where it was is none", () => {
  const still = moved(leaf, new Set([1]), shiftBy([3, 0, 0]), "x");
  expect(still).not.toBe(leaf);
  expect(unlessStill(still, leaf)).toBe(leaf);
  const up = moved(leaf, new Set([1]), shiftBy([3, 0, 1]), "x");
  expect(unlessStill(up, leaf)).toBe(up);
  // Back where it began it has moved from where it was last.
  expect(unlessStill(still, up)).toBe(still);
});

test("points go to a grid along the ways that they move", () => {
  expect(onGrid([1.2, 3.4, -0.6], 0.5)).toEqual([1, 3.5, -0.5]);
  expect(onGrid([1.2, 3.4, -0.6], 0.5, [0, 0, 1])).toEqual([1.2, 3.4, -0.5]);
});

test("patches round one are laid out so that every point on a common edge has one place", () => {
  for (const id of ["own-face", "own-mug", "own-spouted"]) {
    const network = model(id);
    for (const patch of [0, 3, 7]) {
      const laid = unfolded(network, patch);
      expect(laid.length).toBeGreaterThan(3);
      for (const [x, y] of [
        [0.3, 0],
        [1, 0.7],
        [0.2, 1],
        [0, 0.6],
      ] as const) {
        const own = pointOn(network, patch, x, y);
        const near = laid.slice(1).flatMap((each) => {
          const [dx, dy] = [x - each.origin[0], y - each.origin[1]];
          const [u, v] = [dx * each.along[0] + dy * each.along[1], dx * each.across[0] + dy * each.across[1]];
          if (u < -1e-9 || u > 1 + 1e-9 || v < -1e-9 || v > 1 + 1e-9) return [];
          expect(laidAt(each, u, v).map((value) => (Math.abs(value) < 1e-12 ? 0 : value))).toEqual(
            [x, y].map((value) => expect.closeTo(value, 12)),
          );
          return [pointOn(network, each.patch, u, v)];
        });
        for (const point of near.slice(0, 1)) {
          expect(Math.hypot(...point.map((value, axis) => value - (own[axis] ?? 0)))).toBeLessThan(1e-9);
        }
      }
    }
  }
});

test("a region is drawn between two places, and pushes as far as it is told", () => {
  const face = model("own-face");
  const patch = face.patches[5];
  if (!patch) throw new Error("the face has no such patch");
  const force = regionBetween(patch, [1.4, 0.2], [0.6, 0.9], [0, -2, 0]);
  expect([force.u, force.v, force.falloff]).toEqual([[0.6, 1.4], [0.2, 0.9], "smooth"]);
  expect(heightOf(patch, force)[1]).toBeCloseTo(-2, 3);
  expect(forceFor(patch, [0, 0, 0])).toEqual([0, 0, 0]);
  expect(crestOf(force)).toEqual([1, 0.55]);
  expect(rimOf(force, 4).length).toBe(16);
  const laid = unfolded(face, 5);
  for (const place of rimOf(force, 4)) expect(pointAt(face, laid, place)).not.toBe(null);
  expect(pointAt(face, laid, [9, 9])).toBe(null);
});

test("the patches round vertices are those that have one of them, and what was moved of a frozen network is frozen", () => {
  const mug = frozen(structuredClone(model("own-mug")));
  for (const vertices of [[0], [3, 17, 40], [0, 0, 1], [9999]]) {
    const expected = mug.patches.flatMap(({ frame }, patch) =>
      frame.some((each) => vertices.includes(each)) ? [patch] : [],
    );
    expect(patchesRound(mug, vertices)).toEqual(expected);
  }
  const next = moved(mug, new Set([3]), shiftBy([0.1, 0, 0]));
  expect(next).not.toBe(mug);
  expect([next.vertices, ...next.vertices].every(Object.isFrozen)).toBe(true);
});
