import { expect, test } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { Page } from "../../testing/surroundings";
import { workbench } from "../../testing/workbench";
import { keepPiece, keepWork, readPieces } from "../state/storage";
import { type Change, Collection } from "./collection";
import { Keeper } from "./keeper";
import { Notices } from "./notices";
import { Origin } from "./origin";

async function bench(page = new Page()) {
  const { store, surface, solver } = await workbench(JAR);
  const keeper = new Keeper(store, surface, new Origin(store, surface), solver, new Notices(), page);
  await keeper.arrive();
  const collection = new Collection(solver, keeper);
  await collection.read();
  const heights = () =>
    collection.entries?.map(({ design }) => (design?.parts[0]?.shape as { h1?: number } | undefined)?.h1);
  const only = () => {
    const [entry] = collection.entries ?? [];
    if (!entry) throw new Error("the shelf is empty");
    return entry;
  };
  return { collection, heights, only, page };
}

async function undone(change: Change): Promise<boolean> {
  if (change.state !== "done") throw new Error(change.state);
  return await change.undo();
}

test("a design is saved, replaced, renamed and removed, and each can be taken back", async () => {
  const { collection, heights, only } = await bench();
  expect(collection.entries).toEqual([]);
  await collection.save(tall(JAR, 21));
  expect(heights()).toEqual([21]);
  expect(only().link).toContain("h1=21");
  const replaced = await collection.replace(only(), tall(JAR, 22));
  expect(heights()).toEqual([22]);
  expect(await undone(replaced)).toBe(true);
  expect(heights()).toEqual([21]);
  const renamed = await collection.rename(only(), "Mine");
  expect(only().design?.title).toBe("Mine");
  await undone(renamed);
  expect(only().design?.title).toBe(JAR.title);
  await collection.rename(only(), "");
  expect(only().design?.title).toBeUndefined();
  const removed = await collection.remove(only());
  expect(collection.entries).toEqual([]);
  await undone(removed);
  expect(heights()).toEqual([21]);
  const saved = await collection.save(tall(JAR, 30));
  expect(new Set(heights())).toEqual(new Set([21, 30]));
  await undone(saved);
  expect(heights()).toEqual([21]);
});

test("what another tab changed meanwhile is not written over", async () => {
  const { collection, heights, only, page } = await bench();
  await collection.save(tall(JAR, 21));
  const { id } = only().piece;
  keepPiece(page.shelf, { id, text: JSON.stringify(tall(JAR, 25)), at: Date.now() });
  const replaced = await collection.replace(only(), tall(JAR, 22));
  expect(new Set(heights())).toEqual(new Set([25, 22]));
  await undone(replaced);
  expect(heights()).toEqual([25]);
});

test("what is no design is shown as such, beside those that are", async () => {
  const page = new Page();
  page.kept.set(
    "pasu.piece.a",
    JSON.stringify({ text: '{ "pasu": 1, "parts": [{ "shape": { "kind": "teapot" } }] }', at: 3 }),
  );
  page.kept.set("pasu.piece.b", "{");
  page.kept.set("pasu.piece.c", JSON.stringify({ text: 7 }));
  page.kept.set("pasu.piece.d", JSON.stringify({ text: JSON.stringify(JAR), at: "never" }));
  page.kept.set("pasu.piece.e", JSON.stringify({ text: "<script>", at: 1e300 }));
  const { collection } = await bench(page);
  expect(collection.entries?.map(({ piece, design }) => [piece.id, piece.at, design?.title ?? null])).toEqual([
    ["a", 3, null],
    ["d", 0, JAR.title],
    ["e", 0, null],
  ]);
  expect(collection.entries?.[0]?.refusal?.message).toMatch(/teapot/);
  for (const { piece } of collection.entries ?? []) expect(() => new Date(piece.at).toISOString()).not.toThrow();
});

test("a full or blocked browser says so and loses nothing", async () => {
  const { collection, heights, only, page } = await bench();
  await collection.save(tall(JAR, 21));
  const removed = await collection.remove(only());
  page.full = true;
  expect(await undone(removed)).toBe(false);
  page.full = false;
  expect(await undone(removed)).toBe(true);
  page.full = true;
  expect((await collection.save(tall(JAR, 22))).state).toBe("full");
  expect((await collection.replace(only(), tall(JAR, 22))).state).toBe("full");
  expect((await collection.save(tall(JAR, Number.NaN))).state).toBe("refused");
  expect(heights()).toEqual([21]);
});

test("work that closed tabs left nowhere else comes onto the shelf, once", async () => {
  const page = new Page();
  const work = (height: number, unsaved: boolean) => ({ text: JSON.stringify(tall(JAR, height)), link: "", unsaved });
  keepWork(page.shelf, "closed", work(21, true), 1);
  keepWork(page.shelf, "open", work(22, true), 2);
  keepWork(page.shelf, "seen", work(23, false), 3);
  keepWork(page.shelf, "here", work(24, true), 4);
  page.open.add("open");
  const { collection, heights } = await bench(page);
  expect(await collection.gather()).toBe(1);
  await collection.read();
  expect(heights()).toEqual([21]);
  expect(await collection.gather()).toBe(0);
  expect(readPieces(page.shelf)).toHaveLength(1);
  expect(page.kept.has("pasu.work.closed")).toBe(false);
  expect(page.kept.has("pasu.work.open")).toBe(true);
});
