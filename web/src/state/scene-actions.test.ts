import { beforeEach, expect, test } from "vitest";
import { JAR } from "../../testing/jar";
import { familyOf } from "../document/schema";
import type { Design, Part } from "../document/types";
import { partName } from "../words/parts";
import { openDesign } from "./actions";
import {
  addParts,
  deleteParts,
  duplicateParts,
  gluePart,
  isTaken,
  MAX_NAME,
  movePart,
  renamePart,
  splitOff,
} from "./scene-actions";
import { hiddenParts, selectedIds, selectParts, togglePart } from "./seen-actions";
import { NEW_SESSION } from "./session";
import { setFields } from "./shape-actions";
import { Store } from "./store";

const [part] = JAR.parts as readonly [Part];
const SCENE: Design = {
  pasu: 1,
  parts: [{ ...part, name: "Body" }, { ...part, name: "Lid", place: { angle: 1, shift: [0, 0, 20] } }, { ...part }],
};

let store: Store;
let [body, lid, foot] = [0, 0, 0];

beforeEach(() => {
  store = new Store(SCENE, NEW_SESSION);
  [body, lid, foot] = store.ids as [number, number, number];
});

const names = () => store.design.parts.map(({ name }, place) => partName(place, name));

test("every part has an identity of its own, of which the document knows nothing", () => {
  expect(new Set(store.ids).size).toBe(3);
  expect(JSON.stringify(store.design)).toBe(JSON.stringify(SCENE));
});

test("a part keeps its identity through changes of its numbers and its name, and through undo", () => {
  const height = familyOf("fourth-order")?.fields.find(({ key }) => key === "h1");
  store.apply(selectParts(lid));
  store.apply(setFields(store.state, height ? [height] : [], 7, false));
  store.apply(renamePart(store.state, lid, "Cover"));
  expect(store.ids).toEqual([body, lid, foot]);
  expect(store.design.parts[1]).toMatchObject({ name: "Cover", shape: { h1: 7 } });
  store.undo();
  store.undo();
  expect(store.ids).toEqual([body, lid, foot]);
  expect(store.design).toBe(SCENE);
});

test("the selection is of a part, not of a place", () => {
  store.apply(selectParts(lid));
  expect(store.part).toBe(1);
  store.apply(movePart(store.state, lid, 1));
  expect(names()).toEqual(["Body", "Part 2", "Lid"]);
  expect(store.part).toBe(2);
  store.apply(movePart(store.state, lid, 1));
  expect(store.part).toBe(2);
  store.undo();
  expect([names(), store.part]).toEqual([["Body", "Lid", "Part 3"], 1]);
  store.apply(deleteParts(store.state, [body]));
  store.undo();
  store.apply(selectParts(foot));
  store.apply(deleteParts(store.state, [body]));
  expect(store.part).toBe(0);
});

test("the first part of a scene in which none was chosen yet stays selected wherever it is moved", () => {
  store.apply(openDesign(store.state, { ...SCENE }));
  const [first] = store.ids as [number];
  const moved = () => store.ids[store.part] === first;
  for (const place of [1, 2]) {
    store.apply(movePart(store.state, store.ids[store.part] ?? -1, 1));
    expect([store.part, moved()]).toEqual([place, true]);
  }
  store.undo();
  expect([store.part, moved()]).toEqual([1, true]);
  store.apply(openDesign(store.state, { ...SCENE }));
  const [above, second] = store.ids as [number, number];
  store.apply(movePart(store.state, second, -1));
  expect(store.ids[store.part]).toBe(above);
});

test("a part that is deleted leaves the selection to its neighbour, and comes back by undo as it was", () => {
  store.apply(selectParts(lid));
  store.apply(deleteParts(store.state, [lid]));
  expect([store.ids, store.part]).toEqual([[body, foot], 1]);
  store.apply(deleteParts(store.state, [foot]));
  expect([store.ids, store.part]).toEqual([[body], 0]);
  expect(deleteParts(store.state, [body]).design).toBeUndefined();
  store.undo();
  store.undo();
  expect(store.ids).toEqual([body, lid, foot]);
  expect(store.design).toBe(SCENE);
});

test("a part that undo brings back is selected as it was, and redo selects its neighbour again", () => {
  store.apply(selectParts(body, lid));
  store.apply(deleteParts(store.state, [lid]));
  store.apply(selectParts(body));
  store.undo();
  expect(selectedIds(store.state)).toEqual([body, lid]);
  store.redo();
  expect(selectedIds(store.state)).toEqual([body]);
  store.undo();
  // Nobody comes or goes: what is selected by then stays so.
  store.apply(renamePart(store.state, foot, "Foot"));
  store.apply(selectParts(foot));
  store.undo();
  expect(selectedIds(store.state)).toEqual([foot]);
  store.apply(movePart(store.state, foot, -1));
  store.apply(selectParts(body));
  store.undo();
  expect(selectedIds(store.state)).toEqual([body]);
});

test("a selected part that undo takes away is selected again by redo", () => {
  store.apply(selectParts(lid));
  store.apply(duplicateParts(store.state, [lid], 12));
  const copy = store.ids[2];
  expect(store.part).toBe(2);
  store.undo();
  expect(store.ids).not.toContain(copy);
  expect(store.part).toBe(1);
  store.redo();
  expect([store.ids[2], store.part]).toEqual([copy, 2]);
});

test("a copy stands beside the part, looks the same and has a name and an identity of its own", () => {
  store.apply(duplicateParts(store.state, [lid], 12));
  store.apply(duplicateParts(store.state, [lid], 24));
  expect(names()).toEqual(["Body", "Lid", "Lid 3", "Lid 2", "Part 5"]);
  expect(new Set(store.ids).size).toBe(5);
  expect(store.design.parts[2]).toEqual({ ...part, name: "Lid 3", object: 2, place: { angle: 1, shift: [24, 0, 20] } });
  store.apply(duplicateParts(store.state, [foot], 5));
  expect(store.design.parts[5]).toEqual({ ...part, object: 3, place: { shift: [5, 0, 0] } });
});

test("two parts have never the same name, and the typing of one is one step", () => {
  for (const name of ["C", "Co", "Cover "]) store.apply(renamePart(store.state, lid, name));
  expect(names()[1]).toBe("Cover");
  expect(isTaken(store.state, lid, "Cover")).toBe(false);
  expect(isTaken(store.state, lid, " Body ")).toBe(true);
  store.apply(renamePart(store.state, lid, "Body"));
  expect(names()[1]).toBe("Cover");
  store.endGesture();
  store.undo();
  expect(names()[1]).toBe("Lid");
  store.apply(renamePart(store.state, lid, "  "));
  expect(store.design.parts[1]).not.toHaveProperty("name");
  store.apply(renamePart(store.state, lid, "x".repeat(100)));
  expect(names()[1]).toHaveLength(MAX_NAME);
});

test("the parts of an opened design are nobody that was there before, until undo", () => {
  store.apply(selectParts(lid));
  store.apply(openDesign(store.state, { ...SCENE }));
  expect(store.ids.some((id) => [body, lid, foot].includes(id))).toBe(false);
  expect(store.part).toBe(0);
  store.undo();
  expect(store.ids).toEqual([body, lid, foot]);
  store.apply({ design: JAR, undo: "step" });
  expect(store.ids).toHaveLength(1);
  expect([body, lid, foot]).not.toContain(store.ids[0]);
});

test("who is not there cannot be moved, copied, named or deleted", () => {
  for (const change of [
    movePart(store.state, 99, 1),
    duplicateParts(store.state, [99], 1),
    renamePart(store.state, 99, "Nobody"),
    deleteParts(store.state, [99]),
  ])
    expect(change).toEqual({ undo: "none" });
});

test("a part that is hidden stays in the design, through undo too, and its copy is seen", () => {
  const { design } = store;
  store.apply(togglePart(store.state, lid));
  expect(store.session.hidden).toEqual([lid]);
  expect(store.design).toBe(design);
  expect(store.canUndo).toBe(false);
  expect(hiddenParts(store.state)).toBe(1);
  store.apply(duplicateParts(store.state, [lid], 1));
  expect(hiddenParts(store.state)).toBe(1);
  store.undo();
  store.apply(deleteParts(store.state, [lid]));
  expect(hiddenParts(store.state)).toBe(0);
  store.undo();
  expect(hiddenParts(store.state)).toBe(1);
  store.apply(togglePart(store.state, lid));
  expect(store.session.hidden).toEqual([]);
});

test("what is added is an object of its own, where it is put, and takes no name that is there", () => {
  const coming: Part[] = [
    { ...part, name: "Lid", place: { shift: [1, 0, 0] } },
    { ...part, name: "Knob", object: 1 },
  ];
  store.apply(addParts(store.state, coming, [10, 0, 2]));
  expect(store.design.parts.slice(0, 3)).toEqual(SCENE.parts);
  expect(store.design.parts.slice(3)).toEqual([
    { ...part, object: 1, place: { shift: [11, 0, 2] } },
    { ...part, name: "Knob", object: 2, place: { shift: [10, 0, 2] } },
  ]);
  expect(new Set(store.ids).size).toBe(5);
  expect(store.part).toBe(3);
  store.undo();
  expect(store.design).toEqual(SCENE);
  expect(addParts(store.state, [], [0, 0, 0]).undo).toBe("none");
});

test("a part is glued to the object of another one, or stands by itself", () => {
  const objects = () => store.design.parts.map(({ object }) => object ?? 0);
  store.apply(gluePart(store.state, body, null));
  expect(objects()).toEqual([1, 0, 0]);
  // Alone it is already, and glued to those of its object.
  store.apply(gluePart(store.state, body, null));
  store.apply(gluePart(store.state, lid, foot));
  expect(objects()).toEqual([1, 0, 0]);
  store.apply(gluePart(store.state, foot, body));
  expect(objects()).toEqual([1, 0, 1]);
  store.apply(gluePart(store.state, body, lid));
  store.apply(gluePart(store.state, foot, null));
  expect(objects()).toEqual([0, 0, 1]);
  expect(Object.keys(store.design.parts[0] ?? {})).not.toContain("object");
  for (let step = 0; step < 4; step += 1) store.undo();
  expect(store.design).toBe(SCENE);
});

test("parts leave their object together and stay glued to each other", () => {
  const objects = () => store.design.parts.map(({ object }) => object ?? 0);
  store.apply(splitOff(store.state, [body, lid]));
  expect(objects()).toEqual([1, 1, 0]);
  // Nothing is left to leave.
  expect(splitOff(store.state, [body, lid]).undo).toBe("none");
  expect(splitOff(store.state, [foot]).undo).toBe("none");
  store.undo();
  expect(store.design).toBe(SCENE);
});

test("a copy stands by itself", () => {
  store.apply(duplicateParts(store.state, [lid], 3));
  expect(store.design.parts.map(({ object }) => object ?? 0)).toEqual([0, 0, 1, 0]);
});
