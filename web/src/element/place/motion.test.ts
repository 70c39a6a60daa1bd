import { expect, test } from "vitest";
import { UNMOVED } from "../../document/placement";
import type { Triple } from "../../document/types";
import type { See } from "../../render/pull/reach";
import { type Grip, type Hold, motionOf, onRing, placesAfter, type Steps, toTable } from "./motion";

/** From the front and from above, with perspective. */
const TILT = 0.5;
const see: See = ([x, y, z]) => {
  const [c, s] = [Math.cos(TILT), Math.sin(TILT)];
  const depth = 30 + c * y - s * z;
  return { x: 300 + (900 * x) / depth, y: 200 - (900 * (s * y + c * z)) / depth, depth };
};
/** From the front, the left and above: no ring is seen edge on. */
const aslant: See = ([x, y, z]) => {
  const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
  return see([c * x - s * y, s * x + c * y, z]);
};
/** From straight ahead, where the table is a line. */
const level: See = ([x, y, z]) => ({ x: (900 * x) / (30 + y), y: (-900 * z) / (30 + y), depth: 30 + y });

const PIVOT: Triple = [2, 1, 3];
const STEPS: Steps = { length: 0.5, angle: 15, factor: 0.1 };

function hold(grip: Grip, from: Triple = PIVOT, seen = see): Hold {
  const spot = seen(from) ?? { x: 0, y: 0 };
  const places = new Map([
    [3, { ...UNMOVED, shift: [5, 0, 0] as Triple }],
    [7, { ...UNMOVED, shift: [2.2, 1, 0] as Triple }],
  ]);
  return {
    grip,
    see: seen,
    spot,
    pivot: PIVOT,
    reach: 4,
    isBehind: false,
    along: [0, 0, 1],
    low: 0.8,
    table: 0,
    step: 0.5,
    places,
  };
}

const between = (from: Triple, to: Triple, seen = see) => {
  const [a, b] = [seen(from), seen(to)];
  if (!a || !b) throw new Error("behind the eye");
  return { x: b.x - a.x, y: b.y - a.y };
};

test("a handle of an axis goes with the hand along it, to a pixel", () => {
  const found = motionOf(hold({ kind: "move", axis: 0 }), between(PIVOT, [4.5, 1, 3]), null);
  expect(found).toEqual({ kind: "move", by: [2.5, 0, 0], onTable: false });
  const by = between(PIVOT, [4.5123456, 1, 3]);
  expect(motionOf(hold({ kind: "move", axis: 0 }), by, null)).toEqual({
    kind: "move",
    by: [2.51, 0, 0],
    onTable: false,
  });
});

test("in steps the numbers of the part that was selected last become round", () => {
  const found = motionOf(hold({ kind: "move", axis: 0 }), between(PIVOT, [3, 1, 3]), STEPS);
  expect(found).toEqual({ kind: "move", by: [0.8, 0, 0], onTable: false });
  const places = found && placesAfter(hold({ kind: "move", axis: 0 }), found);
  expect(places?.get(7)?.shift).toEqual([3, 1, 0]);
  expect(places?.get(3)?.shift).toEqual([5.8, 0, 0]);
});

test("in steps what comes near to the table stands on it, exactly", () => {
  const found = motionOf(hold({ kind: "move", axis: 2 }), between(PIVOT, [2, 1, 2.4]), STEPS);
  expect(found).toEqual({ kind: "move", by: [0, 0, -0.8], onTable: true });
  expect(motionOf(hold({ kind: "move", axis: 2 }), between(PIVOT, [2, 1, 2.4]), null)).toMatchObject({
    onTable: false,
  });
  expect(toTable(0.80000001, 0, 4)).toBe(-0.8);
});

test("over the table a hand has both directions, and from straight ahead the one that is seen", () => {
  expect(motionOf(hold({ kind: "free" }), between(PIVOT, [0, 4, 3]), null)).toEqual({
    kind: "move",
    by: [-2, 3, 0],
    onTable: false,
  });
  const flat = motionOf(hold({ kind: "free" }, PIVOT, level), between(PIVOT, [3, 1, 5], level), null);
  expect(flat).toEqual({ kind: "move", by: [1, 0, 0], onTable: false });
});

test("a ring turns as the hand goes round it, and its parts about the middle", () => {
  for (const axis of [0, 1, 2] as const) {
    const from = onRing(PIVOT, 4, axis, 0.4);
    const grip: Grip = { kind: "turn", axis };
    const by = between(from, onRing(PIVOT, 4, axis, 1.4), aslant);
    const found = motionOf(hold(grip, from, aslant), by, null);
    if (found?.kind !== "turn") throw new Error("no turn");
    expect(Math.abs((found.angle * 180) / Math.PI - 57.3)).toBeLessThan(0.5);
    const stepped = motionOf(hold(grip, from, aslant), by, STEPS);
    expect(stepped).toEqual({ kind: "turn", axis, angle: Math.PI / 3 });
  }
  const quarter = placesAfter(hold({ kind: "turn", axis: 2 }), { kind: "turn", axis: 2, angle: Math.PI / 2 });
  expect(quarter.get(3)).toEqual({ ...UNMOVED, angle: Math.PI / 2, shift: [3, 4, 0] });
});

test("a ring that is seen edge on rolls under the hand", () => {
  // The front of the upright axis' ring goes to the right when it turns anti-clockwise as seen from above.
  const found = motionOf(hold({ kind: "turn", axis: 2 }, PIVOT, level), { x: 40, y: 0 }, null);
  expect(found?.kind === "turn" && found.angle).toBeGreaterThan(0.2);
  expect(motionOf(hold({ kind: "turn", axis: 2 }, PIVOT, level), { x: -40, y: 0 }, null)).toMatchObject({
    angle: -(found?.kind === "turn" ? found.angle : 0),
  });
});

test("scaling keeps the foot where it is, and never turns a part inside out", () => {
  const along = hold({ kind: "scale", axis: 2 });
  expect(motionOf(along, between(PIVOT, [2, 1, 7]), null)).toEqual({ kind: "scale", axis: 2, factor: 2 });
  expect(motionOf(along, between(PIVOT, [2, 1, -1]), null)).toEqual({ kind: "scale", axis: 2, factor: 0.5 });
  // Away from the middle it grows, on whichever side the handle stands.
  const behind = { ...along, isBehind: true };
  expect(motionOf(behind, between(PIVOT, [2, 1, -1]), null)).toEqual({ kind: "scale", axis: 2, factor: 2 });
  expect(motionOf(behind, between(PIVOT, [2, 1, 7]), null)).toEqual({ kind: "scale", axis: 2, factor: 0.5 });
  const far = motionOf(along, { x: 0, y: 5000 }, null);
  expect(far === null || (far.kind === "scale" && far.factor > 0)).toBe(true);
  expect(placesAfter(along, { kind: "scale", axis: null, factor: 2 }).get(7)).toEqual({
    ...UNMOVED,
    scale: [2, 2, 2],
    shift: [2.4, 1, -0.8],
  });
  const whole = motionOf(hold({ kind: "scale", axis: null }), { x: 60, y: -60 }, STEPS);
  expect(whole).toMatchObject({ axis: null });
  expect(whole?.kind === "scale" && Number.isInteger(Math.round(10 * whole.factor * 1e6) / 1e6)).toBe(true);
});
