import { expect, test, vi } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { rowOf } from "../../testing/row";
import { Page } from "../../testing/surroundings";
import { workbench } from "../../testing/workbench";
import { setPath } from "../document/path";
import type { Design } from "../document/types";
import { selectTab } from "../state/actions";
import { readSettings, readWork } from "../state/storage";
import { Keeper } from "./keeper";
import { Notices } from "./notices";
import { Origin } from "./origin";

const TAB = "here";

vi.mock("pasu/drawing", async (original) => {
  const pasu = await original<typeof import("pasu/drawing")>();
  return {
    ...pasu,
    link: (source: Parameters<typeof pasu.link>[0]) => {
      if (!JSON.stringify(source).includes("vertex-frame")) return pasu.link(source);
      throw Object.assign(new pasu.PasuError("too-large", "", ""), { args: { what: "link" } });
    },
  };
});

async function bench(page = new Page()) {
  const there = await workbench(JAR);
  const notices = new Notices();
  const origin = new Origin(there.store, there.surface);
  origin.connect();
  const keeper = new Keeper(there.store, there.surface, origin, there.solver, notices, page);
  await keeper.arrive();
  const leave = keeper.connect();
  const change = async (height: number) => {
    there.store.apply({ design: tall(there.store.design, height), undo: "step" });
    await there.rests();
  };
  return { ...there, change, keeper, leave, notices, page };
}

test("every settled change is kept in this browser and in the address", async () => {
  const { change, keeper, page, store, surface } = await bench();
  expect(page.written).toBe(0);
  await change(21);
  const link = surface.settled?.solved.link ?? "";
  expect(page.hash).toBe(`#${link}`);
  expect(readWork(page.shelf, TAB)).toEqual({
    text: JSON.stringify(store.design),
    link,
    unsaved: true,
    origin: JSON.stringify(JAR),
  });
  expect(keeper.unsaved).toBe(true);
  expect(keeper.foreignFragment).toBe("");
  page.hash = "#1/second-order";
  expect(keeper.foreignFragment).toBe("#1/second-order");
});

test("under the hand nothing is written", async () => {
  const { page, solved, store, rests } = await bench();
  store.apply({ design: tall(JAR, 21), undo: "merge", key: "height" });
  await solved();
  expect(page.written).toBe(0);
  store.endGesture();
  await rests();
  expect(page.written).toBe(1);
});

test("the address is left alone while a person has to read or to decide about it", async () => {
  const { change, keeper, page } = await bench();
  let held = true;
  keeper.holdWhile(() => held);
  page.hash = "#1/second-order";
  expect(keeper.foreignFragment).toBe("#1/second-order");
  await change(21);
  expect(page.hash).toBe("#1/second-order");
  expect(readWork(page.shelf, TAB)?.unsaved).toBe(true);
  held = false;
  await change(22);
  expect(page.hash).toContain("h1=22");
});

test("a link that was put into the address a moment ago is not written over before the page has heard of it", async () => {
  const { change, keeper, page } = await bench();
  await change(21);
  page.hash = "#1/second-order";
  await change(22);
  expect(page.hash).toBe("#1/second-order");
  expect(keeper.foreignFragment).toBe("#1/second-order");
  // It was opened, or not wanted: from now on the address follows again.
  await change(23);
  expect(page.hash).toContain("h1=23");
});

test("an address that the browser refuses to write is taken for nobody's link", async () => {
  const { change, keeper, page } = await bench();
  await change(21);
  page.refuses = true;
  await change(22);
  expect(page.hash).toContain("h1=21");
  expect(keeper.foreignFragment).toBe("");
  page.refuses = false;
  await change(23);
  expect(page.hash).toContain("h1=23");
});

test("a saved file holds the canonical document, and nothing is unsaved any more", async () => {
  const { change, keeper, notices, page, store } = await bench();
  await change(21);
  await keeper.save();
  expect(page.files.map(({ name }) => name)).toEqual(["Shoulder jar.json"]);
  expect(JSON.parse((await page.files[0]?.text) ?? "")).toEqual({
    ...store.design,
    // What is left unsaid is the same in every document that says it.
    parts: store.design.parts.map((part) => ({ ...part, look: { glaze: "shino" } })),
  });
  expect(notices.notice?.text).toBe("Saved as “Shoulder jar.json”.");
  expect(keeper.unsaved).toBe(false);
  expect(readWork(page.shelf, TAB)?.unsaved).toBe(false);
});

test("what the solver refuses is not saved and has no address", async () => {
  const { keeper, notices, page, store } = await bench();
  store.apply({ design: setPath(JAR, ["parts", 0, "shape", "h1"], Number.POSITIVE_INFINITY), undo: "step" });
  await keeper.save();
  expect(page.files).toEqual([]);
  expect(notices.notice?.text).toMatch(/^Not saved/);
  expect(await keeper.address()).toBeNull();
});

test("the address of a design is that of its link, whether it stands on the stage or not yet", async () => {
  const { change, keeper, store, surface } = await bench();
  await change(21);
  expect(await keeper.address()).toBe(`https://pasu.example/designer/#${surface.settled?.solved.link}`);
  store.apply({ design: tall(JAR, 23), undo: "step" });
  expect(surface.settled).toBeNull();
  expect(await keeper.address()).toContain("h1=23");
  keeper.markShared();
  expect(keeper.unsaved).toBe(false);
});

test("a browser that keeps nothing is told of once, and only where work would be lost", async () => {
  const page = new Page();
  page.full = true;
  const { change, notices } = await bench(page);
  expect(notices.notice).toBeNull();
  await change(21);
  expect(notices.notice?.text).toMatch(/keeps no copy/);
  const { id } = notices.notice ?? { id: 0 };
  notices.dismiss(id);
  await change(22);
  expect(notices.notice).toBeNull();
});

test("settings are kept when they change, and not before", async () => {
  const { page, store } = await bench();
  expect(page.kept.has("pasu.settings")).toBe(false);
  store.apply(selectTab("look"));
  expect(readSettings(page.shelf).tab).toBe("look");
});

test("it can be left and followed again", async () => {
  const { change, keeper, leave, page, store } = await bench();
  leave();
  await change(21);
  store.apply(selectTab("look"));
  expect([page.written, page.kept.get("pasu.settings")]).toEqual([0, undefined]);
  keeper.connect();
  expect(page.written).toBe(1);
  expect(page.hash).toContain("h1=21");
  expect(readSettings(page.shelf).tab).toBe("look");
});

/** A network of one patch, for which the solver is made to say what it says of thousands. */
const SHEET: Design = {
  ...JAR,
  parts: [
    {
      shape: {
        kind: "vertex-frame",
        vertices: [
          [0, 0, 0],
          [1, 0, 0],
          [2, 0, 0],
          [2, 1, 0],
          [2, 2, 1],
          [1, 2, 0],
          [0, 2, 0],
          [0, 1, 0],
        ],
        patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }],
      },
    },
  ],
};

test("a design that is too large for an address says so, and is kept as a file that opens again", async () => {
  const { change, keeper, notices, page, rests, solver, store } = await bench();
  await change(21);
  expect(page.hash).not.toBe("");
  store.apply({ design: SHEET, undo: "step" });
  await rests();
  expect(keeper.tooLargeForLink).toBe(true);
  // The address of another pot would be a lie.
  expect(page.hash).toBe("");
  expect(await keeper.address()).toBeNull();
  expect(notices.notice?.text).toMatch(/too large for an address/);
  await notices.undo();
  expect(notices.notice?.text).toBe("Saved as “Shoulder jar.json”.");
  const text = (await page.files[0]?.text) ?? "";
  // On one line: it is large enough.
  expect(text.trimEnd()).not.toContain("\n");
  const again = await solver.parse(text);
  expect(again.state === "done" && again.value.link).toBe("");
  // It is told once, and again after there was one with an address.
  store.undo();
  await rests();
  expect(page.hash).toContain("h1=21");
});

test("what is long to write waits until the page has nothing else to do, and only the latest is written", async () => {
  const { change, page, rests, store, surface } = await bench();
  await change(21);
  const before = page.hash;
  page.waiting = [];
  const long = (title: string) => ({ ...rowOf(400), title });
  store.apply({ design: long("Earlier"), undo: "step" });
  await rests();
  store.apply({ design: long("Latest"), undo: "step" });
  await rests();
  const link = surface.settled?.solved.link ?? "";
  expect(link.length).toBeGreaterThan(1024);
  expect(page.hash).toBe(before);
  expect(readWork(page.shelf, TAB)?.text).not.toContain("Latest");
  // A hand that moves on meanwhile takes nothing of it away.
  store.apply({ design: long("Under the hand"), undo: "merge", key: "title" });
  const written = page.written;
  for (const run of page.waiting.splice(0)) run();
  expect(page.hash).toBe(`#${link}`);
  expect(page.written).toBe(written + 1);
  expect(readWork(page.shelf, TAB)).toMatchObject({ link, unsaved: true });
  // What is short is written at once, and what still waited is not written over it.
  store.endGesture();
  await rests();
  store.apply({ design: tall(JAR, 22), undo: "step" });
  await rests();
  const waited = page.waiting.splice(0);
  expect(waited.length).toBeGreaterThan(0);
  const now = page.hash;
  expect(now).toContain("h1=22");
  for (const run of waited) run();
  expect(page.hash).toBe(now);
});
