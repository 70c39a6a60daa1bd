import { expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import { settled } from "../../testing/held-worker";
import { realMaker } from "../../testing/real-maker";
import type { Design, Rings } from "../document/types";
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

/** A bottle with a wall, a hand on its belly, and what it holds. */
function vessel() {
  const wall = { thickness: 0.4, base: 0.5, rim: "rounded" } as const;
  const design: Design = { pasu: 1, parts: [{ shape: BOTTLE, wall }] };
  const store = new Store(design, NEW_SESSION);
  const { maker } = realMaker({ free: true });
  const pull = new Pull(store, maker);
  pull.brush = { ...pull.brush, spread: "all" };
  const holds = async () => {
    const outcome = await maker.ask({ kind: "measure", design: store.design, product: "pot", fill: null }, "judge");
    if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
    return outcome.value.capacity?.brim.value ?? Number.NaN;
  };
  const rings = () => {
    const shape = store.design.parts[0]?.shape;
    return shape?.kind === "rings" ? shape.rings : [];
  };
  const drag = async (u: number, by: Partial<typeof STILL>) => {
    pull.take({ part: store.ids[0] ?? 0, at: [u, 0], size: 6 });
    pull.move({ ...STILL, ...by });
    await pull.release();
  };
  return { store, pull, holds, rings, drag };
}

test("what a pot holds stays to a millionth while its belly, its neck and its rim are pulled, each in one step", async () => {
  const { store, pull, holds, rings, drag } = vessel();
  const before = await holds();
  for (const [locked, u, by] of [
    [["capacity"], 0.35, { out: 0.7 }],
    [["rim", "foot", "height", "capacity"], 0.7, { out: 0.4, up: -1 }],
    // A ring is put there first.
    [["foot", "capacity"], 0.5, { out: -0.6 }],
    [["height", "capacity"], 1, { out: 0.5, up: 4 }],
  ] as const) {
    pull.locked = locked;
    const { design } = store;
    const was = rings();
    await drag(u, by);
    expect(pull.followed).toMatchObject({ refusal: null, spilt: false });
    expect(Math.abs((await holds()) / before - 1)).toBeLessThanOrEqual(1e-6);
    for (const [lock, end] of [
      ["foot", 0],
      ["rim", -1],
    ] as const) {
      const [one, other] = [was.at(end), rings().at(end)];
      if ((locked as readonly string[]).includes(lock)) expect(other).toEqual(one);
      if ((locked as readonly string[]).includes("height")) expect(other?.z).toEqual(one?.z);
    }
    const after = store.design;
    store.undo();
    expect(store.design).toBe(design);
    store.redo();
    expect(store.design).toBe(after);
  }
}, 180_000);

test("without the lock it holds more, and where no other ring is free that is said", async () => {
  const { store, pull, holds, rings, drag } = vessel();
  const before = await holds();
  await drag(0.35, { out: 0.7 });
  expect((await holds()) / before).toBeGreaterThan(1.05);
  expect(rings()[1]?.r.mean).toBeCloseTo(6.7, 5);
  store.undo();
  const [foot, belly, , rim] = BOTTLE.rings;
  if (!foot || !belly || !rim) throw new Error("it is a bottle");
  store.apply({
    design: {
      ...store.design,
      parts: store.design.parts.map((part) => ({ ...part, shape: { ...BOTTLE, rings: [foot, belly, rim] } })),
    },
    undo: "step",
  });
  pull.locked = ["rim", "foot", "capacity"];
  await drag(0.35, { out: 0.7 });
  expect(pull.followed.spilt).toBe(true);
  expect(rings()[1]?.r.mean).toBeCloseTo(6.7, 5);
  // A locked end does not move.
  await drag(0, { out: 1, up: 1, round: 0.3 });
  expect(rings()[0]).toEqual(foot);
}, 180_000);
