import { expect, test } from "vitest";
import { WRITTEN } from "../../testing/bottle";
import { pointOn } from "./curves";
import { meanOf, withMean, withPlace, withSharpRing } from "./written-rings";

test("the means of rings are read and written, and the other rings stay", () => {
  expect([0, 1].map((ring) => [meanOf(WRITTEN, ring, "radius"), meanOf(WRITTEN, ring, "height")])).toEqual([
    [6, 6],
    [1.6, 15],
  ]);
  const wide = withMean(withMean(WRITTEN, 1, "radius", 2.5), 1, "height", 14);
  expect(meanOf(wide, 1, "radius")).toBeCloseTo(2.5, 12);
  for (const v of [0, 1, 4]) {
    const [x, y, z] = pointOn(wide, 2, v) ?? [0, 0, 0];
    expect(Math.hypot(x, y)).toBeCloseTo(2.5, 12);
    expect(z).toBeCloseTo(14, 12);
    for (const other of [0, 1, 3]) expect(pointOn(wide, other, v)).toEqual(pointOn(WRITTEN, other, v));
  }
});

test("a mode that is not there is put there", () => {
  const flat = { ...WRITTEN, z: { ...WRITTEN.z, modes: [] } };
  const raised = withMean(flat, 0, "height", 3);
  expect(meanOf(raised, 0, "height")).toBe(3);
  expect(meanOf(raised, 1, "height")).toBe(0);
});

test("where the wall does not go once round the axis there is no radius", () => {
  const open = { ...WRITTEN, span: 3 };
  expect(meanOf(open, 0, "radius")).toBeNull();
  expect(withMean(open, 0, "radius", 9)).toBe(open);
});

test("a ring stays between its neighbours, and is sharp or is not", () => {
  expect(withPlace(WRITTEN, 0, 0.5).rings?.[0]?.u).toBe(0.5);
  expect(withPlace(WRITTEN, 0, 0.9).rings?.[0]?.u).toBeCloseTo(0.6999, 12);
  expect(withPlace(WRITTEN, 0, -1).rings?.[0]?.u).toBe(1e-4);
  const sharp = withSharpRing(WRITTEN, 1, true);
  expect(sharp.rings).toEqual([{ u: 0.35 }, { u: 0.7, sharp: true }]);
  expect(withSharpRing(sharp, 1, false).rings).toEqual(WRITTEN.rings);
});
