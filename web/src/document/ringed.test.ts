import { expect, test } from "vitest";
import { bump, ringed, series, times, together, wave } from "./ringed";
import type { Wave } from "./types";

/** What a mean and its waves come to at an angle. */
const at = ([mean, ...waves]: readonly [number, ...Wave[]], v: number) =>
  waves.reduce((sum, { n, cos = 0, sin = 0 }) => sum + cos * Math.cos(n * v) + sin * Math.sin(n * v), mean);

test("rings are along the profile as far apart as they are in the clay", () => {
  const pot = ringed([3, 3, [6, { n: 2, cos: 1 }], 6], [0, 4, 8, 13]);
  expect(pot.rings.map(({ u }) => u)).toEqual([0, 0.286, 0.643, 1]);
  expect(pot.rings[2]?.r).toEqual({ mean: 6, waves: [{ n: 2, cos: 1 }] });
  expect(pot.rings[3]).toEqual({ u: 1, r: { mean: 6 }, z: { mean: 13 } });
  expect(ringed([1, 2], [0, 1], { a: 0.5, rim: { r: { mean: 1 }, z: { mean: 2 } } })).toMatchObject({
    a: 0.5,
    rim: { r: { mean: 1 } },
  });
});

test("a wave that is turned has its crest so many of its turns on", () => {
  expect(wave(3, 0.5)).toEqual({ n: 3, cos: 0.5 });
  const turned = wave(3, 0.5, 0.25);
  expect(at([0, turned], (2 * Math.PI * 0.25) / 3)).toBeCloseTo(0.5, 3);
});

test.each([1, 4, 8])("a bump is a power of a cosine, with %d waves", (N) => {
  const pulled = bump(2, N);
  expect(pulled.length).toBe(N + 1);
  for (let v = 0; v < 6.2; v += 0.4) expect(at(pulled, v)).toBeCloseTo(2 * Math.cos(v / 2) ** (2 * N), 3);
});

test("what is laid on something is added to it, wave by wave", () => {
  const sum = together(3, [1, { n: 5, cos: 1 }, { n: 2, sin: 0.5 }], [0, { n: 5, cos: -1, sin: 0.25 }]);
  expect(sum).toEqual([4, { n: 2, sin: 0.5 }, { n: 5, sin: 0.25 }]);
  expect(series(sum)).toEqual({
    mean: 4,
    waves: [
      { n: 2, sin: 0.5 },
      { n: 5, sin: 0.25 },
    ],
  });
  expect(series(together(times({ mean: 4, waves: [{ n: 2, cos: 0.5 }] }, 2), -1))).toEqual({
    mean: 7,
    waves: [{ n: 2, cos: 1 }],
  });
  expect(series(2)).toEqual({ mean: 2 });
});
