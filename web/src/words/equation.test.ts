import { expect, test } from "vitest";
import type { Shape } from "../document/types";
import type { Roots } from "../equation/roots";
import { pairOf } from "../equation/roots";
import { numbersWords, rootsWords } from "./equation";

const VASE: Shape = { kind: "second-order", r: [1, 0.1, 0.6, 0.06] };
const JUG: Shape = {
  kind: "rings",
  rings: [
    { u: 0, r: { mean: 4 }, z: { mean: 0 } },
    { u: 0.6, r: { mean: 6, waves: [{ n: 3, cos: 0.5, sin: 0.2 }] }, z: { mean: 8 } },
    { u: 1, r: { mean: 4.5 }, z: { mean: 14 } },
  ],
  rim: { r: { mean: 2 }, z: { mean: 9 } },
};
const x = { order: 4, s: 1, t: 2, w: 3, modes: [{ n: 5, cos: { start: 7, rings: [2], force: [1] } }] } as const;
const FREE: Shape = {
  kind: "boundary-value",
  span: 3,
  rings: [{ u: 0.5 }],
  x,
  y: x,
  z: { order: 2, s: 1, t: 0, modes: [] },
};

test.each([
  [VASE, ["r[1]"], /^Rim petal depth = 0\.1: How far the petals of the rim/],
  // What the document leaves out has a value all the same, and petals are those that the eye counts.
  [VASE, ["height"], /^Height = 3\.6: /],
  [VASE, ["n[1]"], /^Petals = 7: /],
  [VASE, ["t[0]", "s[0]", "n[0]"], /^Made of Waist pull, Wall stiffness, and Turns of the wall\.$/],
  [JUG, ["a"], /^Smoothing a = 1: /],
  [JUG, ["rings[1].r.mean"], /^Radius, Ring 1 = 6: /],
  [JUG, ["rings[2].z.mean"], /^Height, Rim = 14: /],
  [JUG, ["rings[1].u"], /^Place u, Ring 1 = 0\.6: /],
  [JUG, ["rings[1].r.waves[0].sin"], /^Wave 1 of Radius, Ring 1 = 0\.2: /],
  [JUG, ["rings[1].r.waves[0].n"], /^Frequency of wave 1 of Radius, Ring 1 = 3: /],
  [JUG, ["rim.r.mean"], /^Radius, slope at the rim = 2: How the wall arrives/],
  [FREE, ["x.t"], /^t of x = 2: /],
  [FREE, ["span"], /^Length of v = 3: /],
  [FREE, ["rings[0].u"], /^Place of ring 1 = 0\.5: /],
  [FREE, ["x.modes[0].n"], /^Frequency of mode 1 of x = 5: /],
  [FREE, ["x.modes[0].cos.start"], /^Value at u = 0, cos 5 of x = 7: /],
  [FREE, ["x.modes[0].cos.rings[0]"], /^Value at ring 1, Cosine 5 of x = 2: /],
  [FREE, ["x.modes[0].cos.force[0]"], /^Force, Cosine 5 of x = 1: /],
  // The same of two coordinates.
  [FREE, ["x.t", "y.t"], /^t of x and t of y = 2: /],
] as const)("%# a number is named, with its value and what it does", (shape, places, words) => {
  expect(numbersWords(shape, places)).toMatch(words);
});

test.each<[Roots, RegExp]>([
  [{ order: 2, kind: "single", pair: pairOf(0) }, /0: it runs straight/],
  [{ order: 2, kind: "single", pair: pairOf(4) }, /real roots, ±2:/],
  [{ order: 2, kind: "single", pair: pairOf(-9) }, /imaginary roots, ±3i: it swings/],
  [{ order: 4, kind: "double", pair: pairOf(0) }, /a cubic/],
  [{ order: 4, kind: "double", pair: pairOf(4) }, /±2, each twice/],
  [{ order: 4, kind: "double", pair: pairOf(-4) }, /±2i, each twice/],
  [{ order: 4, kind: "complex", sigma: 1, delta: 0.5 }, /±1 ± 0\.5i/],
  [{ order: 4, kind: "two", pairs: [pairOf(9), pairOf(4)] }, /real roots, ±3 and ±2/],
  [{ order: 4, kind: "two", pairs: [pairOf(9), pairOf(0)] }, /±3, and 0 twice: straight/],
  [{ order: 4, kind: "two", pairs: [pairOf(-9), pairOf(4)] }, /±2, imaginary ones ±3i/],
  [{ order: 4, kind: "two", pairs: [pairOf(-9), pairOf(-4)] }, /±2i and ±3i/],
  [{ order: 4, kind: "two", pairs: [pairOf(-9), pairOf(0)] }, /±3i, and 0 twice/],
])("%# a regime is said", (roots, words) => {
  expect(rootsWords(roots, 5)).toMatch(words);
});
