import { effect } from "@preact/signals-core";
import { beforeEach, expect, test } from "vitest";
import { getPath } from "../document/path";
import { type Field, familyOf } from "../document/schema";
import type { Design, Shape } from "../document/types";
import { openDesign } from "./actions";
import { Origins } from "./origins";
import { resize, setUnit } from "./scale-actions";
import { deleteParts, duplicateParts, movePart } from "./scene-actions";
import { selectParts } from "./seen-actions";
import { NEW_SESSION } from "./session";
import { resetFields, setFields, switchOrder } from "./shape-actions";
import { type Change, Store } from "./store";

const JAR: Shape = {
  kind: "fourth-order",
  r0: 5.5,
  r1: 5.4,
  rm: 9.4,
  h1: 20,
  eta: [1.4, -1.9],
  dz: [34, 9],
  s: [1, 1],
  t: [2, 2],
  w: [1, 1],
};
const FIRST: Design = { pasu: 1, title: "Shoulder jar", parts: [{ shape: JAR }] };
const OTHER: Design = { pasu: 1, title: "Tall", parts: [{ shape: { ...JAR, h1: 31 } }] };
const HEIGHT = familyOf("fourth-order")?.fields.find(({ key }) => key === "h1") as Field;

let store: Store;
let origins: Origins;
beforeEach(() => {
  store = new Store(FIRST, NEW_SESSION);
  origins = new Origins();
  let [before, were] = [store.design, store.ids];
  effect(() => {
    const { design, ids } = store;
    origins.follow(design, before, (place) => were.indexOf(ids[place] ?? -1));
    [before, were] = [design, ids];
  });
});

const height = (of: Design = store.state.design) => getPath(of, ["parts", 0, "shape", "h1"]);
const origin = () => origins.of(store.state.design);
const type = (value: number) => store.apply(setFields(store.state, [HEIGHT], value, false));
const open = (design: Design) => {
  origins.open(design);
  store.apply(openDesign(store.state, design));
};

test("a reset leads to what was opened, not to the pot of the paper", () => {
  type(44);
  type(45);
  store.apply(resetFields(store.state, [HEIGHT], origin().parts[0]?.shape as Shape));
  expect(height()).toBe(20);
});

test("undo to a design that was open before finds what that one was opened as", () => {
  type(44);
  open(OTHER);
  type(50);
  expect(height(origin())).toBe(31);
  store.undo();
  store.undo();
  expect(height()).toBe(44);
  expect(height(origin())).toBe(20);
  store.redo();
  expect(height(origin())).toBe(31);
});

test("the same design opened again after a change of it begins anew", () => {
  type(44);
  const changed = store.state.design;
  open({ ...changed });
  expect(height(origin())).toBe(44);
});

test("a part of another order begins anew, since what it was has none of its numbers", () => {
  type(44);
  store.apply(switchOrder(store.state, { kind: "second-order", r: [5.4, 0, 5.5, 0], height: 20 }));
  expect(origin().parts[0]?.shape).toBe(store.state.design.parts[0]?.shape);
  store.undo();
  expect(height(origin())).toBe(20);
});

test("another unit or size converts what the pot was opened as along with it", () => {
  const convert = (change: Change) => {
    if (change.design && change.convert) origins.convert(change.design, store.state.design, change.convert);
    store.apply(change);
  };
  type(30);
  convert(setUnit(store.state, "mm"));
  expect([height(), height(origin())]).toEqual([300, 200]);
  convert(resize(store.state, 2, "scale"));
  expect([height(), height(origin())]).toEqual([600, 400]);
  store.undo();
  store.undo();
  expect([height(), height(origin())]).toEqual([30, 20]);
});

test("work of an earlier visit goes on from where it was opened then", () => {
  origins.open(OTHER, FIRST);
  store.apply({ design: OTHER, undo: "none" });
  type(32);
  expect(height(origin())).toBe(20);
});

test("a reset leads each part to what that part was, wherever it stands by now, and a copy to what it was made as", () => {
  open({ pasu: 1, parts: [{ shape: JAR }, { shape: { ...JAR, h1: 31 } }] });
  const [first, second] = store.ids as [number, number];
  store.apply(selectParts(second));
  type(44);
  store.apply(movePart(store.state, second, -1));
  expect(height()).toBe(44);
  expect(height(origin())).toBe(31);
  store.apply(duplicateParts(store.state, [second], 20));
  expect(getPath(origin(), ["parts", 1, "shape", "h1"])).toBe(44);
  expect(getPath(origin(), ["parts", 2, "shape", "h1"])).toBe(20);
  store.apply(deleteParts(store.state, [second]));
  expect(height(origin())).toBe(44);
  store.apply(deleteParts(store.state, [first]));
  expect(origin().parts).toHaveLength(1);
});
