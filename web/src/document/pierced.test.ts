import { expect, test } from "vitest";
import { piercedBy } from "./pierced";
import type { Hit } from "./types";

const hit = (part: number, distance: number): Hit => ({
  part,
  distance,
  point: [distance, 0, 0],
  normal: [-1, 0, 0],
  face: null,
  patch: 0,
  u: null,
  v: null,
});

test("each part is told once, where it is met first, and how far behind the nearest", () => {
  const hits = [hit(2, 5), hit(0, 3), hit(2, 6), hit(1, 4), hit(0, 9)];
  expect(piercedBy(hits, () => true)).toEqual([
    { part: 0, behind: 0 },
    { part: 1, behind: 1 },
    { part: 2, behind: 2 },
  ]);
  expect(piercedBy([], () => true)).toEqual([]);
});

test("what is hidden or cut away does not count, and a part is met where it is left", () => {
  const hits = [hit(0, 3), hit(1, 4), hit(0, 9)];
  expect(piercedBy(hits, ({ point }) => point[0] > 3.5)).toEqual([
    { part: 1, behind: 0 },
    { part: 0, behind: 5 },
  ]);
  expect(piercedBy(hits, ({ part }) => part !== 0)).toEqual([{ part: 1, behind: 0 }]);
});
