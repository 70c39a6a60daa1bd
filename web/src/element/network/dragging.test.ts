import { expect, test } from "vitest";
import type { Triple } from "../../document/types";
import type { See } from "../../render/pull/reach";
import { acrossView, type Grasp, moving, scaling, shifting, towardsEye, turning } from "./dragging";

/** Seen from the front, against y, with 10 pixels for a unit: x to the right, z up. */
const front: See = ([x, y, z]) => ({ x: 100 + 10 * x, y: 100 - 10 * z, depth: y });

const grasp = (more: Partial<Grasp> = {}): Grasp => ({
  see: front,
  at: [2, 0, 0],
  pivot: [0, 0, 0],
  way: null,
  size: 10,
  grid: null,
  from: { x: 120, y: 100 },
  ...more,
});

const near = (found: Triple, wanted: Triple) => {
  for (const [axis, value] of found.entries()) expect(value).toBeCloseTo(wanted[axis] ?? 0, 6);
};

test("a hand moves points in the plane across the view, or along a way", () => {
  near(acrossView(front, [0, 0, 0], 10, { x: 5, y: -20 }), [0.5, 0, 2]);
  near(towardsEye(front, [0, 0, 0], 10), [0, -1, 0]);
  near(moving(grasp(), { x: 5, y: -20 }, null)([2, 3, 0]), [2.5, 3, 2]);
  near(moving(grasp({ way: [0, 0, 1] }), { x: 5, y: -20 }, null)([2, 3, 0]), [2, 3, 2]);
  // A way that is seen end on cannot be gone along.
  near(moving(grasp({ way: [0, 1, 0] }), { x: 5, y: -20 }, null)([2, 3, 0]), [2, 3, 0]);
});

test("what the hand has goes to the grid, or to the point that it meets, and the rest comes along", () => {
  near(moving(grasp({ at: [2.1, 0, 0], grid: 0.5 }), { x: 3, y: -2 }, null)([2.1, 0, 0]), [2.5, 0, 0]);
  near(
    moving(grasp({ at: [2.1, 0, 0.2], grid: 0.5, way: [0, 0, 1] }), { x: 0, y: -9 }, null)([2.1, 0, 0.2]),
    [2.1, 0, 1],
  );
  near(moving(grasp(), { x: 3, y: -2 }, [4, 1, 1])([0, 0, 0]), [2, 1, 1]);
});

test("keys keep to the grid as a hand does", () => {
  near(shifting(grasp({ at: [2.1, 0, 0], grid: 0.5 }), [0.4, 0, -0.3])([2.1, 0, 0]), [2.5, 0, -0.5]);
  near(shifting(grasp({ at: [2.1, 0, 0.2], grid: 0.5, way: [0, 0, 1] }), [0, 0, 0.5])([2.1, 0, 0.2]), [2.1, 0, 0.5]);
  near(shifting(grasp({ at: [2.1, 0, 0.2] }), [0.4, 0, 0])([0, 1, 0]), [0.4, 1, 0]);
  // Whole steps along a normal are no places of the grid.
  near(shifting(grasp({ at: [0, 0, 0], grid: 1, way: [0.6, 0, 0.8] }), [0.6, 0, 0.8])([0, 0, 0]), [0.6, 0, 0.8]);
});

test("what is turned stays under the hand", () => {
  // From the right of the pivot to above it.
  const quarter = turning(grasp(), { x: -20, y: -20 });
  near(quarter([2, 0, 0]), [0, 0, 2]);
  // About an axis that points away from the eye it goes the same way round.
  near(turning(grasp({ way: [0, 1, 0] }), { x: -20, y: -20 })([2, 0, 0]), [0, 0, 2]);
  const held = turning(grasp({ from: { x: 100, y: 100 } }), { x: 50, y: 0 })([2, 0, 0]);
  expect(Math.hypot(...held)).toBeCloseTo(2, 9);
});

test("what is scaled grows as the hand goes away from the pivot, along an axis alone where there is one", () => {
  near(scaling(grasp(), { x: 20, y: 0 })([1, 2, 3]), [2, 4, 6]);
  near(scaling(grasp({ way: [0, 0, 1] }), { x: 20, y: 0 })([1, 2, 3]), [1, 2, 6]);
  // It never turns inside out.
  expect(scaling(grasp(), { x: -20, y: 0 })([1, 0, 0])[0]).toBeGreaterThan(0);
  near(scaling(grasp({ from: { x: 100, y: 100 } }), { x: 100, y: 0 })([1, 0, 0]), [2, 0, 0]);
});
