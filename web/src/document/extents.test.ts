import { expect, test } from "vitest";
import { extentsOf, extentsTogether, farthestOf, isRound } from "./extents";

/** An outline in polar coordinates, with so many points, at two heights. */
function ring(radius: (v: number) => number, count: number): Float32Array {
  const points: number[] = [];
  for (let i = 0; i < count; i += 1) {
    const v = (2 * Math.PI * i) / count;
    for (const z of [1, 3.5]) points.push(3 + radius(v) * Math.cos(v), radius(v) * Math.sin(v) - 1, z);
  }
  return new Float32Array(points);
}

test("an oval along the diagonal is as wide as its long axis, not as its box", () => {
  // An ellipse with half axes 8 and 6, turned by 45 degrees.
  const radius = (v: number) => 1 / Math.hypot(Math.cos(v - Math.PI / 4) / 8, Math.sin(v - Math.PI / 4) / 6);
  const extents = extentsOf(ring(radius, 360));
  expect(extents).toMatchObject({ bottom: 1, height: 2.5 });
  expect(extents?.greatest.width).toBeCloseTo(16, 3);
  expect(extents?.greatest.direction).toBeCloseTo(45, 0);
  expect(extents?.least.width).toBeCloseTo(12, 2);
  expect(extents?.least.direction).toBeCloseTo(135, -1);
  // The box of this ellipse is 14.14 wide both ways.
  const middle = (extents?.greatest.low ?? 0) + (extents?.greatest.width ?? 0) / 2;
  expect(middle).toBeCloseTo((3 - 1) / Math.SQRT2, 2);
});

test("three petals are narrower than they are wide", () => {
  const extents = extentsOf(ring((v) => 10 + Math.cos(3 * v), 720));
  // Whatever is cut from one side, a petal stands on the other: a curve of nearly constant width.
  expect(extents?.greatest.width).toBeGreaterThan(extents?.least.width ?? Number.NaN);
  expect(extents?.least.width).toBeGreaterThan(19.5);
});

test("what is drawn round with corners is round, and an oval is not", () => {
  const round = extentsOf(ring(() => 5, 256));
  expect(round && isRound(round)).toBe(true);
  expect(round?.greatest.width).toBeCloseTo(10, 3);
  const oval = extentsOf(ring((v) => 5 + 0.01 * Math.cos(2 * v), 256));
  expect(oval && isRound(oval)).toBe(false);
});

test("a single point has no width, and nothing has no extents", () => {
  expect(extentsOf(new Float32Array([1, 2, 3]))).toMatchObject({ height: 0, greatest: { width: 0 } });
  expect(extentsOf(new Float32Array())).toBeNull();
});

test("extents of several sets are those of all their points", () => {
  const [one, other] = [
    ring((v) => 10 + Math.cos(3 * v), 300),
    ring(() => 4, 77).map((x, i) => (i % 3 === 2 ? x - 3 : x + 9)),
  ];
  const all = new Float64Array(one.length + other.length);
  all.set(one);
  all.set(other, one.length);
  expect(extentsTogether([farthestOf(one), farthestOf(other)])).toEqual(extentsOf(all));
  expect(extentsTogether([farthestOf(other), farthestOf([])])).toEqual(extentsOf(other));
  expect(extentsTogether([])).toBeNull();
});
