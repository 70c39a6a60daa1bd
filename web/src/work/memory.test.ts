import { expect, test } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";
import { shelfOf } from "../../testing/surroundings";
import type { Design } from "../document/types";
import { NEW_SESSION } from "../state/session";
import { readSteps } from "../state/storage";
import { Store } from "../state/store";
import { Memory } from "./memory";

const LINK = "the design's";
const heightOf = ({ parts }: Design) => (parts[0]?.shape as { h1?: number } | undefined)?.h1;

function bench(own = new Map<string, string>()) {
  const { solver } = realSolver({ free: true });
  const memory = new Memory(shelfOf(own), solver);
  const step = (store: Store, ...heights: number[]) => {
    for (const height of heights) store.apply({ design: tall(store.design, height), undo: "step" });
  };
  const undone = (store: Store) => {
    const heights: unknown[] = [];
    while (store.canUndo) {
      store.undo();
      heights.push(heightOf(store.design));
    }
    return heights;
  };
  return { memory, own, step, undone };
}

test("after a reload what could be undone and redone still can be", async () => {
  const { memory, step, undone } = bench();
  const before = new Store(tall(JAR, 20), NEW_SESSION);
  step(before, 21, 22, 23);
  before.undo();
  memory.keep(LINK, before);
  const between = new Store(tall(JAR, 22), NEW_SESSION);
  const recalled = memory.recall(LINK, between);
  memory.keep(LINK, between);
  await recalled;
  // And after another one at once.
  const after = new Store(tall(JAR, 22), NEW_SESSION);
  await memory.recall(LINK, after);
  expect([after.canUndo, after.canRedo]).toEqual([true, true]);
  after.redo();
  expect(heightOf(after.design)).toBe(23);
  expect(undone(after)).toEqual([22, 21, 20]);
});

test("another design than the one that was left has no steps", async () => {
  const { memory, step } = bench();
  const before = new Store(JAR, NEW_SESSION);
  step(before, 21);
  memory.keep(LINK, before);
  const after = new Store(JAR, NEW_SESSION);
  await memory.recall("another", after);
  expect(after.canUndo).toBe(false);
});

test("what was done before the steps came back comes after them, and nothing is to be redone then", async () => {
  const { memory, step, undone } = bench();
  const before = new Store(tall(JAR, 20), NEW_SESSION);
  step(before, 21, 22);
  before.undo();
  memory.keep(LINK, before);
  const after = new Store(tall(JAR, 21), NEW_SESSION);
  const recalled = memory.recall(LINK, after);
  step(after, 30);
  await recalled;
  expect(after.canRedo).toBe(false);
  expect(undone(after)).toEqual([21, 20]);
});

test("the same part is the same across a reload, and one that is gone is nobody of today", async () => {
  const { memory } = bench();
  const part = JAR.parts[0];
  if (!part) throw new Error("the jar has a part");
  const before = new Store({ ...JAR, parts: [part, part] }, NEW_SESSION);
  const [first, second] = before.ids;
  before.apply({ design: JAR, ids: [second ?? 0], undo: "step" });
  memory.keep(LINK, before);
  const after = new Store(JAR, NEW_SESSION);
  const [kept] = after.ids;
  await memory.recall(LINK, after);
  after.undo();
  expect(after.ids).toHaveLength(2);
  expect(after.ids[1]).toBe(kept);
  expect(after.ids[0]).not.toBe(kept);
  expect(first).not.toBe(second);
});

test("nonsense is left out, step by step or as a whole", async () => {
  const good = { text: JSON.stringify(tall(JAR, 21)), ids: [0] };
  const cases: readonly [unknown, number][] = [
    [{ link: LINK, ids: [0], past: [good, { text: "{", ids: [0] }, { ...good, ids: [0, 1] }], future: [] }, 1],
    [{ link: LINK, ids: [0], past: [good, { text: 7, ids: [0] }], future: [] }, 0],
    [{ link: LINK, ids: [0, 0], past: [good], future: [] }, 0],
    [{ link: LINK, ids: ["0"], past: [good], future: [] }, 0],
    [{ link: LINK, past: [good], future: [] }, 0],
    ["{", 0],
    [null, 0],
  ];
  for (const [kept, count] of cases) {
    const { memory, own, undone } = bench();
    own.set("pasu.steps", JSON.stringify(kept));
    const store = new Store(JAR, NEW_SESSION);
    await memory.recall(LINK, store);
    expect(undone(store), JSON.stringify(kept)).toHaveLength(count);
  }
});

test("of very many steps, and of very large ones, the nearest are kept", () => {
  const { memory, own, step } = bench();
  const store = new Store(JAR, NEW_SESSION);
  step(store, ...Array.from({ length: 120 }, (_, index) => 20 + index / 10));
  memory.keep(LINK, store);
  const steps = readSteps(shelfOf(own));
  expect(steps?.past).toHaveLength(50);
  expect(steps?.past.at(-1)?.text).toBe(JSON.stringify(store.history.past.at(-1)?.design));
  const part = JAR.parts[0];
  if (!part) throw new Error("the jar has a part");
  const large = new Store({ ...JAR, parts: Array.from({ length: 400 }, () => part) }, NEW_SESSION);
  step(large, ...Array.from({ length: 30 }, (_, index) => 20 + index / 10));
  memory.keep(LINK, large);
  expect(own.get("pasu.steps")?.length).toBeLessThan(400_000);
  expect(readSteps(shelfOf(own))?.past.length).toBeGreaterThan(1);
});

test("a tab that keeps nothing undoes nothing after a reload", async () => {
  const { solver } = realSolver({ free: true });
  const store = new Store(JAR, NEW_SESSION);
  for (const shelf of [null, shelfOf(new Map(), () => true)]) {
    const memory = new Memory(shelf, solver);
    memory.keep(LINK, store);
    await memory.recall(LINK, store);
  }
  expect(store.canUndo).toBe(false);
});
