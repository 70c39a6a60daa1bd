import { effect } from "@preact/signals-core";
import { beforeEach, describe, expect, test } from "vitest";
import { getPath } from "../document/path";
import { type Field, familyOf } from "../document/schema";
import type { Design, Handle, Shape } from "../document/types";
import * as actions from "./actions";
import { changePlace } from "./place-actions";
import { setUnit } from "./scale-actions";
import { NEW_SESSION } from "./session";
import * as shapeActions from "./shape-actions";
import { Store } from "./store";
import { setMap, setWater } from "./wall-actions";

const family = familyOf("second-order");
const named = (symbol: string) => family?.fields.find((field) => field.symbol === symbol) as Field;
const RIM = named("r_1");
const PULL = [named("t_x"), named("t_y")] as const;

const START: Design = { pasu: 1, title: "Start", parts: [{ shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] } }] };

const RIM_HANDLE: Handle = { id: "rim", radial: [{ path: "r[0]", by: 1 }], axial: [], restraints: [] };
const OTHER: Shape = { kind: "mixed-order", r: [1, 0.1, 0.6, 0.06], rise: -10 };

let store: Store;
beforeEach(() => {
  store = new Store(START, NEW_SESSION);
});

const rim = () => getPath(store.state.design, ["parts", 0, "shape", "r", 0]);
const set = (value: number, gesture: boolean) =>
  store.apply(shapeActions.setFields(store.state, [RIM], value, gesture));

/** A slider drag, as the page makes it. */
function drag(...values: number[]): void {
  for (const value of values) set(value, true);
  store.endGesture();
}

describe("undo", () => {
  test("one drag is one step", () => {
    drag(1.1, 1.2, 1.3);
    expect(rim()).toBe(1.3);
    store.undo();
    expect(rim()).toBe(1);
    expect(store.canUndo).toBe(false);
    store.redo();
    expect(rim()).toBe(1.3);
  });

  test("a drag that ends where it began is no step, though what was left out is written out now", () => {
    drag(1.1, 1);
    expect(store.canUndo).toBe(false);
    expect(store.design).toEqual(START);
    const moved = { ...START, parts: START.parts.map((part) => ({ ...part, place: { shift: [1, 0, 0] as const } })) };
    store.apply({ design: moved, undo: "none" });
    for (const x of [2, 1]) store.apply(changePlace(store.state, (place) => ({ ...place, shift: [x, 0, 0] }), "shift"));
    store.endGesture();
    expect(store.canUndo).toBe(false);
    expect(store.design).toEqual(moved);
  });

  test("two drags of the same slider are two steps", () => {
    drag(1.1, 1.2);
    drag(1.3);
    store.undo();
    expect(rim()).toBe(1.2);
  });

  test("a gesture that changes hands is two steps", () => {
    set(1.1, true);
    store.apply(shapeActions.dragHandle(store.state, RIM_HANDLE, 0.2, 0));
    store.undo();
    expect(rim()).toBe(1.1);
  });

  test("a gesture that was not meant never happened", () => {
    drag(1.1);
    set(1.2, true);
    set(1.3, true);
    store.cancelGesture();
    expect(rim()).toBe(1.1);
    expect(store.canRedo).toBe(false);
    store.cancelGesture();
    expect(rim()).toBe(1.1);
    store.undo();
    expect(rim()).toBe(1);
  });

  test("a drag that ends where it began is no step, and what was undone before can still be redone", () => {
    drag(1.1);
    drag(1.2);
    store.undo();
    const before = store.design;
    drag(1.2, 1.3, 1.1);
    expect(store.design).toBe(before);
    expect(store.canRedo).toBe(true);
    store.redo();
    expect(rim()).toBe(1.2);
    drag(1.3, 1.2);
    store.undo();
    expect(rim()).toBe(1.1);
  });

  test("a gesture that was not meant takes nothing from what can be redone, and while it lasts nothing is", () => {
    drag(1.1);
    store.undo();
    set(1.4, true);
    expect(store.canRedo).toBe(false);
    store.redo();
    expect(rim()).toBe(1.4);
    store.cancelGesture();
    expect([rim(), store.canRedo]).toEqual([1, true]);
    store.redo();
    expect(rim()).toBe(1.1);
    // What was meant and is undone is what can be redone then.
    store.undo();
    set(1.4, true);
    store.undo();
    store.redo();
    expect([rim(), store.canRedo]).toEqual([1.4, false]);
    // A second hand makes two steps of it, of which the first was meant.
    store.undo();
    set(1.5, true);
    store.apply(shapeActions.dragHandle(store.state, RIM_HANDLE, 0.2, 0));
    store.cancelGesture();
    expect([rim(), store.canRedo]).toEqual([1.5, false]);
  });

  test("a new step forgets what was undone", () => {
    drag(1.1);
    store.undo();
    drag(1.5);
    expect(store.canRedo).toBe(false);
  });

  test("going back ends the gesture", () => {
    set(1.1, true);
    store.undo();
    expect(store.inGesture).toBe(false);
    set(1.2, true);
    store.undo();
    expect(rim()).toBe(1);
  });

  test("an opened design can be left again", () => {
    store.apply(actions.openDesign(store.state, { pasu: 1, parts: START.parts }));
    store.undo();
    expect(store.state.design.title).toBe("Start");
  });

  test("hundreds of steps are kept, not all", () => {
    for (let i = 0; i < 700; i += 1) set(2 + i, false);
    let steps = 0;
    while (store.canUndo) {
      store.undo();
      steps += 1;
    }
    expect(steps).toBe(500);
  });
});

describe("actions", () => {
  test("nothing changed is nothing done", () => {
    const before = store.state;
    set(1, true);
    store.apply(actions.setTitle(store.state, "Start"));
    store.apply(setUnit(store.state, "cm"));
    expect(store.state.design).toBe(before.design);
    expect(store.canUndo).toBe(false);
  });

  test("a look is chosen by fields, of which each may be taken back, and a hand's choosing is one step", () => {
    const look = () => store.state.design.parts[0]?.look;
    store.apply(actions.setLook(store.state, { glaze: "#112233" }, "look:glaze"));
    store.apply(actions.setLook(store.state, { glaze: "#445566" }, "look:glaze"));
    store.endGesture();
    store.apply(actions.setLook(store.state, { inside: "clear" }));
    store.apply(actions.setLook(store.state, { line: 0.25 }));
    expect(look()).toEqual({ glaze: "#445566", inside: "clear", line: 0.25 });
    store.apply(actions.setLook(store.state, { inside: undefined, line: undefined }));
    expect(look()).toEqual({ glaze: "#445566" });
    expect(actions.setLook(store.state, { glaze: "#445566", line: undefined }).undo).toBe("none");
    for (let i = 0; i < 4; i += 1) store.undo();
    expect(look()).toBeUndefined();
    expect(store.canUndo).toBe(false);
  });

  test("a locked parameter sets x and y in one step", () => {
    store.apply(shapeActions.setFields(store.state, PULL, 0.2, false));
    expect(store.state.design.parts[0]?.shape).toMatchObject({ t: [0.2, 0.2] });
    store.undo();
    expect(store.canUndo).toBe(false);
  });

  test("unlocking changes no number, locking again takes x", () => {
    store.apply(shapeActions.setLock(store.state, PULL, false));
    expect(store.state.session.unlocked).toEqual(["t"]);
    expect(store.canUndo).toBe(false);
    store.apply(shapeActions.setFields(store.state, [PULL[0]], 0.3, false));
    expect(store.state.design.parts[0]?.shape).toMatchObject({ t: [0.3, 0.5] });
    store.apply(shapeActions.setLock(store.state, PULL, true));
    expect(store.state.design.parts[0]?.shape).toMatchObject({ t: [0.3, 0.3] });
    expect(store.state.session.unlocked).toEqual([]);
  });

  test("opening another design ends the water, the cut and the colours of the one before", () => {
    store.apply(setWater(store.state, true));
    store.apply(setMap("overhang"));
    store.apply(actions.toggleOverlay(store.state, "axes"));
    store.apply(actions.openDesign(store.state, { ...START, title: "Other" }));
    const { fill, map, overlays } = store.state.session;
    expect({ fill, map, cut: overlays.cut, axes: overlays.axes }).toEqual({
      fill: null,
      map: null,
      cut: false,
      axes: true,
    });
  });

  test("a title is at most 200 characters and one line", () => {
    store.apply(actions.setTitle(store.state, `  a\nb${"🏺".repeat(300)}`));
    expect([...(store.state.design.title ?? "")].length).toBe(200);
    expect(store.state.design.title).toMatch(/^a b🏺/u);
    store.apply(actions.setTitle(store.state, ""));
    expect("title" in store.state.design).toBe(false);
  });

  test("switching the order is one step and ends a comparison", () => {
    store.apply(actions.compareWith("fourth-order"));
    store.apply(shapeActions.switchOrder(store.state, OTHER));
    expect(store.state.design.parts[0]?.shape.kind).toBe("mixed-order");
    expect(store.state.session.compare).toBeNull();
    store.undo();
    expect(store.state.design).toBe(store.state.design);
    expect(store.state.design.parts[0]?.shape.kind).toBe("second-order");
  });

  test("a document cannot be changed behind the history's back", () => {
    expect(Object.isFrozen(store.state.design.parts[0]?.shape)).toBe(true);
  });
});

test("who looks at something hears of that alone, once for each change, and not after leaving", () => {
  const heard = { design: 0, title: 0, session: 0, gesture: [] as boolean[], undo: [] as boolean[] };
  const leaving = [
    effect(() => void (store.design && heard.design++)),
    effect(() => void (store.title && heard.title++)),
    effect(() => void (store.session && heard.session++)),
    effect(() => void heard.gesture.push(store.inGesture)),
    effect(() => void heard.undo.push(store.canUndo)),
  ];
  set(1.1, true);
  set(1.2, true);
  store.endGesture();
  store.endGesture();
  expect(heard).toEqual({ design: 3, title: 1, session: 1, gesture: [false, true, false], undo: [false, true] });
  store.apply(actions.openDesign(store.state, { ...START, title: "Another" }));
  expect(heard).toMatchObject({ design: 4, title: 2, session: 2 });
  for (const leave of leaving) leave();
  store.undo();
  expect(heard).toMatchObject({ design: 4, title: 2, session: 2 });
});

test("undo and redo say that they led here, until the next change", () => {
  set(1.1, false);
  expect(store.travelled).toBe(false);
  store.undo();
  expect(store.travelled).toBe(true);
  store.redo();
  expect(store.travelled).toBe(true);
  set(1.2, true);
  expect(store.travelled).toBe(false);
  store.cancelGesture();
  expect(store.travelled).toBe(false);
});
