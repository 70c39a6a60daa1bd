import { beforeEach, expect, test } from "vitest";
import type { Design } from "../document/types";
import { selectParts } from "./seen-actions";
import { NEW_SESSION } from "./session";
import { lockParts } from "./several-actions";
import { type Rims, standOn } from "./stand-actions";
import { Store } from "./store";

/** A jar whose mouth is off its middle, and a lid that stands upside down beside it. */
const DESIGN: Design = {
  pasu: 1,
  parts: [
    { name: "Jar", shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] } },
    {
      name: "Lid",
      object: 1,
      shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] },
      place: { axis: [1, 0, 0], angle: -Math.PI, shift: [9, 0, 2] },
    },
  ],
};
const rim = (x: number, y: number, high: number, width: number) => ({ middle: [x, y] as const, high, width });

let store: Store;
let [jar, lid] = [0, 0];
let rims: ReadonlyMap<number, Rims>;
let boxes: ReadonlyMap<number, { min: readonly [number, number, number]; max: readonly [number, number, number] }>;

beforeEach(() => {
  store = new Store(DESIGN, NEW_SESSION);
  [jar, lid] = store.ids as [number, number];
  rims = new Map([
    [jar, { upper: rim(0.5, 0, 10.25, 6), lower: rim(0, 0, 0, 4) }],
    [lid, { upper: rim(9, 0, 2, 1), lower: rim(9, 0, 0, 4) }],
  ]);
  boxes = new Map([
    [jar, { min: [-5, -5, 0], max: [5, 5, 10.25] }],
    [lid, { min: [7, -2, -0.5], max: [11, 2, 2] }],
  ] as const);
  store.apply(selectParts(lid, jar));
});

const placeOf = () => store.design.parts[1]?.place;

test("a lid comes over the middle of the rim, and a hair above the highest of it", () => {
  store.apply(standOn(store.state, boxes, rims, false));
  // From 9 to 0.5, and from -0.5 to 10.25 and a thousandth of 6.
  expect(placeOf()).toMatchObject({ scale: [1, 1, 1], angle: -Math.PI, shift: [0.5, 0, 12.756] });
  store.undo();
  expect(store.design).toBe(DESIGN);
});

test("glued to it, it touches", () => {
  store.apply({ design: { ...DESIGN, parts: DESIGN.parts.map(({ object: _, ...part }) => part) }, undo: "step" });
  store.apply(standOn(store.state, boxes, rims, false));
  expect(placeOf()?.shift).toEqual([0.5, 0, 12.75]);
});

test("it becomes as wide as the rim, and stays as high", () => {
  store.apply(standOn(store.state, boxes, rims, true));
  expect(placeOf()).toMatchObject({ scale: [1.5, 1.5, 1], shift: [0.5, 0, 12.756] });
});

test("what does not stand upright grows as a whole, and keeps its foot on the rim", () => {
  const tilted = { ...DESIGN.parts[1], place: { axis: [0, 1, 0], angle: 0.5, shift: [9, 0, 2] } };
  store.apply({ design: { ...DESIGN, parts: [DESIGN.parts[0], tilted] } as Design, undo: "step" });
  store.apply(standOn(store.state, boxes, rims, true));
  expect(placeOf()?.scale).toEqual([1.5, 1.5, 1.5]);
  // Its origin was 2.5 above the foot, and is 1.5 times as far above it now.
  expect(placeOf()?.shift?.[2]).toBeCloseTo(10.256 + 1.5 * 2.5, 9);
});

test("a locked lid stays, and one alone stands on nothing", () => {
  store.apply(lockParts(store.state, [lid], true));
  expect(standOn(store.state, boxes, rims, false).undo).toBe("none");
  store.apply(lockParts(store.state, [lid], false));
  store.apply(selectParts(lid));
  expect(standOn(store.state, boxes, rims, false).undo).toBe("none");
});
