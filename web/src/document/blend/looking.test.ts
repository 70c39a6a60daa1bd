import { expect, test } from "vitest";
import type { Blend, Section, Triple } from "../types";
import { type Look, leftOf, sheetsOf, USUAL, uncut } from "./looking";

const disc = (z: number): Section => ({ form: "disc", radius: [2, 1], z, taper: 0, dz: 3 });
const box = (z: number): Section => ({ form: "rectangle", radius: [2, 1], z, taper: 0, dz: 3 });
const ROUND: Blend = { kind: "blend", start: disc(0), end: disc(3) };
const SQUARE: Blend = { kind: "blend", start: box(0), end: box(3) };

/** Of each run of triangles that share points: which parameters stay the same, and where. */
function heldOf(blend: Blend, look: Partial<Look>): string[] {
  const { at, indices } = sheetsOf(blend, { ...USUAL, ...look });
  const sheet = new Map<number, number>();
  const find = (point: number): number => {
    const next = sheet.get(point) ?? point;
    return next === point ? point : find(next);
  };
  for (let each = 0; each < indices.length; each += 3) {
    const roots = [0, 1, 2].map((corner) => find(indices[each + corner] ?? 0));
    const least = Math.min(...roots);
    for (const root of roots) sheet.set(root, least);
  }
  const groups = new Map<number, number[]>();
  for (let point = 0; point < at.length / 3; point += 1)
    groups.set(find(point), [...(groups.get(find(point)) ?? []), point]);
  const value = (point: number, axis: number) => at[3 * point + axis] ?? Number.NaN;
  return [...groups.values()]
    .map((points) =>
      [0, 1, 2]
        .filter((axis) => points.every((point) => value(point, axis) === value(points[0] ?? 0, axis)))
        .map((axis) => `${"uvw"[axis]} ${value(points[0] ?? 0, axis)}`)
        .join(),
    )
    .sort();
}

test("three surfaces go all the way, each where its slider is", () => {
  const at: Triple = [0.25, 0.5, 0.75];
  for (const blend of [ROUND, SQUARE]) {
    expect(heldOf(blend, { shown: "surfaces", at })).toEqual(["u 0.25", "v 0.5", "w 0.75"]);
    const { at: places } = sheetsOf(blend, { ...USUAL, shown: "surfaces", at });
    expect(Math.max(...places)).toBe(1);
  }
});

test("a cut has all sides of what is left, and none that is a line or inside", () => {
  const at: Triple = [0.5, 0.25, 0.75];
  expect(heldOf(SQUARE, { at })).toEqual(["u 0", "u 0.5", "v 0", "v 0.25", "w 0", "w 0.75"]);
  expect(heldOf(ROUND, { at })).toEqual(["u 0.5", "v 0.25", "v 1", "w 0", "w 0.75"]);
  expect(heldOf(ROUND, { at: uncut(ROUND) })).toEqual(["u 1", "w 0", "w 1"]);
  expect(heldOf(SQUARE, { at: uncut(SQUARE) })).toEqual(["u 0", "u 1", "v 0", "v 1", "w 0", "w 1"]);
  const { at: places } = sheetsOf(ROUND, { ...USUAL, at });
  for (const [axis, [from, to]] of leftOf(ROUND, at).entries()) {
    const along = places.filter((_, index) => index % 3 === axis);
    expect([Math.min(...along), Math.max(...along)]).toEqual([axis === 0 ? 0 : from, to]);
  }
});

test("what all points of a row have in common is w, where it changes at all", () => {
  const { at } = sheetsOf(SQUARE, { ...USUAL, shown: "surfaces", at: [0.5, 0.5, 0.5] });
  let changes = 0;
  for (let point = 1; point < at.length / 3; point += 1) if (at[3 * point + 2] !== at[3 * point - 1]) changes += 1;
  expect(changes).toBeLessThan(2 * 40 + 3);
});
