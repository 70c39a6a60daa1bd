import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { JAR, tall } from "../../testing/jar";
import { realMaker } from "../../testing/real-maker";
import { realSolver } from "../../testing/real-solver";
import { Page } from "../../testing/surroundings";
import { NEW_SESSION } from "../state/session";
import { keepWork } from "../state/storage";
import { Store } from "../state/store";
import { Keeper } from "./keeper";
import { Notices } from "./notices";
import { Opening } from "./opening";
import { Origin } from "./origin";
import { Surface } from "./surface";

const VASE = "#1/second-order?height=5";

function bench(page = new Page()) {
  const { solver, worker } = realSolver({ free: true });
  const { maker } = realMaker({ free: true });
  const store = new Store(JAR, NEW_SESSION);
  const surface = new Surface(store, solver);
  surface.grid = () => ({ rows: 13, columns: 25 });
  const origin = new Origin(store, surface);
  const keeper = new Keeper(store, surface, origin, solver, new Notices(), page);
  const opening = new Opening(store, surface, origin, keeper, solver, async () => maker);
  for (const each of [origin, surface, keeper, opening]) each.connect();
  const rests = async () => {
    while (surface.settled === null) await settled();
  };
  const kind = () => store.design.parts[0]?.shape.kind;
  return { keeper, kind, maker, opening, origin, page, rests, solver, store, surface, worker };
}

/** A page with work that was kept. */
function kept(unsaved: boolean): Page {
  const page = new Page();
  keepWork(page.shelf, "here", { text: JSON.stringify(tall(JAR, 33)), link: "1/fourth-order?h1=33", unsaved });
  return page;
}

const linked = (page: Page, hash = VASE) => Object.assign(page, { hash });

test("a first visit begins with what is there, and nothing to lose", async () => {
  const { keeper, opening, rests, store } = bench();
  await opening.start();
  await rests();
  expect(store.design).toBe(JAR);
  expect(keeper.unsaved).toBe(false);
  expect(store.canUndo).toBe(false);
});

test("a link is opened, also in the place of work that is in safety", async () => {
  for (const page of [new Page(), kept(false)]) {
    const { keeper, kind, opening, rests } = bench(linked(page));
    await opening.start();
    await rests();
    expect(kind()).toBe("second-order");
    expect(keeper.unsaved).toBe(false);
  }
});

test("work that was kept goes on", async () => {
  for (const unsaved of [true, false]) {
    const { keeper, opening, rests, surface } = bench(kept(unsaved));
    await opening.start();
    await rests();
    expect(surface.shown?.solved.facts?.height).toBeCloseTo(33);
    expect(keeper.unsaved).toBe(unsaved);
  }
});

test("a link over unsaved work asks first, and the address waits for the answer", async () => {
  for (const take of ["theirs", "mine"] as const) {
    const { kind, opening, page, rests, store } = bench(linked(kept(true)));
    await opening.start();
    await rests();
    expect(opening.conflict).not.toBeNull();
    expect(page.hash).toBe(VASE);
    opening.settleConflict(take);
    expect(opening.conflict).toBeNull();
    await rests();
    expect(kind()).toBe(take === "theirs" ? "second-order" : "fourth-order");
    expect(store.canUndo).toBe(take === "theirs");
    expect(page.hash).not.toContain(take === "theirs" ? "h1=33" : "second-order");
  }
});

test("after a reload parts are in the order in which a person put them, and what is undone is about the same ones", async () => {
  const page = new Page();
  const before = bench(page);
  await before.opening.start();
  const named = (name: string, h1: number) => ({ ...tall(JAR, h1).parts[0], name });
  const names = ({ design }: Store) => design.parts.map(({ name }) => name);
  // In a link the smaller number comes first.
  await before.opening.openText(JSON.stringify({ ...JAR, parts: [named("Low", 10), named("High", 20)] }));
  await before.rests();
  const [first = 0, second = 0] = before.store.ids;
  const [low, high] = before.store.design.parts;
  before.store.apply({
    design: { ...before.store.design, parts: [high, low].filter((part) => part !== undefined) },
    ids: [second, first],
    undo: "step",
  });
  await before.rests();
  expect(page.hash).not.toBe("");
  page.open.clear();
  const { opening, rests, store } = bench(page);
  await opening.start();
  await rests();
  expect(names(store)).toEqual(["High", "Low"]);
  const [top] = store.ids;
  store.undo();
  expect(names(store)).toEqual(["Low", "High"]);
  expect(store.ids[1]).toBe(top);
});

test("a damaged link is told of until a person goes on", async () => {
  const { opening, page, rests, store } = bench(linked(new Page(), "#1/no-such-thing"));
  await opening.start();
  await rests();
  expect(opening.problem?.message).not.toBe("");
  expect(page.hash).toBe("#1/no-such-thing");
  store.apply({ design: tall(JAR, 21), undo: "step" });
  expect(opening.problem).toBeNull();
  await rests();
  expect(page.hash).toContain("h1=21");
});

test("once it was read why a link opens nothing, the address is that of the pot that is there", async () => {
  const { opening, page, rests, surface } = bench(linked(new Page(), "#1/no-such-thing"));
  await opening.start();
  await rests();
  expect(page.hash).toBe("#1/no-such-thing");
  opening.dismissProblem();
  expect(page.hash).toBe(`#${surface.settled?.solved.link}`);
  // Of a file there is nothing in the address.
  const other = bench();
  await other.opening.start();
  await other.rests();
  await other.opening.openFile(new File(["{"], "pot.json"));
  expect(other.opening.problem).not.toBeNull();
  other.opening.dismissProblem();
  expect(other.page.hash).toBe("");
});

test("another address is followed, but not the one that was written here, nor one of what is on the stage", async () => {
  const { kind, keeper, opening, page, rests, store } = bench();
  page.hash = VASE;
  await opening.addressChanged();
  expect(kind()).toBe("fourth-order");
  page.hash = "";
  await opening.start();
  await rests();
  store.apply({ design: tall(JAR, 21), undo: "step" });
  await rests();
  await opening.addressChanged();
  expect(opening.conflict).toBeNull();
  keeper.markShared();
  page.hash = VASE;
  await opening.addressChanged();
  expect(kind()).toBe("second-order");
  await rests();
  store.apply({ design: { ...store.design, title: "Mine" }, undo: "step" });
  page.hash = "#1/mixed-order";
  await opening.addressChanged();
  expect(opening.conflict?.theirs.design.parts[0]?.shape.kind).toBe("mixed-order");
});

test("a file says how it was made, until undo leads back before it", async () => {
  const { keeper, maker, opening, rests, store, surface } = bench();
  await opening.start();
  await rests();
  const making = { product: "solid", shrinkage: 12 } as const;
  const written = await maker.ask({ kind: "write", design: tall(JAR, 30), format: "obj", making });
  if (written.state !== "done") throw new Error(JSON.stringify(written));
  await opening.openFile(new File([written.value.bytes], "jar.obj"));
  await rests();
  expect(surface.shown).toMatchObject({ framing: 1, design: store.design });
  expect(opening.making).toMatchObject(making);
  expect(keeper.unsaved).toBe(false);
  store.undo();
  expect(opening.making).toBeNull();
  store.redo();
  expect(opening.making).toMatchObject(making);
  await opening.openText(VASE);
  expect(opening.making).toBeNull();
});

test("what is no design is told of and changes nothing", async () => {
  const { opening, rests, store } = bench();
  await opening.start();
  await rests();
  await opening.openText("milk, eggs");
  expect(opening.problem?.message).toMatch(/milk/);
  opening.dismissProblem();
  await opening.openFile(new File([new Uint8Array(84)], "holiday.stl"));
  expect(opening.problem?.args).toEqual({ name: "holiday.stl" });
  expect(store.design).toBe(JAR);
});

test("work of an earlier visit goes on from where it was opened then", async () => {
  const page = new Page();
  const text = JSON.stringify(tall(JAR, 33));
  keepWork(page.shelf, "here", {
    text,
    link: "1/fourth-order?h1=33",
    unsaved: true,
    origin: JSON.stringify(tall(JAR, 25)),
  });
  const { opening, origin, rests, store } = bench(page);
  await opening.start();
  await rests();
  expect(store.design.parts[0]?.shape).toMatchObject({ h1: 33 });
  expect(origin.design.parts[0]?.shape).toMatchObject({ h1: 25 });
  expect(origin.size).toBeGreaterThan(30);
});

test("that a file is being opened is told from when it is given until it is on the stage, or why it is not", async () => {
  const { opening, rests, surface, store } = bench();
  await opening.start();
  await rests();
  const before = surface.shown;
  const giving = opening.openFile(new File([JSON.stringify(tall(JAR, 40))], "tall.json"));
  expect(opening.underway).toMatchObject({ name: "tall.json", design: null });
  expect(opening.underway?.bytes).toBeGreaterThan(100);
  await giving;
  // It was read, and the old one is on the stage still.
  expect(opening.underway?.design).toBe(store.design);
  expect(surface.shown).toBe(before);
  await rests();
  expect(opening.underway).toBeNull();
  expect(surface.shown?.design).toBe(store.design);
  for (const text of ["{", "solid nothing"]) {
    const wrong = opening.openFile(new File([text], "wrong.json"));
    expect(opening.underway?.name).toBe("wrong.json");
    await wrong;
    expect(opening.underway).toBeNull();
    expect(opening.problem).not.toBeNull();
  }
});

test("opening can be stopped while the file is read, and while it waits to be drawn: all is as it was", async () => {
  for (const late of [false, true]) {
    const { opening, rests, surface, store, worker } = bench();
    await opening.start();
    await rests();
    worker.free = false;
    const giving = opening.openFile(new File([JSON.stringify(tall(JAR, 40))], "tall.json"));
    while (worker.sent.length === worker.answered) await settled();
    if (late) {
      await worker.answer();
      await giving;
      expect(opening.underway?.design).toBe(store.design);
    }
    opening.stop();
    worker.free = true;
    expect(opening.underway).toBeNull();
    expect(Boolean(await giving)).toBe(late);
    await worker.finish();
    await rests();
    expect(store.design).toBe(JAR);
    expect(surface.shown?.design).toBe(JAR);
    expect(surface.status).toBe("ready");
    expect(opening.problem).toBeNull();
    // Another one is opened as ever, by a new worker.
    await opening.openFile(new File([JSON.stringify(tall(JAR, 50))], "taller.json"));
    await rests();
    expect(surface.shown?.solved.facts?.height).toBeCloseTo(50);
    opening.stop();
    expect(surface.shown?.solved.facts?.height).toBeCloseTo(50);
  }
});

test("what something else reads of a file is underway until it is on the stage, and is not opened where that was stopped", async () => {
  const { opening, rests, store } = bench();
  await opening.start();
  await rests();
  const file = new File(["v 0 0 0"], "roof.obj");
  const higher = tall(JAR, 44);
  const reading = opening.openRead(file, async () => higher);
  expect(opening.underway).toEqual({ name: "roof.obj", bytes: 7, design: null });
  expect(await reading).toBe(true);
  expect([store.design, opening.underway?.design]).toEqual([higher, store.design]);
  await rests();
  expect(opening.underway).toBeNull();
  // Nothing, and a file that cannot be read.
  expect(await opening.openRead(file, async () => null)).toBe(false);
  expect(await opening.openRead(file, () => Promise.reject(new Error("gone")))).toBe(false);
  const signals: AbortSignal[] = [];
  const read = async (signal: AbortSignal) => {
    signals.push(signal);
    return tall(JAR, 45);
  };
  const stopped = opening.openRead(file, read);
  opening.stop();
  expect(await stopped).toBe(false);
  // Another file takes its place as well.
  const late = opening.openRead(file, read);
  const taken = opening.openRead(file, async () => null);
  expect([await late, await taken]).toEqual([false, false]);
  expect(signals.map(({ aborted }) => aborted)).toEqual([true, true]);
  expect([store.design, opening.underway]).toEqual([higher, null]);
});
