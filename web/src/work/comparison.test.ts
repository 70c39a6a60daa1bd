import { expect, test } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { workbench } from "../../testing/workbench";
import { compareWith } from "../state/actions";
import { Comparison } from "./comparison";

async function bench() {
  const there = await workbench(JAR);
  const comparison = new Comparison(there.store, there.surface, there.solver);
  const shown = async (height: number) => {
    await expect.poll(() => comparison.shown?.design.parts[0]?.shape).toMatchObject({ kind: "mixed-order", height });
  };
  return { ...there, comparison, leave: comparison.connect(), shown };
}

test("another order is shown while it is compared with, and follows the design", async () => {
  const { comparison, shown, store } = await bench();
  expect(comparison.shown).toBeNull();
  store.apply(compareWith("mixed-order"));
  await expect.poll(() => comparison.shown?.order).toBe("mixed-order");
  expect(comparison.shown?.solved.parts[0]?.mesh.positions.length).toBe(3 * 13 * 25);
  store.apply({ design: tall(JAR, 22), undo: "step" });
  await shown(22);
  store.apply(compareWith(null));
  expect(comparison.shown).toBeNull();
});

test("what comes too late is not shown", async () => {
  const { comparison, solved, store } = await bench();
  store.apply(compareWith("mixed-order"));
  store.apply(compareWith(null));
  await solved();
  expect(comparison.shown).toBeNull();
  expect(comparison.problem).toBeNull();
});

test("it can be left and followed again", async () => {
  const { comparison, leave, shown, solving, solved, store } = await bench();
  leave();
  const before = solving.sent.length;
  store.apply(compareWith("mixed-order"));
  await solved();
  expect(solving.sent.slice(before).filter(({ ask }) => ask.kind === "parts" && ask.whole === null)).toEqual([]);
  comparison.connect();
  await shown(20);
});
