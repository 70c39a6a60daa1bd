import { expect, test } from "vitest";
import { carried, goneBy, isWithin, type JointName, jointValue } from "./joints";
import { mirrored, moved, turned, unit } from "./moving";
import { UNMOVED, type WholePlacement } from "./placement";
import type { Joint, Joints, Part, Placement, Shape, Triple } from "./types";

const VASE = { kind: "second-order", r: [1, 0, 2, 0], height: 3 } as Shape;
const DRAWER: Shape = { kind: "octant", exponents: [50, 40, 30] };
const HALF: Joint = { limits: [-Math.PI / 2, Math.PI / 2] };

const at = (place: Placement, shape: Shape = VASE): Part => ({ shape, place });

function toldOf(place: Placement, name: JointName, joint: Joint, shape: Shape = VASE): number {
  return jointValue(at(place, shape), name, joint);
}

test("a shift is the number of the placement itself", () => {
  const place = { shift: [1, -2, 3.5] as Triple };
  expect(toldOf(place, "x", HALF)).toBe(1);
  expect(toldOf(place, "y", HALF)).toBe(-2);
  expect(toldOf({}, "z", HALF)).toBe(0);
  expect(goneBy({ ...UNMOVED, ...place }, "z", HALF, 0.5, [0, 0, 0]).shift).toEqual([1, -2, 4]);
});

/** Of everything that a part was turned by before, upside down too. */
test("what turns about an axis adds to how far a part is turned about it", () => {
  const axes: readonly Triple[] = [
    [0, 0, 1],
    [1, 0, 0],
    [0, -1, 0],
    [1, 2, -3],
  ];
  const starts: readonly Placement[] = [
    {},
    { axis: [0, 0, 1], angle: 1 },
    { axis: [1, 0, 0], angle: -Math.PI },
    { axis: [0, 1, 0], angle: -Math.PI },
    { axis: [0, 0, 1], angle: -Math.PI },
    { axis: [1, 0, 0], angle: Math.PI / 2 },
    { axis: [0.3, 0.5, -0.2], angle: 2.5 },
  ];
  for (const axis of axes)
    for (const start of starts) {
      const before = { ...UNMOVED, ...start };
      const around: Joint = { axis, limits: [-7, 7] };
      const first = toldOf(before, "turn", { axis, limits: [-Math.PI, Math.PI] });
      for (const by of [0.25, -0.5, 1.5, 3, -3]) {
        const after = goneBy(before, "turn", around, by, [0, 0, 0]);
        const limits = [first + by - 1, first + by + 1] as const;
        expect(toldOf(after, "turn", { axis, limits }), JSON.stringify({ axis, start, by })).toBeCloseTo(first + by, 9);
      }
    }
});

test("of angles that turn alike the one within the limits is told, from 0 to a whole turn as well", () => {
  const turn = (angle: number) => ({ axis: [0, 0, 1] as Triple, angle });
  const whole: Joint = { limits: [0, 2 * Math.PI] };
  expect(toldOf(turn(0), "turn", whole)).toBe(0);
  expect(toldOf(turn(-0.5), "turn", whole)).toBeCloseTo(2 * Math.PI - 0.5, 12);
  expect(toldOf(turn(-Math.PI), "turn", whole)).toBeCloseTo(Math.PI, 12);
  expect(toldOf(turn(3), "turn", { limits: [-4, -2] })).toBeCloseTo(3 - 2 * Math.PI, 12);
});

test("outside the limits a value stays what it is", () => {
  expect(isWithin(HALF, toldOf({ axis: [0, 0, 1], angle: 2 }, "turn", HALF))).toBe(false);
  expect(toldOf({ axis: [0, 0, 1], angle: 2 }, "turn", HALF)).toBeCloseTo(2, 12);
  expect(isWithin({ limits: [0, 4] }, 4 + 1e-10)).toBe(true);
});

/** What `Design::parse` makes of a door of octant [30, 50, 40] that was turned by 60° about z: its edges in another order. */
test("a door that a link wrote with its edges in another order is as far open as it was", () => {
  const door: Joint = { limits: [0, Math.PI / 2] };
  const open = { scale: [1, 2, 3] as Triple, axis: [0, 0, 1] as Triple, angle: Math.PI / 3 };
  expect(toldOf(open, "turn", door, DRAWER)).toBeCloseTo(Math.PI / 3, 12);
  // The edge that was x points along y, nearly, and that which was y away from x: one is taken for a mirror image.
  const same = { scale: [2, -1, 3] as Triple, axis: [0, 0, 1] as Triple, angle: (Math.PI * 150) / 180 };
  expect(toldOf(same, "turn", door, DRAWER)).toBeCloseTo(Math.PI / 3, 9);
  expect(isWithin(door, toldOf(same, "turn", door))).toBe(false);
});

test("joints go along when a part is put elsewhere", () => {
  const joints: Joints = {
    x: { limits: [0, 4] },
    z: { label: "Lid", limits: [-1, 1], glued: true },
    turn: { limits: [-0.5, 0.5] },
  };
  const before: WholePlacement = { ...UNMOVED, shift: [1, 0, 0] };
  expect(carried(joints, before, before)).toBe(joints);
  expect(carried(joints, before, moved(before, [2, 5, -1]))).toEqual({
    x: { limits: [2, 6] },
    z: { label: "Lid", limits: [-2, 0], glued: true },
    turn: { limits: [-0.5, 0.5], axis: [0, 0, 1] },
  });
  // A quarter of a turn makes y of x.
  const quarter = turned(before, unit(2), Math.PI / 2, [0, 0, 0]);
  const after = carried(joints, before, quarter);
  expect(after.x).toBeUndefined();
  expect(after.y?.limits).toEqual([0, 4]);
  expect(after.turn?.limits[0]).toBeCloseTo(Math.PI / 2 - 0.5, 10);
  expect(toldOf(quarter, "turn", after.turn as Joint)).toBeCloseTo(Math.PI / 2, 10);
  // In a mirror what opened to one side opens to the other.
  const image = mirrored(before, 0, 0);
  const flipped = carried(joints, before, image);
  expect(flipped.x?.limits).toEqual([-4, 0]);
  expect(flipped.z?.limits).toEqual([-1, 1]);
  const value = toldOf(image, "turn", flipped.turn as Joint);
  const [least, most] = flipped.turn?.limits ?? [0, 0];
  expect(value - least).toBeCloseTo(0.5, 10);
  expect(most - value).toBeCloseTo(0.5, 10);
});

test("the axis of a turn goes along, and the limits of a turn never leave a whole one", () => {
  const door: Joints = { turn: { axis: [1, 0, 0], limits: [-1, 2] } };
  let place: WholePlacement = { ...UNMOVED, axis: [1, 0, 0], angle: 0.5 };
  let joints = door;
  for (const [axis, angle] of [
    [2, 1],
    [0, 2.5],
    [1, -2],
    [2, 3],
    [0, 3],
    [0, 3],
  ] as const) {
    const after = turned(place, unit(axis), angle, [0, 0, 0]);
    joints = carried(joints, place, after);
    place = after;
    const { limits } = joints.turn as Joint;
    const value = toldOf(place, "turn", joints.turn as Joint);
    expect(value - limits[0]).toBeCloseTo(1.5, 9);
    expect(limits[1] - value).toBeCloseTo(1.5, 9);
    for (const limit of limits) expect(Math.abs(limit)).toBeLessThanOrEqual(2 * Math.PI);
  }
});
