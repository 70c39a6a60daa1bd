import { effect } from "@preact/signals-core";
import { beforeEach, expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { JAR, tall } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";
import { moved, rowOf, taller, withPart } from "../../testing/row";
import { stripOf } from "../../testing/strip";
import { setPath } from "../document/path";
import type { Design } from "../document/types";
import { selectTab, toggleOverlay } from "../state/actions";
import { selectParts } from "../state/seen-actions";
import { NEW_SESSION } from "../state/session";
import { Store } from "../state/store";
import { type Companion, Surface } from "./surface";

let store: Store;
let surface: Surface;
let worker: ReturnType<typeof realSolver>["worker"];

beforeEach(() => {
  const real = realSolver();
  worker = real.worker;
  store = new Store(JAR, NEW_SESSION);
  surface = new Surface(store, real.solver);
  surface.grid = () => ({ rows: 13, columns: 25 });
});

/** Begins and waits for the first surface. */
async function begun(): Promise<() => void> {
  surface.begin();
  const leave = surface.connect();
  await worker.finish();
  return leave;
}

const drag = (height: number) => store.apply({ design: tall(store.design, height), undo: "merge", key: "height" });
/** What was asked for last, as the solver was told. */
const options = () => {
  const { ask } = worker.last;
  if (ask.kind !== "parts") throw new Error(`asked for a ${ask.kind}`);
  const section = ask.parts.find((part) => part.section)?.place ?? null;
  return { settle: ask.whole !== null, section, lines: ask.parts.some(({ mesh }) => mesh?.lines) };
};

test("nothing is solved before it is decided what is shown, and then at once", async () => {
  surface.connect();
  expect(worker.sent).toEqual([]);
  expect(surface.status).toBe("starting");
  surface.begin();
  expect(worker.sent).toHaveLength(1);
  await worker.answer();
  expect(surface.shown).toMatchObject({ design: JAR, change: 1, settled: true, framing: 0, travelled: false });
  expect(surface.settled).toBe(surface.shown);
  expect(surface.status).toBe("ready");
  expect(surface.accuracy).not.toBe("");
});

test("under the hand nothing but the mesh is asked for, and at its end once more, finely", async () => {
  await begun();
  drag(21);
  expect(options()).toMatchObject({ settle: false, section: null });
  await worker.answer();
  expect(surface.shown).toMatchObject({ settled: false });
  expect(surface.settled).toBeNull();
  expect(surface.accuracy).toBe("");
  expect(surface.status).toBe("solving");
  store.endGesture();
  expect(options()).toMatchObject({ settle: true, section: 0 });
  await worker.finish();
  expect(worker.sent).toHaveLength(3);
  expect(surface.settled?.design).toBe(store.design);
});

test("the latest wins while one is under way", async () => {
  await begun();
  for (const height of [21, 22, 23, 24]) drag(height);
  store.endGesture();
  await worker.finish();
  expect(worker.sent).toHaveLength(3);
  expect(surface.settled?.solved.facts?.height).toBeCloseTo(24);
});

test("a drag asks again only where the session wants more of the surface", async () => {
  await begun();
  store.apply(selectTab("look"));
  store.apply(toggleOverlay(store.state, "wireframe"));
  expect(worker.sent).toHaveLength(1);
  store.apply(toggleOverlay(store.state, "isoU"));
  expect(options().lines).toBe(true);
  await worker.finish();
  store.apply(selectTab("profile"));
  expect(worker.sent).toHaveLength(2);
  drag(21);
  expect(options()).toMatchObject({ settle: false, section: 0, lines: true });
});

test("the section is that of the selected part", async () => {
  const [part] = JAR.parts;
  const two: Design = { ...JAR, parts: [...JAR.parts, ...(part ? [part] : [])] };
  store.apply({ design: two, undo: "step" });
  await begun();
  expect(options().section).toBe(0);
  store.apply(selectParts(...store.ids.slice(1)));
  expect(options().section).toBe(1);
});

test("what the solver refuses is told, the last surface stays, and undo brings all back", async () => {
  await begun();
  const { shown } = surface;
  store.apply({ design: setPath(JAR, ["parts", 0, "shape", "h1"], Number.POSITIVE_INFINITY), undo: "step" });
  await worker.finish();
  expect(surface.problem?.path).toBe("parts[0].shape.h1");
  expect(surface.status).toBe("error");
  expect(surface.shown).toBe(shown);
  store.undo();
  await worker.finish();
  expect(surface.problem).toBeNull();
  expect(surface.settled).toMatchObject({ travelled: true });
  store.apply({ design: tall(JAR, 22), undo: "step" });
  await worker.finish();
  expect(surface.settled).toMatchObject({ travelled: false, framing: 0 });
});

test("an opened design is one to go to", async () => {
  await begun();
  surface.reframe();
  store.apply({ design: tall(JAR, 40), undo: "step" });
  await worker.finish();
  expect(surface.shown?.framing).toBe(1);
});

test("a surface waits for its companion, and then shows what the document says by then", async () => {
  await begun();
  let run: (() => void) | null = null;
  const companion: Companion = {
    waits: (later) => {
      run = later;
      return true;
    },
    join: () => null,
  };
  surface.accompany(companion);
  drag(21);
  drag(22);
  expect(worker.sent).toHaveLength(1);
  surface.accompany(null);
  const later: (() => void) | null = run;
  (later ?? (() => {}))();
  await worker.finish();
  expect(surface.shown?.solved.facts?.height).toBeCloseTo(22);
});

test("what waited for its companion is not shown after what came later and did not wait", async () => {
  await begun();
  let release = () => {};
  const companion: Companion = {
    waits: () => false,
    join: (_, solving) => new Promise((resolve) => (release = () => void solving.then(resolve))),
  };
  surface.accompany(companion);
  drag(21);
  await worker.answer();
  surface.accompany(null);
  drag(22);
  await worker.answer();
  expect(surface.shown?.change).toBe(3);
  release();
  await settled();
  expect(surface.shown?.change).toBe(3);
  expect(surface.shown?.design).toBe(store.design);
});

test("who looks at the words hears of nothing else", async () => {
  await begun();
  const heard: string[] = [];
  effect(() => void heard.push(surface.accuracy));
  store.apply({ design: { ...JAR, title: "Another name" }, undo: "step" });
  await worker.finish();
  expect(surface.settled?.design.title).toBe("Another name");
  expect(heard).toHaveLength(1);
});

test("it can be left and followed again", async () => {
  const leave = await begun();
  leave();
  store.apply({ design: tall(JAR, 21), undo: "step" });
  expect(worker.sent).toHaveLength(1);
  const again = surface.connect();
  await worker.finish();
  expect(surface.settled?.design).toBe(store.design);
  again();
  surface.connect();
  expect(worker.sent).toHaveLength(2);
});

test("with twenty parts a slider asks for one of them, and a part that moves under the hand for nothing until it rests", async () => {
  store.apply({ design: rowOf(20), undo: "step" });
  await begun();
  const parts = () =>
    worker.sent.splice(0).map(({ ask }) => (ask.kind === "parts" ? ask.parts.map(({ place }) => place) : []));
  expect(parts()).toEqual([Array.from({ length: 20 }, (_, place) => place)]);
  const before = surface.shown?.solved.parts;
  for (const height of [3, 4]) {
    store.apply({ design: withPart(store.design, 7, taller(height)), undo: "merge", key: "height" });
    await worker.answer();
  }
  store.endGesture();
  await worker.finish();
  expect(parts()).toEqual([[7], [7], [7]]);
  expect(surface.settled?.solved.parts.filter(({ mesh }, place) => mesh !== before?.[place]?.mesh)).toHaveLength(1);
  for (const y of [1, 2, 3]) {
    store.apply({ design: withPart(store.design, 3, moved({ shift: [9, y, 0] })), undo: "merge", key: "move" });
    await worker.finish();
    expect(surface.shown).toMatchObject({ design: store.design, settled: false });
    expect(surface.shown?.solved.parts[3]?.matrix[13]).toBe(y);
  }
  expect(worker.sent).toEqual([]);
  store.endGesture();
  await worker.finish();
  expect(parts()).toEqual([[]]);
  expect(surface.settled?.design).toBe(store.design);
  expect(surface.status).toBe("ready");
});

test("of a large network what a hand moved last is shown before its link is made, and nothing is sampled for that", async () => {
  const strip = stripOf(120);
  store.apply({ design: strip, undo: "step" });
  await begun();
  expect(surface.settled?.design).toBe(strip);
  const asked = () =>
    worker.sent
      .splice(0)
      .map(({ ask }) =>
        ask.kind === "parts" ? [ask.parts.filter(({ mesh }) => mesh).length, ask.whole !== null] : [],
      );
  asked();
  const lift = (z: number) =>
    store.apply({
      design: setPath(store.design, ["parts", 0, "shape", "vertices", 4], [1, 1, z]),
      undo: "merge",
      key: "hand",
    });
  // The last movement waits for the one before it when the hand lets go.
  lift(0.1);
  lift(0.2);
  store.endGesture();
  await worker.answer();
  await worker.answer();
  expect(surface.shown).toMatchObject({ design: store.design, settled: false });
  expect(surface.status).toBe("solving");
  await worker.finish();
  expect(surface.settled?.solved.link).not.toBe("");
  expect(surface.status).toBe("ready");
  expect(asked()).toEqual([
    [1, false],
    [1, false],
    [0, true],
  ]);
});

test("parts that were only moved are shown before their link is made, and so is undo", async () => {
  store.apply({ design: rowOf(3), undo: "step" });
  await begun();
  const first = store.design;
  worker.sent.splice(0);
  store.apply({ design: withPart(first, 1, moved({ shift: [9, 1, 0] })), undo: "merge", key: "move" });
  store.endGesture();
  await settled();
  expect(surface.shown).toMatchObject({ design: store.design, settled: false });
  await worker.finish();
  expect(surface.settled?.design).toBe(store.design);
  store.undo();
  await settled();
  expect(surface.shown).toMatchObject({ design: first, settled: false, travelled: true });
  await worker.finish();
  expect(surface.settled).toMatchObject({ design: first, travelled: true });
  expect(worker.sent.map(({ ask }) => ask.kind === "parts" && [ask.parts.length, ask.whole !== null])).toEqual([
    [0, true],
    [0, true],
  ]);
});
