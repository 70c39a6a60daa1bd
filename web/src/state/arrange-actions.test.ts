import { beforeEach, expect, test } from "vitest";
import { type Box, boxOf } from "../document/box";
import { middleOf } from "../document/boxes";
import { matrixOf, placedAll, UNMOVED } from "../document/placement";
import type { Design, Part, Triple } from "../document/types";
import {
  alignOnAxis,
  alignParts,
  distributeParts,
  mirrorParts,
  putOnTable,
  ringOfParts,
  rowOfParts,
} from "./arrange-actions";
import type { PartId } from "./part-ids";
import { deleteParts, duplicateParts, gluedTo, glueTogether, separateParts } from "./scene-actions";
import { alsoSelect, selectedIds, selectParts } from "./seen-actions";
import { NEW_SESSION } from "./session";
import { lockParts, looseIds, selectThrough } from "./several-actions";
import { type Change, Store } from "./store";

/** Blocks: an octant is as wide, deep and high as its scale. */
const block = (name: string, scale: Triple, shift: Triple, more: Partial<Part> = {}): Part => ({
  name,
  shape: { kind: "octant", exponents: [50, 50, 50] },
  place: { scale, shift },
  ...more,
});
const SCENE: Design = {
  pasu: 1,
  parts: [
    block("Slab", [4, 4, 1], [0, 0, 0]),
    block("Post", [1, 1, 3], [6, 1, 2], { object: 1 }),
    block("Cap", [2, 2, 1], [9, 5, 5], { object: 1 }),
    block("Far", [1, 2, 1], [20, 0, -1], { object: 2 }),
  ],
};

let store: Store;
let [slab, post, cap, far] = [0, 0, 0, 0];

beforeEach(() => {
  store = new Store(SCENE, NEW_SESSION);
  [slab, post, cap, far] = store.ids as [number, number, number, number];
});

/** What the blocks fill now. */
function boxes(): ReadonlyMap<PartId, Box> {
  const corners = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [x, y, z])));
  return new Map(
    store.design.parts.map(({ place }, at) => [
      store.ids[at] as PartId,
      boxOf(placedAll(matrixOf(place) ?? [], corners)) as Box,
    ]),
  );
}
const box = (id: PartId) => boxes().get(id) as Box;
const names = () => store.design.parts.map(({ name }) => name);
const objects = () => store.design.parts.map(({ object }) => object ?? 0);
const step = (change: Change) => {
  expect(change.undo).toBe("step");
  store.apply(change);
};

test("parts come to the side of the one that was selected last, which stays", () => {
  store.apply(selectParts(slab, cap, post));
  step(alignParts(store.state, boxes(), 0, "low"));
  expect([slab, post, cap, far].map((id) => box(id).min[0])).toEqual([6, 6, 6, 20]);
  step(alignParts(store.state, boxes(), 1, "high"));
  expect([slab, post, cap].map((id) => box(id).max[1])).toEqual([2, 2, 2]);
  step(alignParts(store.state, boxes(), 2, "middle"));
  expect([slab, post, cap].map((id) => box(id).min[2] + box(id).max[2])).toEqual([7, 7, 7]);
  // What is aligned already is no step.
  expect(alignParts(store.state, boxes(), 2, "middle").undo).toBe("none");
  for (let i = 0; i < 3; i += 1) store.undo();
  expect(store.design).toBe(SCENE);
});

test("parts come onto one axis, and each to the table", () => {
  store.apply(selectParts(post, cap, slab));
  step(alignOnAxis(store.state, new Map([...boxes()].map(([id, each]) => [id, middleOf(each)]))));
  for (const id of [post, cap, slab])
    expect([box(id).min[0] + box(id).max[0], box(id).min[1] + box(id).max[1]]).toEqual([4, 4]);
  step(putOnTable(store.state, boxes()));
  // The block that is not selected stands lower than 0: there the table is.
  for (const id of [post, cap, slab]) expect(box(id).min[2]).toBe(-1);
});

test("gaps become equal between the outermost, which stay", () => {
  store.apply(selectParts(far, post, slab, cap));
  step(distributeParts(store.state, boxes(), 0));
  expect([box(slab).min[0], box(far).max[0]]).toEqual([0, 21]);
  const gap = (20 - 4 - 1 - 2) / 3;
  expect(box(post).min[0]).toBeCloseTo(4 + gap, 4);
  expect(box(cap).min[0] - box(post).max[0]).toBeCloseTo(gap, 4);
  expect(box(far).min[0] - box(cap).max[0]).toBeCloseTo(gap, 4);
  store.apply(selectParts(far, slab));
  expect(distributeParts(store.state, boxes(), 0).undo).toBe("none");
});

test("a mirror image fills what its parts filled, the other way round, and mirrored again it is they", () => {
  store.apply(selectParts(post, cap));
  const before = boxes();
  step(mirrorParts(store.state, before, 0));
  // From 6 to 11: what was at the left is at the right.
  expect([box(post).min[0], box(post).max[0]]).toEqual([10, 11]);
  expect([box(cap).min[0], box(cap).max[0]]).toEqual([6, 8]);
  expect(store.design.parts[1]?.place?.scale?.[1]).toBeLessThan(0);
  step(mirrorParts(store.state, boxes(), 0));
  for (const id of [post, cap]) expect(box(id)).toEqual(before.get(id));
});

test("a row and a ring of what is glued to others are glued to these too", () => {
  store.apply(selectParts(cap));
  step(rowOfParts(store.state, 3, [0, 7, 0]));
  expect(objects()).toEqual([0, 1, 1, 1, 1, 2]);
  store.undo();
  step(ringOfParts(store.state, 3, 2 * Math.PI, [0, 0], true));
  expect(objects()).toEqual([0, 1, 1, 1, 1, 2]);
  store.undo();
  // A whole object is glued to nothing beside it, and one copy is put aside as an object of its own.
  store.apply(selectParts(far, cap));
  step(rowOfParts(store.state, 2, [0, 7, 0]));
  expect(objects()).toEqual([0, 1, 1, 2, 1, 3]);
  store.undo();
  step(duplicateParts(store.state, [cap], 9));
  expect(objects()).toEqual([0, 1, 1, 3, 2]);
});

test("a row and a ring are copies, glued among themselves as their first is", () => {
  store.apply(selectParts(post, cap));
  step(rowOfParts(store.state, 3, [0, 7, 0]));
  expect(names()).toEqual(["Slab", "Post", "Cap", "Post 2", "Cap 2", "Post 3", "Cap 3", "Far"]);
  expect(objects()).toEqual([0, 1, 1, 3, 3, 4, 4, 2]);
  expect(store.design.parts[5]?.place?.shift).toEqual([6, 15, 2]);
  expect(selectedIds(store.state)).toHaveLength(6);
  store.undo();
  expect(store.design).toBe(SCENE);
  store.apply(selectParts(far));
  step(ringOfParts(store.state, 4, 2 * Math.PI, [0, 0], true));
  const places = store.design.parts.slice(3).map(({ place }) => ({ ...UNMOVED, ...place }));
  expect(places.map(({ shift }) => shift)).toEqual([
    [20, 0, -1],
    [0, 20, -1],
    [-20, 0, -1],
    [0, -20, -1],
  ]);
  expect(places.map(({ angle }) => Math.round((angle / Math.PI) * 180))).toEqual([0, 90, -180, -90]);
  store.undo();
  step(ringOfParts(store.state, 3, Math.PI, [0, 0], false));
  const half = store.design.parts.slice(3).map(({ place }) => ({ ...UNMOVED, ...place }));
  expect(half.map(({ shift }) => shift)).toEqual([
    [20, 0, -1],
    [0, 20, -1],
    [-20, 0, -1],
  ]);
  expect(half.every(({ angle }) => angle === 0)).toBe(true);
});

test("no design comes to have more parts than there may be", () => {
  expect(rowOfParts(store.state, 497, [9, 0, 0]).design?.parts).toHaveLength(500);
  expect(rowOfParts(store.state, 498, [9, 0, 0]).undo).toBe("none");
});

test("what is locked stays where it is, and all else goes to it", () => {
  store.apply(lockParts(store.state, [post], true));
  store.apply(selectParts(slab, cap, post));
  expect(looseIds(store.state)).toEqual([slab, cap]);
  step(alignParts(store.state, boxes(), 0, "low"));
  expect([slab, post, cap].map((id) => box(id).min[0])).toEqual([6, 6, 6]);
  const stood = box(post);
  step(mirrorParts(store.state, boxes(), 1));
  expect(box(post)).toEqual(stood);
  store.apply(lockParts(store.state, [post], false));
  expect(looseIds(store.state)).toHaveLength(3);
});

test("parts are selected besides others, and through the list", () => {
  store.apply(alsoSelect(store.state, cap));
  expect(selectedIds(store.state)).toEqual([slab, cap]);
  store.apply(alsoSelect(store.state, slab));
  store.apply(alsoSelect(store.state, cap));
  expect(selectedIds(store.state)).toEqual([cap]);
  store.apply(selectThrough(store.state, slab));
  expect(selectedIds(store.state)).toEqual([post, cap, slab]);
  expect(store.part).toBe(0);
});

test("several are copied, deleted, glued and separated as one step", () => {
  step(duplicateParts(store.state, [post, cap], 10));
  expect(names()).toEqual(["Slab", "Post", "Cap", "Post 2", "Cap 2", "Far"]);
  expect(objects()).toEqual([0, 1, 1, 3, 3, 2]);
  step(deleteParts(store.state, selectedIds(store.state)));
  expect(names()).toEqual(["Slab", "Post", "Cap", "Far"]);
  expect(selectedIds(store.state)).toEqual([far]);
  expect(deleteParts(store.state, store.ids).undo).toBe("none");
  step(glueTogether(store.state, [slab, post]));
  expect(objects()).toEqual([1, 1, 1, 2]);
  expect(gluedTo(store.state, [cap])).toEqual([slab, post, cap]);
  step(separateParts(store.state, [slab, post, cap]));
  expect(new Set(objects()).size).toBe(4);
  expect(separateParts(store.state, [slab, post]).undo).toBe("none");
});
