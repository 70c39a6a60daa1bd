import { expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import { settled } from "../../testing/held-worker";
import { realMaker } from "../../testing/real-maker";
import type { Rings } from "../document/types";
import { NEW_SESSION } from "../state/session";
import { editShape } from "../state/shape-actions";
import { Store } from "../state/store";
import { Pull } from "./pull";

const STILL = { out: 0, up: 0, round: 0 };

function bench() {
  const store = new Store({ pasu: 1, parts: [{ shape: BOTTLE }] }, NEW_SESSION);
  const { maker, worker } = realMaker();
  const pull = new Pull(store, maker);
  pull.brush = { ...pull.brush, spread: "all" };
  const radius = () => (store.design.parts[0]?.shape as Rings | undefined)?.rings[1]?.r.mean;
  const take = () => pull.take({ part: store.ids[0] ?? 0, at: [0.35, 0], size: 6 });
  return { store, worker, pull, radius, take };
}

test("one drag is one step, and of many movements the latest wins", async () => {
  const { store, worker, pull, radius, take } = bench();
  take();
  for (const out of [0.1, 0.2, 0.3, 0.5]) pull.move({ ...STILL, out });
  await worker.finish();
  expect(worker.sent.length).toBeLessThan(4);
  expect(radius()).toBeCloseTo(6.5, 5);
  expect(store.inGesture).toBe(true);
  pull.move({ ...STILL, out: 1 });
  await worker.finish();
  await pull.release();
  expect(radius()).toBeCloseTo(7, 5);
  expect(store.inGesture).toBe(false);
  store.undo();
  expect(store.design.parts[0]?.shape).toEqual(BOTTLE);
  expect(store.canUndo).toBe(false);
});

test("what was asked when the hand let go still arrives, and the next grip goes on from there", async () => {
  const { store, worker, pull, radius, take } = bench();
  take();
  pull.move({ ...STILL, out: 1 });
  void pull.release();
  take();
  pull.move({ ...STILL, out: 1 });
  void pull.release();
  await worker.finish();
  await settled();
  await worker.finish();
  expect(radius()).toBeCloseTo(8, 5);
  expect(store.inGesture).toBe(false);
  store.undo();
  expect(radius()).toBeCloseTo(7, 5);
});

test("a pull that was not meant leaves nothing, whatever still comes", async () => {
  const { store, worker, pull, take } = bench();
  take();
  pull.move({ ...STILL, up: 1 });
  await worker.finish();
  expect(store.design.parts[0]?.shape).not.toEqual(BOTTLE);
  pull.move({ ...STILL, up: 2 });
  pull.cancel();
  await worker.finish();
  expect(store.design.parts[0]?.shape).toEqual(BOTTLE);
  expect(store.canUndo).toBe(false);
});

test("what somebody else changes under the hand counts", async () => {
  const { store, worker, pull, radius, take } = bench();
  take();
  pull.move({ ...STILL, out: 1 });
  await worker.finish();
  store.apply(editShape(store.state, () => ({ ...BOTTLE, a: 2 })));
  pull.move({ ...STILL, out: 2 });
  await worker.finish();
  await pull.release();
  expect(radius()).toBe(6);
});

test("what is refused is told, and the pot stays", async () => {
  const { worker, pull, radius, take } = bench();
  take();
  pull.move({ ...STILL, out: Number.MAX_VALUE });
  await worker.finish();
  expect(pull.followed.refusal).not.toBeNull();
  expect(radius()).toBe(6);
});
