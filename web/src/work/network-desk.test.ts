import { expect, test } from "vitest";
import { NETWORKED } from "../document/gallery/networks";
import { moved, shiftBy } from "../document/network/moving";
import type { Network } from "../document/network/network";
import { everything, NOTHING, withPatch, withVertex, withVertices } from "../document/network/selection";
import { extruded } from "../document/network/topology";
import { openDesign } from "../state/actions";
import { changeNetwork } from "../state/network-actions";
import { duplicateParts } from "../state/scene-actions";
import { NEW_SESSION } from "../state/session";
import { Store } from "../state/store";
import { NetworkDesk } from "./network-desk";

function leaf(): Store {
  const shape = NETWORKED.find(({ id }) => id === "own-leaf")?.shape;
  if (!shape) throw new Error("there is no leaf");
  return new Store({ pasu: 1, parts: [{ shape }] }, NEW_SESSION);
}

const networkOf = (store: Store): Network => {
  const shape = store.design.parts[0]?.shape;
  if (shape?.kind !== "vertex-frame") throw new Error("it is no network");
  return shape;
};

const deskOf = (store: Store) => new NetworkDesk(() => store.ids[store.part]);

test("what is picked stays picked while it is moved, and is what it was when undo brings a network back", () => {
  const store = leaf();
  const desk = deskOf(store);
  expect(desk.picksOf(networkOf(store))).toEqual(NOTHING);
  desk.pick(networkOf(store), withVertex(NOTHING, 3, false));
  store.apply(changeNetwork(store.state, (network) => moved(network, new Set([3]), shiftBy([1, 0, 0])), "drag 1"));
  store.apply(changeNetwork(store.state, (network) => moved(network, new Set([3]), shiftBy([1, 0, 0])), "drag 1"));
  store.endGesture();
  expect(networkOf(store).vertices[3]?.[0]).toBe(9);
  expect([...desk.picksOf(networkOf(store)).vertices]).toEqual([3]);
  const built = extruded(networkOf(store), new Set([3]));
  if ("refused" in built) throw new Error(built.refused);
  store.apply(changeNetwork(store.state, () => built.network));
  desk.pick(networkOf(store), { vertices: built.picked, patches: new Set() });
  expect(desk.picksOf(networkOf(store)).vertices.size).toBe(3);
  store.undo();
  expect([...desk.picksOf(networkOf(store)).vertices]).toEqual([3]);
  // Both movements were one.
  store.undo();
  expect(networkOf(store).vertices[3]?.[0]).toBe(7);
  expect([...desk.picksOf(networkOf(store)).vertices]).toEqual([3]);
});

test("nothing is picked of a copy, nor of another document of the same frames, and undo finds what was picked of the first", () => {
  const store = leaf();
  const desk = deskOf(store);
  desk.pick(networkOf(store), withVertex(NOTHING, 3, false));
  store.apply(duplicateParts(store.state, [0], 20));
  expect(store.part).toBe(1);
  const copy = store.design.parts[1]?.shape as Network;
  expect(desk.picksOf(copy)).toEqual(NOTHING);
  desk.pick(copy, withVertex(NOTHING, 5, false));
  store.undo();
  expect([...desk.picksOf(networkOf(store)).vertices]).toEqual([3]);
  const { design } = store;
  for (const other of [design, structuredClone(design)]) {
    store.apply(openDesign(store.state, { ...other }));
    expect(desk.picksOf(networkOf(store))).toEqual(NOTHING);
    store.undo();
    expect([...desk.picksOf(networkOf(store)).vertices]).toEqual([3]);
  }
});

test("points and patches are picked alone or beside the others", () => {
  const network = networkOf(leaf());
  const one = withVertex(NOTHING, 2, false);
  expect([...withVertex(one, 5, true).vertices]).toEqual([2, 5]);
  expect([...withVertex(withVertex(one, 5, true), 2, true).vertices]).toEqual([5]);
  expect(withPatch(network, one, 0, false)).toEqual(everything(network));
  expect(withPatch(network, everything(network), 0, true)).toEqual(NOTHING);
  expect([...withVertices(one, [6, 7], true).vertices]).toEqual([2, 6, 7]);
});
