import { expect, test } from "vitest";
import { workbench } from "../../testing/workbench";
import { SCENES } from "../document/gallery/scenes";
import type { Breach, Constraints, Design, Part, Triple } from "../document/types";
import { lockParts } from "../state/several-actions";
import type { Designer } from "./designer";
import { boxesOf } from "./held";
import { Made } from "./made";
import { moveApart, moveTogether, waysApart } from "./mending";

const block = (shift: Triple, object: number, scale: Triple = [1, 1, 1]): Part => ({
  object,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale, shift },
});

const table = block([0, 0, 0], 0, [4, 4, 1]);
const CUP: Design = { pasu: 1, parts: [table, block([1, 1, 0.8], 1)] };

/** As much of a designer as this needs, at rest. */
async function bench(design: Design) {
  const there = await workbench(design);
  const made = new Made(there.store, there.surface, there.maker, () => () => {});
  made.connect();
  await there.making.finish();
  const { store, surface } = there;
  const apply = (change: Parameters<typeof store.apply>[0]) => {
    store.apply(change);
    store.endGesture();
  };
  const designer = {
    apply,
    made,
    openMade: async () => made,
    surface,
    get state() {
      return store.state;
    },
  } as unknown as Designer;
  /** Does something while the maker answers. */
  const during = async <T>(doing: Promise<T>): Promise<T> => {
    await there.making.finish();
    return doing;
  };
  /** What is wrong with what the document says now. */
  const rest = async (): Promise<Constraints> => {
    await there.rests();
    await there.making.finish();
    if (!made.constraints.value || !made.isOfNow(made.constraints)) throw new Error("nothing is known of the scene");
    return made.constraints.value;
  };
  return { ...there, designer, during, rest, made };
}

const first = ({ breaches: [breach] }: Constraints): Breach => {
  if (!breach) throw new Error("nothing is wrong");
  return breach;
};

test("the smaller object goes up or aside, the shortest way first, and never down", async () => {
  const { designer, rest } = await bench(CUP);
  const ways = waysApart(designer.state, boxesOf(designer), first(await rest()));
  expect(ways.slice(0, 5).every(({ moving }) => moving.join() === "1")).toBe(true);
  expect(ways.slice(5).every(({ moving }) => moving.join() === "0")).toBe(true);
  expect(ways[0]).toMatchObject({ towards: [0, 0, 1], others: [0] });
  expect(ways[0]?.far).toBeGreaterThan(0.2);
  expect(ways[0]?.far).toBeLessThan(0.21);
  expect(ways.some(({ towards }) => towards[2] < 0)).toBe(false);
});

test("two objects that run into each other are put apart in one step, and then fit", async () => {
  const { designer, during, rest, store } = await bench(CUP);
  const breach = first(await rest());
  expect(breach.code).toBe("interference");
  const mended = await during(moveApart(designer, breach));
  expect(mended).toMatchObject({ state: "moved", ids: [store.ids[1]] });
  expect(store.design.parts[0]).toEqual(CUP.parts[0]);
  expect((await rest()).breaches).toEqual([]);
  store.undo();
  expect(store.design).toEqual(CUP);
});

test("a lid of which it cannot be told whether it touches is lifted, though the surfaces of both are apart", async () => {
  const [jar, lid] = SCENES.find(({ id }) => id === "own-lidded-jar")?.parts ?? [];
  if (!jar || !lid) throw new Error("no jar with a lid");
  // What turns about one axis is decided.
  expect((await (await bench({ pasu: 1, parts: [jar, lid] })).rest()).isKept).toBe(true);
  // Beside the axis what has room is decided too, but not what is all but on the rim.
  const aside: Part = { ...lid, place: { ...lid.place, shift: [0.05, 0, (lid.place?.shift?.[2] ?? 0) - 0.02] } };
  const { designer, during, rest, store } = await bench({ pasu: 1, parts: [jar, aside] });
  const breach = first(await rest());
  expect(breach.code).toBe("undecided-interference");
  const before = store.design.parts[1]?.place?.shift ?? [];
  const ways = waysApart(designer.state, boxesOf(designer), breach);
  expect(ways.every(({ far, others, moving }) => far > 0 && others.includes(1 - (moving[0] ?? 0)))).toBe(true);
  expect(await during(moveApart(designer, breach))).toMatchObject({ state: "moved", ids: [store.ids[1]] });
  const [x, y, z] = store.design.parts[1]?.place?.shift ?? [];
  expect([x, y]).toEqual(before.slice(0, 2));
  expect(z).toBeGreaterThan(before[2] ?? 0);
  expect(z).toBeLessThan((before[2] ?? 0) + 0.35);
  expect((await rest()).isKept).toBe(true);
});

test("what is locked stays, and where all of it is nothing moves", async () => {
  const { designer, during, rest, store } = await bench(CUP);
  const breach = first(await rest());
  store.apply(lockParts(store.state, store.ids.slice(1), true));
  expect(waysApart(designer.state, boxesOf(designer), breach).every(({ moving }) => moving.join() === "0")).toBe(true);
  store.apply(lockParts(store.state, store.ids, true));
  expect(await during(moveApart(designer, breach))).toEqual({ state: "locked" });
  expect(await during(moveTogether(designer, breach))).toEqual({ state: "locked" });
  expect(store.design).toEqual(CUP);
});

test("what is glued and loose is brought to the other, and what was changed meanwhile stays as it was changed", async () => {
  const loose: Design = { pasu: 1, parts: [table, block([6, 1, 0.2], 0)] };
  const { designer, during, making, rest, store } = await bench(loose);
  const breach = first(await rest());
  expect(breach.code).toBe("not-connected");
  expect(await during(moveTogether(designer, breach))).toMatchObject({ state: "moved" });
  expect((await rest()).isKept).toBe(true);
  store.undo();
  const again = moveTogether(designer, first(await rest()));
  const other: Design = { ...loose, title: "Another" };
  store.apply({ design: other, undo: "step" });
  await making.finish();
  expect(await again).toEqual({ state: "superseded" });
  expect(store.design).toEqual(other);
});

test("of several that are loose together all are brought, and none where one is locked", async () => {
  const loose: Design = {
    pasu: 1,
    parts: [table, block([3.5, 0, 0.5], 0), block([9, 1, 0.2], 0), block([9.5, 1.2, 0.4], 0), block([3, 3, 0.5], 0)],
  };
  const { designer, during, rest, store } = await bench(loose);
  const breach = first(await rest());
  expect(breach).toMatchObject({ code: "not-connected", part: 2, group: [2, 3] });
  store.apply(lockParts(store.state, store.ids.slice(3, 4), true));
  expect(await during(moveTogether(designer, breach))).toEqual({ state: "locked" });
  store.apply(lockParts(store.state, store.ids.slice(3, 4), false));
  expect(await during(moveTogether(designer, breach))).toMatchObject({ state: "moved", ids: store.ids.slice(2, 4) });
  const by = (place: number) =>
    (store.design.parts[place]?.place?.shift ?? []).map((x, i) => x - (loose.parts[place]?.place?.shift?.[i] ?? 0));
  for (const [i, x] of by(2).entries()) expect(by(3)[i]).toBeCloseTo(x, 9);
  expect((await rest()).isKept).toBe(true);
});

test("the scene is judged at rest, and of an earlier one nothing is said", async () => {
  const { made, making, rest, store } = await bench(CUP);
  expect((await rest()).isKept).toBe(false);
  store.apply({ design: { ...CUP, parts: [table, block([1, 1, 3], 1)] }, undo: "merge", key: "lift" });
  expect(made.isOfNow(made.constraints)).toBe(false);
  await making.finish();
  expect(made.isOfNow(made.constraints)).toBe(false);
  store.endGesture();
  expect((await rest()).isKept).toBe(true);
  store.apply({ design: { pasu: 1, parts: [table] }, undo: "step" });
  await making.finish();
  expect(made.constraints.value).toBeNull();
});
