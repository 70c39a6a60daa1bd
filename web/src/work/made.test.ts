import { expect, test, vi } from "vitest";
import { JAR, POT, tall, WALL } from "../../testing/jar";
import { realMaker } from "../../testing/real-maker";
import { type Workbench, workbench } from "../../testing/workbench";
import type { Extents } from "../document/extents";
import { setPath } from "../document/path";
import type { Design, Wall } from "../document/types";
import type { Ask } from "../maker/messages";
import { longest } from "../solver/solved";
import { openDesign, selectTab, toggleOverlay, togglePulling } from "../state/actions";
import { setFill, setMap } from "../state/wall-actions";
import { Made } from "./made";

/** No clock runs: a surface waits for its wall as long as it takes. */
const never = () => () => {};

interface Bench extends Workbench {
  readonly made: Made;
  readonly leave: () => void;
  /** What was asked since this was last called. */
  readonly asked: () => readonly Ask[];
  readonly kinds: () => readonly string[];
}

async function bench(design: Design): Promise<Bench> {
  const there = await workbench(design);
  const { maker, making, store, surface } = there;
  const made = new Made(store, surface, maker, never);
  const leave = made.connect();
  const asked = () => making.sent.splice(0).map(({ ask }) => ask);
  return { ...there, made, leave, asked, kinds: () => asked().map(({ kind }) => kind) };
}

/** The bench with a pot that is made, coarsely and finely. */
async function potted(design = POT): Promise<Bench> {
  const there = await bench(design);
  await there.making.finish();
  there.asked();
  return there;
}

const rewalled = (wall: Partial<Wall>): Design => setPath(JAR, ["parts", 0, "wall"], { ...WALL, ...wall });

test("a pot at rest is made coarsely, then finely, and nothing else before it is looked at", async () => {
  const { asked, made, making, store } = await bench(POT);
  const [coarse, ...none] = asked();
  expect(coarse).toMatchObject({ kind: "solid", fine: false });
  expect(none).toEqual([]);
  await making.answer();
  expect(made.solid).toMatchObject({ of: POT, key: "coarse", problem: null });
  const [fine] = asked();
  expect(fine).toMatchObject({ kind: "solid", fine: true });
  const tolerances = [coarse, fine].map((ask) => (ask?.kind === "solid" ? ask.tolerance : 0));
  expect(tolerances[1]).toBeLessThan(tolerances[0] ?? 0);
  const before = made.solid.value?.positions.length ?? 0;
  await making.answer();
  expect(made.solid.key).toBe("fine");
  expect(made.solid.value?.positions.length).toBeGreaterThan(before);
  store.apply(selectTab("look"));
  expect(asked()).toEqual([]);
});

test("what stays as it is has the same tolerance where all is a little larger, and none that is too coarse", async () => {
  const drawn = async (height: number) => {
    const there = await bench(tall(POT, height));
    const [coarse] = there.asked();
    const tolerance = coarse?.kind === "solid" ? coarse.tolerance : Number.NaN;
    return { tolerance, share: tolerance / longest(there.surface.shown?.solved) };
  };
  expect((await drawn(22.1)).tolerance).toBe((await drawn(22)).tolerance);
  for (const height of [0.5, 20, 21, 23, 30, 400]) {
    const { share } = await drawn(height);
    expect(share).toBeLessThanOrEqual(1 / 150);
    expect(share).toBeGreaterThan(1 / 150 / 2 ** (1 / 4));
  }
});

test("nothing is made while the shape changes, everything once it rests", async () => {
  const { kinds, making, maker, rests, store } = await potted();
  store.apply({ design: tall(POT, 21), undo: "merge", key: "height" });
  expect(kinds()).toEqual(["quick"]);
  expect(maker.busy).toBe(true);
  await making.answer();
  store.endGesture();
  await making.finish();
  await rests();
  await making.finish();
  expect(kinds()).toContain("solid");
});

test("a drag has the machine for itself: what is under way is ended, and asked again at rest", async () => {
  const { made, making, maker, rests, store } = await bench(POT);
  expect(maker.busy).toBe(true);
  store.apply({ design: tall(POT, 21), undo: "merge", key: "height" });
  expect(making.last.ask.kind).toBe("quick");
  await making.finish();
  expect(made.solid.key).toBe("quick");
  store.endGesture();
  await making.finish();
  await rests();
  await making.finish();
  expect(made.solid).toMatchObject({ of: store.design, key: "fine" });
});

test("a wall that changes is followed under the hand", async () => {
  const { asked, store } = await potted();
  const thicker = rewalled({ thickness: 0.4 });
  store.apply({ design: thicker, undo: "merge", key: "wall" });
  expect(asked()).toMatchObject([{ kind: "solid", design: thicker, fine: false }]);
});

test("what is made of an earlier wall is shown until the latest is there", async () => {
  const { made, making, store } = await potted();
  const [earlier, latest] = [rewalled({ thickness: 0.4 }), rewalled({ thickness: 0.5 })];
  store.apply({ design: earlier, undo: "merge", key: "wall" });
  store.apply({ design: latest, undo: "merge", key: "wall" });
  await making.answer();
  expect(made.solid.of).toEqual(earlier);
  await making.answer();
  expect(made.solid.of).toEqual(latest);
});

test("a surface without a wall has no solid, and one that was there goes", async () => {
  const { kinds, made, store } = await potted();
  expect(made.solid.value).not.toBeNull();
  store.apply({ design: JAR, undo: "step" });
  expect(made.solid.value).toBeNull();
  expect(kinds()).toEqual([]);
});

test("the panel's measures and checks are asked for while it is open", async () => {
  const { kinds, made, making, maker, store } = await potted();
  store.apply(selectTab("measures"));
  await making.finish();
  expect(kinds()).toEqual(["measure", "check"]);
  expect(made.measures.value?.height.value).toBeCloseTo(20);
  expect(made.report.value?.ok).toBe(true);
  expect(maker.busy).toBe(false);
});

test("what a surface would hold is not said of a pot whose wall is new", async () => {
  const { made, making, rests, store } = await potted(JAR);
  store.apply(selectTab("wall"));
  await making.finish();
  const surface = made.holds;
  expect(surface).toMatch(/^Holds /);
  store.apply({ design: POT, undo: "step" });
  expect(made.holds).toBeNull();
  await rests();
  await making.finish();
  const pot = made.holds;
  expect(pot).toMatch(/^Holds /);
  expect(pot).not.toBe(surface);
  // Nor what the wall before held.
  store.apply({ design: rewalled({ thickness: 0.6 }), undo: "step" });
  expect(made.holds).toBeNull();
  expect(made.isOfNow(made.measures)).toBe(false);
  await rests();
  await making.finish();
  expect(made.holds).toMatch(/^Holds /);
  expect(made.holds).not.toBe(pot);
  expect(made.isOfNow(made.measures)).toBe(true);
});

test("measures of an earlier change stay until the new ones are there, those of another pot go at once", async () => {
  const { made, making, rests, store } = await potted();
  store.apply(selectTab("measures"));
  await making.finish();
  const { measures } = made;
  store.apply({ design: tall(POT, 21), undo: "step" });
  expect(made.measures).toBe(measures);
  await rests();
  // Nor do those come that were asked for before it was opened.
  store.apply(openDesign(store.state, tall(POT, 22)));
  expect(made.measures.value).toBeNull();
  await making.finish();
  expect(made.measures.of).not.toEqual(tall(POT, 21));
  await rests();
  await making.finish();
  expect(made.measures).toMatchObject({ of: store.design, problem: null });
  store.undo();
  expect(made.measures.value).toBeNull();
});

test("beside the wall's numbers checks are asked for where a ring or a drain may have been fitted", async () => {
  const { kinds, made, making, rests, store } = await potted();
  store.apply(selectTab("wall"));
  await making.finish();
  expect(kinds()).toEqual(["measure"]);
  for (const wall of [{ foot: [0.5, 0.3] as const }, { drain: 1 }]) {
    store.apply({ design: rewalled(wall), undo: "step" });
    await rests();
    await making.finish();
    expect(kinds()).toContain("check");
    expect(made.report).toMatchObject({ of: store.design, value: { ok: true } });
  }
});

test("water waits for its range and then follows its level", async () => {
  const { asked, kinds, made, making, store } = await potted();
  store.apply(setFill(store.state, 0.5));
  expect(kinds()).toEqual(["measure"]);
  await making.answer();
  const range = made.waterRange ?? { low: 0, high: 0 };
  expect(range.high).toBeGreaterThan(range.low);
  expect(asked()).toMatchObject([{ kind: "water", level: (range.low + range.high) / 2 }]);
  await making.answer();
  const half = made.water.value?.volume ?? 0;
  expect(half).toBeGreaterThan(0);
  store.apply(setFill(store.state, 1));
  expect(asked()).toMatchObject([{ kind: "water", level: range.high }]);
  await making.answer();
  expect(made.water.value?.volume).toBeGreaterThan(half);
  expect(made.level).toBe(range.high);
  store.apply({ session: { fill: null }, undo: "none" });
  expect(made.water.value).toBeNull();
  expect(made.level).toBeNull();
});

test("a map is painted on the grid of the stage, and another one when it is chosen", async () => {
  const { asked, made, making, store } = await potted();
  store.apply(setMap("overhang"));
  expect(asked()).toMatchObject([{ kind: "paint", map: "overhang", rows: 13, columns: 25 }]);
  await making.answer();
  expect(made.painted.value?.values.length).toBe(13 * 25);
  store.apply(setMap("mean-curvature"));
  expect(asked()).toMatchObject([{ kind: "paint", map: "mean-curvature" }]);
  store.apply(setMap(null));
  expect(made.painted.value).toBeNull();
});

test("why there is no pot is kept in words", async () => {
  const { made, making } = await bench(rewalled({ base: 30 }));
  await making.finish();
  expect(made.solid.value).toBeNull();
  expect(made.solid.problem?.path).toMatch(/^parts\[0\]/);
  expect(made.solid.problem?.message).not.toBe("");
});

test("it can be left and followed again", async () => {
  const { kinds, leave, made, making, maker, rests, store } = await bench(POT);
  leave();
  expect(maker.busy).toBe(false);
  store.apply({ design: rewalled({ thickness: 0.4 }), undo: "step" });
  store.apply(toggleOverlay(store.state, "axes"));
  await rests();
  expect(kinds()).toEqual(["solid"]);
  made.connect();
  await making.finish();
  expect(made.solid).toMatchObject({ of: store.design, key: "fine" });
  expect(made.measures.of).toEqual(store.design);
});

test("whether parts fit together is judged by another maker, which nothing else waits for", async () => {
  const { store, surface, maker, making } = await workbench({ ...POT, parts: [...POT.parts, ...JAR.parts] });
  const { maker: judge, worker: judging } = realMaker();
  const made = new Made(store, surface, maker, never, judge);
  const leave = made.connect();
  store.apply(selectTab("measures"));
  expect(judging.sent.map(({ ask }) => ask.kind)).toEqual(["constraints"]);
  // It is not done yet, and all else goes on.
  await making.finish();
  expect(making.sent.map(({ ask }) => ask.kind)).not.toContain("constraints");
  expect(made.measures.value).not.toBeNull();
  expect(made.constraints.value).toBeNull();
  await judging.finish();
  expect(made.constraints).toMatchObject({ of: store.design, value: { isKept: false } });
  leave();
});

/** The bench with a judge, and a clock that is over when the test says so. */
async function heldStill(design: Design) {
  const there = await workbench(design);
  const { store, surface, maker, making } = there;
  const { maker: judge, worker: judging } = realMaker();
  const clocks = new Set<() => void>();
  const later = (run: () => void) => {
    clocks.add(run);
    return () => clocks.delete(run);
  };
  const made = new Made(store, surface, maker, later, judge);
  made.connect();
  await making.finish();
  /** The hand holds still. */
  const wait = () => {
    for (const run of [...clocks]) {
      clocks.delete(run);
      run();
    }
  };
  const pull = async (height: number) => {
    store.apply({ design: tall(POT, height), undo: "merge", key: "height" });
    await making.finish();
    await there.solved();
    await making.finish();
  };
  const judged = () => judging.sent.splice(0).map(({ ask }) => ask.kind);
  return { ...there, judge, judging, judged, made, wait, pull };
}

test("whether a pot can be made is found out while a hand holds it still, by the judge, and once", async () => {
  const { judged, judging, made, making, pull, rests, store, wait } = await heldStill(POT);
  store.apply(selectTab("measures"));
  await making.finish();
  await pull(21);
  expect(judged()).toEqual([]);
  expect(made.isOfNow(made.report)).toBe(false);
  wait();
  await judging.finish();
  expect(judged()).toEqual(["measure", "check"]);
  expect(store.inGesture).toBe(true);
  expect(made.report).toMatchObject({ of: store.design, value: { ok: true } });
  expect(made.measures.value?.height.value).toBeCloseTo(21);
  // The hand lets go of the same pot: its fine picture is asked for, and nothing else.
  making.sent.splice(0);
  store.endGesture();
  await making.finish();
  await rests();
  await making.finish();
  expect(making.sent.map(({ ask }) => ask.kind)).toEqual(["quick", "solid"]);
  expect(judged()).toEqual([]);
  expect(made.isOfNow(made.report)).toBe(true);
});

test("a hand that moves on takes back what was to be found out", async () => {
  const { judge, judging, judged, made, making, pull, store, wait } = await heldStill(POT);
  store.apply(selectTab("measures"));
  await making.finish();
  await pull(21);
  wait();
  expect(judge.busy).toBe(true);
  await pull(22);
  expect(judge.busy).toBe(false);
  expect(made.isOfNow(made.measures)).toBe(false);
  judged();
  wait();
  await judging.finish();
  expect(judged()).toEqual(["measure", "check"]);
  expect(made.measures).toMatchObject({ of: store.design, problem: null });
  expect(made.measures.value?.height.value).toBeCloseTo(22);
});

test("a hand that pulls is told whatever panel is open, and nobody else is", async () => {
  const { judged, judging, made, making, pull, rests, store, wait } = await heldStill(POT);
  await pull(21);
  wait();
  await judging.finish();
  expect(judged()).toEqual([]);
  store.endGesture();
  await making.finish();
  await rests();
  await making.finish();
  expect(made.report.value).toBeNull();
  store.apply(togglePulling(store.state));
  await making.finish();
  expect(made.report.value?.ok).toBe(true);
  await pull(22);
  wait();
  await judging.finish();
  expect(judged()).toEqual(["measure", "check"]);
  expect(made.report).toMatchObject({ of: store.design, value: { ok: true } });
  store.endGesture();
  await making.finish();
  await rests();
  store.apply(togglePulling(store.state));
  expect(made.report.value).toBeNull();
});

const shifted = (design: Design, x: number): Design => setPath(design, ["parts", 0, "place"], { shift: [x, 0, 0] });

test("a wall goes along with a part that is only moved: nothing is made under the hand, and the fine wall at once at rest", async () => {
  const { asked, made, making, rests, solved, store, surface } = await potted();
  const wall = made.solid;
  const extents = () => made.extentsOf(store.design, surface.shown?.solved.facts?.extents as Extents);
  const before = extents();
  for (const x of [1, 2, 3]) {
    store.apply({ design: shifted(POT, x), undo: "merge", key: "hand" });
    await solved();
    // The picture waits for nothing.
    expect(surface.shown?.design).toBe(store.design);
    // It is as high and as wide with its wall as it was.
    expect(extents().height).toBeCloseTo(before.height, 9);
    expect(extents().greatest.width).toBeCloseTo(before.greatest.width, 5);
  }
  expect(asked()).toEqual([]);
  expect(made.solid).toBe(wall);
  store.endGesture();
  await rests();
  expect(asked()).toMatchObject([{ kind: "solid", fine: true, design: store.design }]);
  expect(made.solid).toBe(wall);
  await making.finish();
  expect(made.solid).toMatchObject({ of: store.design, key: "fine" });
});

test("a wall that is still to come when a part is moved is made for all that", async () => {
  const { made, making, solved, store } = await bench(POT);
  store.apply({ design: shifted(POT, 1), undo: "merge", key: "hand" });
  await solved();
  await making.answer();
  expect(made.solid).toMatchObject({ of: POT, key: "coarse" });
});

test("a pot that is scaled is made anew under the hand, and one with water in it that is moved", async () => {
  const larger = setPath(POT, ["parts", 0, "place"], { scale: [2, 2, 2] });
  for (const [design, fill] of [
    [larger, null],
    [shifted(POT, 1), 0.5],
  ] as const) {
    const { kinds, solved, store } = await potted();
    store.apply({ session: { fill }, undo: "none" });
    kinds();
    store.apply({ design, undo: "merge", key: "hand" });
    await solved();
    expect(kinds()).toContain("quick");
  }
});

test("the wall of a part that is tilted stands with those of the others, until all are made", async () => {
  const part = POT.parts[0];
  if (!part) throw new Error("the pot has a part");
  const scene = { ...POT, parts: [part, { ...part, place: { shift: [40, 0, 0] as const } }] };
  const { made, making, rests, store } = await potted(scene);
  const walls = made.solid;
  expect(walls.value).not.toBeNull();
  const tilted = setPath(scene, ["parts", 1, "place"], { shift: [40, 0, 0], axis: [1, 0, 0], angle: 0.2 });
  store.apply({ design: tilted, undo: "merge", key: "tilt" });
  await making.finish();
  expect(made.solid).toBe(walls);
  expect(made.changed).toMatchObject({ of: tilted, parts: [1], problem: null });
  expect(made.changed.value?.bounds).not.toBeNull();
  store.endGesture();
  await making.finish();
  await rests();
  await making.finish();
  expect(made.solid).toMatchObject({ of: tilted, key: "fine" });
  expect(made.changed).toMatchObject({ value: null, of: null, parts: [] });
});

/** A pot, and beside it the same surface without a wall. */
function half(): Design {
  const [pot, jar] = [POT.parts[0], JAR.parts[0]];
  if (!pot || !jar) throw new Error("both have a part");
  return { ...POT, parts: [pot, { ...jar, object: 1, place: { shift: [60, 0, 0] } }] };
}

test("what has no wall counts for how high and wide a scene is", async () => {
  const scene = half();
  const { made, store, surface, making } = await potted(scene);
  const drawn = surface.shown?.solved.facts?.extents as Extents;
  expect(drawn.greatest.width).toBeGreaterThan(60);
  const extents = made.extentsOf(scene, drawn);
  expect(extents.greatest.width).toBeGreaterThan(60);
  expect(extents.height).toBeCloseTo(drawn.height, 1);
  // Nor do measures say otherwise.
  store.apply(selectTab("measures"));
  await making.finish();
  expect(made.measures.of).toBe(scene);
  expect(made.extentsOf(scene, drawn).greatest.width).toBeCloseTo(extents.greatest.width, 0);
});

test("walls that nothing was done to are not made again", async () => {
  const { asked, made, making, rests, store } = await potted(half());
  const { value } = made.solid;
  const place = { shift: [60, 0, 0] as const, axis: [1, 0, 0] as const, angle: 0.2 };
  const tilted = setPath(store.design, ["parts", 1, "place"], place);
  store.apply({ design: tilted, undo: "step" });
  await rests();
  await making.finish();
  expect(asked().filter(({ kind }) => kind === "solid" || kind === "quick")).toEqual([]);
  expect(made.solid).toMatchObject({ of: tilted, key: "fine" });
  expect(made.solid.value).toBe(value);
});

test("a wall that was refused before has nothing looked for that would help this one", async () => {
  const { asked, made, maker, making, rests, store } = await potted();
  store.apply(selectTab("wall"));
  await making.finish();
  store.apply({ design: rewalled({ base: 30 }), undo: "step" });
  await rests();
  await making.finish();
  expect(made.solid.problem).not.toBeNull();
  expect(asked().map(({ kind }) => kind)).toContain("check");
  const ask = vi.spyOn(maker, "ask");
  store.apply({ design: POT, undo: "step" });
  await rests();
  await making.finish();
  expect(made.solid).toMatchObject({ of: POT, problem: null });
  expect(ask.mock.calls.map(([{ kind }]) => kind)).not.toContain("check");
  expect(made.report.value).toBeNull();
});
