import { expect, test } from "vitest";
import { realMaker } from "../../../testing/real-maker";
import {
  addKnot,
  gapAt,
  lineOn,
  measured,
  moveAxis,
  moveKnot,
  placed,
  plainLine,
  profileOf,
  removeKnot,
  type Sheet,
  scaleOf,
  sharpenKnot,
  withSides,
  withSymmetry,
} from "./sheet";

const EMPTY: Sheet = { right: [], left: null, axis: 240, height: 20 };
const PLAIN: Sheet = { ...EMPTY, right: plainLine(240, 40, 440) };

test("an empty sheet has no profile, and neither has a level line", () => {
  expect(profileOf(EMPTY)).toBeNull();
  expect(scaleOf(EMPTY)).toBeNull();
  const level = [
    { x: 250, y: 9, sharp: false },
    { x: 300, y: 9, sharp: false },
  ];
  expect(profileOf({ ...EMPTY, right: level })).toBeNull();
});

test("a profile begins at the foot and is as high as it is to be", () => {
  const { right, left } = profileOf(PLAIN) ?? { right: [] };
  expect(left).toBeUndefined();
  expect(right.slice(0, 2)).toEqual([4.4, 0]);
  expect(right.slice(-2)).toEqual([4, 20]);
  expect(profileOf({ ...PLAIN, height: 5 })?.right.slice(-2)).toEqual([1, 5]);
});

test("a point that is moved keeps the scale; a new line keeps the height", () => {
  const higher = moveKnot(PLAIN, "right", 2, { x: 320, y: 20 });
  expect(higher.height).toBe(21);
  expect(measured(higher, higher.right[1] ?? { x: 0, y: 0 })).toEqual({ radius: 6.4, height: 10 });
  const anew = withSides(higher, plainLine(240, 140, 240), null);
  expect(anew.height).toBe(21);
  expect(profileOf(anew)?.right.at(-1)).toBe(21);
});

test("radius and height are where they are said to be, on either side", () => {
  const both = withSymmetry(PLAIN, false);
  for (const side of ["right", "left"] as const) {
    const spot = placed(both, side, 3, 12);
    expect(measured(both, spot)).toEqual({ radius: 3, height: 12 });
    expect(Math.sign(spot.x - 240)).toBe(side === "right" ? 1 : -1);
  }
});

test("no point and no part of a line crosses the axis", () => {
  expect(moveKnot(PLAIN, "right", 1, { x: 10, y: 240 }).right[1]).toMatchObject({ x: 240, y: 240 });
  const both = moveKnot(withSymmetry(PLAIN, false), "left", 1, { x: 300, y: 240 });
  expect(both.left?.[1]).toMatchObject({ x: 240 });
  // A deep waist would swing across.
  const waist = moveKnot(moveKnot(PLAIN, "right", 1, { x: 240, y: 300 }), "right", 0, { x: 400, y: 305 });
  expect(Math.min(...lineOn(waist, "right").map(({ x }) => x))).toBeGreaterThanOrEqual(240);
  expect(moveAxis(PLAIN, 340).right.every(({ x }) => x >= 340)).toBe(true);
});

test("points come, go and become corners", () => {
  const more = addKnot(PLAIN, "right", 1);
  expect(more.right).toHaveLength(4);
  expect(more.right[2]?.y).toBeLessThan(PLAIN.right[1]?.y ?? 0);
  expect(profileOf(more)?.right.at(-1)).toBe(20);
  expect(addKnot(PLAIN, "right", 2)).toBe(PLAIN);
  const fewer = removeKnot(removeKnot(PLAIN, "right", 1), "right", 0);
  expect(fewer.right).toHaveLength(2);
  expect(sharpenKnot(PLAIN, "right", 1, true).right.map(({ sharp }) => sharp)).toEqual([false, true, false]);
  const [a, b] = PLAIN.right;
  expect(gapAt(PLAIN, "right", { x: ((a?.x ?? 0) + (b?.x ?? 0)) / 2, y: 340 }, 14)).toBe(0);
  expect(gapAt(PLAIN, "right", { x: 20, y: 20 }, 14)).toBeNull();
});

test("sides are alike, or each its own and back", () => {
  const both = withSymmetry(PLAIN, false);
  expect(both.left?.map(({ x }) => 480 - x)).toEqual(PLAIN.right.map(({ x }) => x));
  expect(profileOf(both)?.left).toEqual(profileOf(PLAIN)?.right);
  expect(withSymmetry(both, true)).toEqual(PLAIN);
});

test("rings are fitted to what is drawn, within the distance that is asked for", async () => {
  const { maker } = realMaker({ free: true });
  const drawn = moveKnot(withSymmetry(sharpenKnot(PLAIN, "right", 1, true), false), "left", 1, { x: 90, y: 250 });
  for (const sheet of [PLAIN, drawn]) {
    const profile = profileOf(sheet);
    if (!profile) throw new Error("it is drawn");
    const fitted = await maker.ask({ kind: "fit", profile, tolerance: 0.05 });
    if (fitted.state !== "done") throw new Error(JSON.stringify(fitted));
    expect(fitted.value.distance).toBeLessThanOrEqual(0.05);
    expect(fitted.value.shape.rings.at(-1)?.z.mean).toBeCloseTo(20, 1);
    expect(fitted.value.shape.rings.some(({ sharp }) => sharp)).toBe(sheet === drawn);
  }
});
