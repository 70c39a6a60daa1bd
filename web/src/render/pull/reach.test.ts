import { expect, test } from "vitest";
import type { Triple } from "../triple";
import { moved, reached, type See } from "./reach";

/** An eye at a distance along -y, so high, that looks at the axis: 500 pixels a unit at distance 1. */
function eye(distance: number, height = 0): See {
  const length = Math.hypot(distance, height);
  const [back, up] = [
    [0, -distance / length, height / length],
    [0, height / length, distance / length],
  ] as const;
  return ([x, y, z]) => {
    const depth = length - (back[1] * y + back[2] * z);
    return depth > 0 ? { x: 400 + (500 * x) / depth, y: 300 - (500 * (up[1] * y + up[2] * z)) / depth } : null;
  };
}

const seen = (see: See, point: Triple) => see(point) ?? { x: Number.NaN, y: Number.NaN };

test("a point at the side comes out to where the hand is, through the perspective", () => {
  const see = eye(30, 8);
  const point: Triple = [5, 0, 2];
  const from = seen(see, point);
  for (const pixels of [-40, -5, 12, 90]) {
    const by = reached(see, point, 5, { x: pixels, y: 0 }, "out");
    expect(by).toMatchObject({ up: 0, round: 0 });
    expect(Math.sign(by.out)).toBe(Math.sign(pixels));
    expect(seen(see, moved(point, by)).x).toBeCloseTo(from.x + pixels, 3);
  }
});

test("up and down follows the hand and takes no notice of what goes sideways", () => {
  const see = eye(30, 8);
  const point: Triple = [1, -4, 2];
  const from = seen(see, point);
  const by = reached(see, point, 5, { x: 35, y: -60 }, "up");
  const to = seen(see, moved(point, by));
  // The way up leans a little in perspective: the nearest point of it to the hand.
  expect(Math.abs(to.y - (from.y - 60))).toBeLessThan(2);
  expect(by.out).toBe(0);
});

test("round the axis the point is carried along its circle", () => {
  const see = eye(30, 8);
  const point: Triple = [0, -5, 2];
  const by = reached(see, point, 5, { x: 30, y: 0 }, "round");
  expect(seen(see, moved(point, by)).x).toBeGreaterThan(seen(see, point).x + 20);
  expect(by.round).toBeGreaterThan(0);
});

test("as the hand goes, both ways at once", () => {
  const see = eye(30, 8);
  const point: Triple = [5, -1, 2];
  const from = seen(see, point);
  const by = reached(see, point, 5, { x: 50, y: -30 }, "free");
  const to = seen(see, moved(point, by));
  expect(Math.hypot(to.x - from.x - 50, to.y - from.y + 30)).toBeLessThan(8);
  expect(by.out).toBeGreaterThan(0);
  expect(by.up).toBeGreaterThan(0);
});

test("towards the eye a hand moves no further than it would across", () => {
  const see = eye(30);
  for (const x of [0, 1e-9, 0.01, 0.5]) {
    const point: Triple = [x, -5, 0];
    for (const way of ["out", "up", "round", "free"] as const) {
      const by = reached(see, point, 5, { x: 40, y: 40 }, way);
      const length = Math.hypot(by.out, by.up, 5 * by.round);
      expect(Number.isFinite(length)).toBe(true);
      // 40 pixels across are two units and a bit: no more than three times that.
      expect(length).toBeLessThan((3.2 * Math.hypot(40, 40) * 25) / 500);
    }
  }
});

test("what is behind the eye is not moved", () => {
  expect(reached(() => null, [1, 0, 0], 1, { x: 9, y: 9 }, "out")).toEqual({ out: 0, up: 0, round: 0 });
});
