import { expect, test } from "vitest";
import { matrixOf, placedAll } from "../document/placement";
import { reachOf } from "./reach";

/** A tall drum of rings, each turned a little against the one below. */
function drum(): Float32Array {
  const points: number[] = [];
  for (let row = 0; row <= 40; row += 1) {
    for (let column = 0; column < 90; column += 1) {
      const angle = (2 * Math.PI * (column + row / 7)) / 90;
      points.push(2 * Math.cos(angle), 1.5 * Math.sin(angle), row / 8);
    }
  }
  return new Float32Array(points);
}

function boxOf(points: ArrayLike<number>): readonly number[] {
  const box = [0, 1, 2].flatMap((axis) => {
    const along = Array.from(points).filter((_, i) => i % 3 === axis);
    return [Math.min(...along), Math.max(...along)];
  });
  return box;
}

test("of a part that is moved, or scaled and turned as it was, the box is that of every point", () => {
  const points = drum();
  for (const place of [{}, { scale: [1, 2, 0.5] }, { axis: [1, 0, 0], angle: 0.7 }, { scale: [1, -1, 1] }] as const) {
    const turn = matrixOf(place);
    const moved = matrixOf({ ...place, shift: [3, -4, 5] });
    if (!turn || !moved) throw new Error("no placement");
    const [few, all] = [boxOf(placedAll(moved, reachOf(points, turn))), boxOf(placedAll(moved, points))];
    for (const [side, value] of few.entries()) expect(value).toBeCloseTo(all[side] as number, 10);
  }
});

test("of a part that is being turned it is known within a hundredth", () => {
  const points = drum();
  const few = reachOf(points, null);
  expect(few.length).toBeLessThan(points.length / 10);
  for (let k = 0; k < 20; k += 1) {
    const place = { axis: [Math.cos(k), Math.sin(k), 0.3], angle: k / 3 } as const;
    const there = matrixOf(place);
    if (!there) throw new Error("no placement");
    const [guess, all] = [boxOf(placedAll(there, few)), boxOf(placedAll(there, points))];
    for (const [side, value] of guess.entries()) expect(Math.abs(value - (all[side] as number))).toBeLessThan(0.05);
  }
});

test("nothing reaches nowhere", () => {
  expect(reachOf(new Float32Array(), null)).toEqual(new Float32Array());
});
