/** What holds of pots of rings wherever the page asks something of a shape. */

import { expect, test } from "vitest";
import { datumNames, withOrder } from "./boundary-value";
import { filled } from "./kinds";
import { convertible } from "./orders";
import { sharesHandles } from "./profile";
import { shapeBy } from "./scaled";
import { familyOf } from "./schema";
import type { BoundaryValue, Rings } from "./types";
import { highestFrequency } from "./waves";

const JUG: Rings = {
  kind: "rings",
  a: 2,
  rings: [
    { u: 0, r: { mean: 4 }, z: { mean: 0 } },
    {
      u: 0.6,
      sharp: true,
      r: {
        mean: 6,
        waves: [
          { n: 3, cos: 0.5 },
          { n: 5, sin: -0.25 },
        ],
      },
      z: { mean: 8 },
    },
    { u: 1, r: { mean: 4.5 }, z: { mean: 14, waves: [{ n: 1, cos: 0.5, sin: 0.125 }] } },
  ],
  rim: { r: { mean: 2 }, z: { mean: 9 } },
};

const FREE: BoundaryValue = {
  kind: "boundary-value",
  span: "2pi",
  rings: [{ u: 0.5 }],
  x: { order: 4, s: 1, t: 2, w: 1, free: "start", modes: [{ n: 1, cos: { start: 1, end: 2, end_u: 1, rings: [3] } }] },
  y: { order: 4, s: 1, t: 2, w: 1, modes: [] },
  z: { order: 2, s: 1, t: 2, modes: [] },
};

test("radii, heights and slopes grow; places, waves and weights stay", () => {
  expect(shapeBy(JUG, 2)).toEqual({
    kind: "rings",
    a: 2,
    rings: [
      { u: 0, r: { mean: 8 }, z: { mean: 0 } },
      {
        u: 0.6,
        sharp: true,
        r: {
          mean: 12,
          waves: [
            { n: 3, cos: 1 },
            { n: 5, sin: -0.5 },
          ],
        },
        z: { mean: 16 },
      },
      { u: 1, r: { mean: 9 }, z: { mean: 28, waves: [{ n: 1, cos: 1, sin: 0.25 }] } },
    ],
    rim: { r: { mean: 4 }, z: { mean: 18 } },
  });
  const twice = shapeBy(FREE, 2) as BoundaryValue;
  expect(twice.rings).toEqual(FREE.rings);
  expect(twice.x.modes[0]?.cos).toEqual({ start: 2, end: 4, end_u: 2, rings: [6] });
  expect(twice.x.free).toBe("start");
});

test("what a radius does is one wave more in x and in y", () => {
  expect(highestFrequency(JUG)).toBe(6);
  const tilted = { ...JUG, rings: JUG.rings.map((ring) => ({ ...ring, z: { mean: 1, waves: [{ n: 9, cos: 1 }] } })) };
  expect(highestFrequency(tilted)).toBe(9);
  expect(highestFrequency({ kind: "rings", rings: JUG.rings.slice(0, 1) })).toBe(1);
});

test("they are no family of numbers, and keep their order", () => {
  expect(familyOf("rings")).toBeNull();
  expect(convertible("rings")).toBe(false);
  expect(filled(JUG)).toBe(JUG);
});

test("handles are those of another pot with as many rings and the same free ends", () => {
  const { rim: _rim, ...free } = JUG;
  expect(sharesHandles(JUG, shapeBy(JUG, 2))).toBe(true);
  expect(sharesHandles(JUG, free)).toBe(false);
  expect(sharesHandles(JUG, { ...JUG, rings: JUG.rings.slice(1) })).toBe(false);
  expect(sharesHandles(JUG, FREE)).toBe(false);
});

test("a free end has no slope, and no component of order 2 a free end", () => {
  expect(datumNames(FREE.x)).toEqual(["start", "end", "end_u"]);
  expect(datumNames({ ...FREE.x, free: "both" })).toEqual(["start", "end"]);
  expect(datumNames(FREE.y)).toEqual(["start", "end", "start_u", "end_u"]);
  expect(withOrder(FREE, "x", 2).x).toEqual({
    order: 2,
    s: 1,
    t: 2,
    modes: [{ n: 1, cos: { start: 1, end: 2, rings: [3] } }],
  });
});
