import { expect, test } from "vitest";
import type { See } from "../pull/reach";
import type { Triple } from "../triple";
import { across, alongLine, inPlane } from "./onto";

/** From the front and a little from above, ten units away, with perspective. */
const TILT = 0.4;
const see: See = ([x, y, z]) => {
  const [c, s] = [Math.cos(TILT), Math.sin(TILT)];
  const depth = 10 + c * y - s * z;
  return depth > 0 ? { x: 300 + (500 * x) / depth, y: 200 - (500 * (s * y + c * z)) / depth, depth } : null;
};
const spotOf = (point: Triple) => {
  const spot = see(point);
  if (!spot) throw new Error("behind the eye");
  return spot;
};

const X: Triple = [1, 0, 0];
const Y: Triple = [0, 1, 0];
const Z: Triple = [0, 0, 1];

test("a hand on a line is where the line is seen", () => {
  for (const [way, t] of [
    [X, 2.5],
    [Y, -3],
    [Z, 1.25],
    [[0.6, 0, 0.8], -2],
  ] as const) {
    const from: Triple = [0.5, 1, -0.5];
    const spot = spotOf([from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]]);
    expect(alongLine(see, from, way, 1, spot)).toBeCloseTo(t, 8);
  }
});

test("beside a line it is at the nearest place", () => {
  const spot = spotOf([2, 0, 0]);
  expect(alongLine(see, [0, 0, 0], X, 1, { x: spot.x, y: spot.y + 40 })).toBeCloseTo(2, 8);
});

test("a line that is seen end on cannot be followed", () => {
  const straight: See = ([x, y, z]) => ({ x: (500 * x) / (10 + y), y: (500 * z) / (10 + y), depth: 10 + y });
  expect(alongLine(straight, [0, 0, 0], Y, 1, { x: 3, y: 3 })).toBeNull();
  expect(alongLine(() => null, [0, 0, 0], X, 1, { x: 0, y: 0 })).toBeNull();
});

test("a hand in a plane is where the plane is seen, up to its horizon", () => {
  const found = inPlane(see, [1, 0, 0], [X, Y], 1, spotOf([-1, 2, 0]));
  expect(found?.[0]).toBeCloseTo(-2, 8);
  expect(found?.[1]).toBeCloseTo(2, 8);
  // Above the horizon there is no table.
  expect(inPlane(see, [0, 0, 0], [X, Y], 1, { x: 300, y: -400 })).toBeNull();
});

test("a plane that is seen edge on cannot be pointed into", () => {
  const straight: See = ([x, y, z]) => ({ x: (500 * x) / (10 + y), y: (500 * z) / (10 + y), depth: 10 + y });
  expect(inPlane(straight, [0, 0, 0], [X, Y], 1, { x: 3, y: 3 })).toBeNull();
  expect(inPlane(straight, [0, 0, 0], [X, Z], 1, { x: 50, y: 100 })?.map((each) => each.toFixed(6))).toEqual([
    "1.000000",
    "2.000000",
  ]);
});

test("a length across the view is so many pixels, however the view is turned", () => {
  expect(across(see, [0, 0, 0], 1)).toBeCloseTo(50, 0);
  expect(across(see, [0, 0, 0], 2)).toBeCloseTo(100, 0);
});
