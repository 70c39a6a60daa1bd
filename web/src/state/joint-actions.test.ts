import { beforeEach, expect, test } from "vitest";
import { inUnit } from "../document/scaled";
import type { Design, Joint, Part, Shape } from "../document/types";
import { changeJoint, type Jointed, moveJoint } from "./joint-actions";
import { placeParts, standingOf } from "./place-actions";
import { addParts, deleteParts, duplicateParts } from "./scene-actions";
import { NEW_SESSION } from "./session";
import { Store } from "./store";

const SHAPE: Shape = { kind: "second-order", r: [1, 0, 2, 0], height: 3 };
const LIFT: Joint = { label: "Lift the lid", limits: [5, 9], glued: true };
const SCENE: Design = {
  pasu: 1,
  parts: [
    { name: "jar", shape: SHAPE },
    { name: "lid", object: 1, shape: SHAPE, place: { shift: [0, 0, 5] }, joints: { z: LIFT } },
    {
      name: "knob",
      object: 1,
      shape: SHAPE,
      place: { shift: [0, 1, 6] },
      joints: { z: { limits: [6, 7] }, turn: { limits: [-1, 1] } },
    },
  ],
};

let store: Store;
let [lid, knob] = [0, 0];

beforeEach(() => {
  store = new Store(SCENE, NEW_SESSION);
  [, lid, knob] = store.ids as [number, number, number];
});

const jointed = (id: number, name: Jointed["name"]): Jointed => {
  const place = store.ids.indexOf(id);
  const part = store.design.parts[place] as Part;
  return { id, place, part, name, joint: part.joints?.[name] as Joint };
};
const shift = (id: number) => standingOf(store.state, id).shift;

test("a slider moves what is glued to its part, and one drag is one step", () => {
  for (const value of [5.5, 6, 7.25]) store.apply(moveJoint(store.state, jointed(lid, "z"), value));
  store.endGesture();
  expect([shift(lid), shift(knob)]).toEqual([
    [0, 0, 7.25],
    [0, 1, 8.25],
  ]);
  // The knob's own slider stands where it stood, from where it is.
  expect(jointed(knob, "z").joint.limits).toEqual([8.25, 9.25]);
  expect(jointed(lid, "z").joint.limits).toEqual([5, 9]);
  store.undo();
  expect(store.design).toBe(SCENE);
});

test("a turn takes what is glued along about the part", () => {
  store.apply(changeJoint(store.state, lid, "turn", { limits: [-2, 2], glued: true }));
  store.apply(moveJoint(store.state, jointed(lid, "turn"), Math.PI / 2));
  expect(shift(lid)).toEqual([0, 0, 5]);
  expect(shift(knob)).toEqual([-1, 0, 6]);
  expect(standingOf(store.state, knob).angle).toBeCloseTo(Math.PI / 2, 12);
});

test("alone a part leaves what it is glued to", () => {
  store.apply(moveJoint(store.state, jointed(knob, "z"), 6.5));
  expect([shift(lid)[2], shift(knob)[2]]).toEqual([5, 6.5]);
});

test("a part that is put elsewhere takes its limits along, a copy too, and one that goes takes its sliders", () => {
  store.apply(placeParts(store.state, new Map([[lid, { ...standingOf(store.state, lid), shift: [3, 0, 7] }]])));
  expect(jointed(lid, "z").joint).toEqual({ ...LIFT, limits: [7, 11] });
  store.apply(duplicateParts(store.state, [lid], 10));
  expect(store.design.parts[2]).toMatchObject({ name: "lid 2", joints: { z: { ...LIFT, limits: [7, 11] } } });
  store.apply(deleteParts(store.state, [lid]));
  expect(store.design.parts.map(({ joints }) => Object.keys(joints ?? {}))).toEqual([[], ["z"], ["z", "turn"]]);
  store.apply(addParts(store.state, SCENE.parts.slice(1, 2), [20, 0, 1]));
  expect(store.design.parts.at(-1)?.joints?.z?.limits).toEqual([6, 10]);
});

test("what need not be said is not, and the last slider leaves nothing behind", () => {
  store.apply(changeJoint(store.state, lid, "z", { label: "", limits: [0, 1], axis: [0, 0, 1], glued: false }));
  expect(store.design.parts[1]?.joints).toEqual({ z: { limits: [0, 1] } });
  store.apply(changeJoint(store.state, lid, "z", null));
  expect(store.design.parts[1]).not.toHaveProperty("joints");
  expect(changeJoint(store.state, lid, "z", null).undo).toBe("none");
});

test("in inches limits are inches, and turns are turns", () => {
  const inches = inUnit(SCENE, "in");
  expect(inches.parts[1]?.joints?.z?.limits[0]).toBeCloseTo(5 / 2.54, 11);
  expect(inches.parts[2]?.joints?.turn?.limits).toEqual([-1, 1]);
  expect(inUnit(inches, "cm").parts[1]?.joints?.z?.limits[1]).toBeCloseTo(9, 10);
});
