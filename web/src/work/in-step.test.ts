import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { JAR, POT, tall, WALL } from "../../testing/jar";
import { type Options, type Workbench, workbench } from "../../testing/workbench";
import { setPath } from "../document/path";
import type { Design } from "../document/types";
import type { Ask, Quick, Solid } from "../maker/messages";
import { setFill } from "../state/wall-actions";
import { InStep } from "./in-step";
import { NOTHING, type Piece } from "./piece";

type QuickAsk = Extract<Ask, { kind: "quick" }>;

interface Bench extends Workbench {
  readonly inStep: InStep;
  /** What was put on the stage. */
  readonly pieces: Piece<Quick>[];
  /** Of which parts each of these is; null of all. */
  readonly parts: (readonly number[] | null)[];
  /** What stands on the stage from now on. */
  readonly stand: (design: Design) => void;
  /** Lets the time of all clocks that run be over. */
  readonly tick: () => void;
  /** Moves the hand on. */
  readonly drag: (height: number) => void;
  readonly height: () => number | undefined;
  readonly asked: () => readonly QuickAsk[];
}

async function bench(design: Design, options: Options = {}): Promise<Bench> {
  const there = await workbench(design, options);
  const { maker, making, store, surface } = there;
  const pieces: Piece<Quick>[] = [];
  const parts: (readonly number[] | null)[] = [];
  let walls: Piece<Solid> = NOTHING;
  const clocks: (() => void)[] = [];
  const later = (run: () => void) => {
    clocks.push(run);
    return () => {
      // One that is over is not there any more.
      if (clocks.includes(run)) clocks.splice(clocks.indexOf(run), 1);
    };
  };
  const put = (piece: Piece<Quick>, of: readonly number[] | null) => {
    pieces.push(piece);
    parts.push(of);
  };
  const inStep = new InStep(store, surface, maker, put, later, () => walls);
  surface.accompany(inStep);
  return {
    ...there,
    inStep,
    pieces,
    parts,
    stand: (of) => {
      walls = { ...NOTHING, value: {} as Solid, of };
    },
    tick: () => {
      for (const run of clocks.splice(0)) run();
    },
    drag: (height) => store.apply({ design: tall(store.design, height), undo: "merge", key: "height" }),
    height: () => surface.shown?.solved.facts?.height,
    asked: () => making.sent.flatMap(({ ask }) => (ask.kind === "quick" ? [ask] : [])),
  };
}

test("a surface is shown with its wall, not before", async () => {
  const { asked, drag, height, making, pieces, solved, store } = await bench(POT);
  drag(21);
  expect(asked()).toMatchObject([{ design: store.design }]);
  await solved();
  expect(height()).toBeCloseTo(20);
  await making.answer();
  expect(height()).toBeCloseTo(21);
  expect(pieces).toMatchObject([{ of: store.design, problem: null, key: "quick" }]);
  const { value } = pieces[0] ?? {};
  expect(value?.solid.positions.length).toBeGreaterThan(0);
  // The bounds are those of all of the pot.
  expect(value?.solid.bounds?.centre[2]).toBeCloseTo(10.5, 0);
});

test("one pair is under way at a time, and what waits is asked for after it, as it is by then", async () => {
  const { asked, drag, height, making, solved, solving } = await bench(POT);
  for (const each of [21, 22, 23]) drag(each);
  expect(solving.sent).toHaveLength(2);
  await solved();
  await making.answer();
  expect(height()).toBeCloseTo(21);
  expect(solving.sent).toHaveLength(3);
  await solved();
  await making.answer();
  expect(height()).toBeCloseTo(23);
  expect(asked()).toHaveLength(2);
});

test("surfaces without a wall, changes of the wall alone and changes without a hand are not held back", async () => {
  const bare = await bench(JAR);
  bare.drag(21);
  await bare.solved();
  expect(bare.height()).toBeCloseTo(21);
  expect(bare.asked()).toEqual([]);
  const { asked, height, solved, store } = await bench(POT);
  const thicker = setPath(POT, ["parts", 0, "wall"], { ...WALL, thickness: 0.5 });
  store.apply({ design: thicker, undo: "merge", key: "wall" });
  await solved();
  store.endGesture();
  store.apply({ design: tall(thicker, 22), undo: "step" });
  await solved();
  expect(height()).toBeCloseTo(22);
  expect(asked()).toEqual([]);
});

test("letting go settles with a wall, and what was under way is thrown away", async () => {
  const { asked, drag, making, pieces, solved, solving, store, surface } = await bench(POT);
  drag(21);
  await solved();
  store.endGesture();
  expect(solving.sent).toHaveLength(3);
  await solved();
  await making.answer();
  expect(pieces).toEqual([]);
  expect(surface.shown?.change).toBe(1);
  await making.answer();
  expect(pieces).toHaveLength(1);
  expect(surface.settled?.change).toBe(3);
  expect(asked()).toHaveLength(2);
  // The next change without a hand is none of a drag.
  store.apply({ design: tall(POT, 22), undo: "step" });
  await solved();
  expect(surface.settled?.change).toBe(4);
  expect(asked()).toHaveLength(2);
  // What was thrown away is written over by the next of its grid.
  expect(solving.sent.map(({ spares }) => spares.some((spare) => spare !== null))).toEqual([false, false, false, true]);
});

test("what cannot be a pot is shown bare, with the reason", async () => {
  const { drag, height, making, pieces, solved } = await bench(
    setPath(JAR, ["parts", 0, "wall"], { thickness: 0.3, base: 30 }),
  );
  drag(21);
  await solved();
  await making.answer();
  expect(height()).toBeCloseTo(21);
  expect(pieces).toMatchObject([{ value: null, key: "quick" }]);
  expect(pieces[0]?.problem?.path).toMatch(/^parts\[0\]/);
});

test("a surface does not wait for long, nor at all while the maker is busy with an older wall", async () => {
  const { asked, drag, height, making, pieces, solved, tick } = await bench(POT);
  drag(21);
  await solved();
  tick();
  await settled();
  expect(height()).toBeCloseTo(21);
  expect(pieces).toEqual([]);
  drag(22);
  await solved();
  expect(height()).toBeCloseTo(22);
  expect(asked()).toHaveLength(1);
  await making.answer();
  drag(23);
  expect(asked()).toHaveLength(2);
  expect(height()).toBeCloseTo(22);
});

test("a wall that is late is shown when it comes, if the hand still holds what it is of", async () => {
  const { asked, drag, making, pieces, solved, store, tick } = await bench(POT);
  drag(21);
  await solved();
  tick();
  await settled();
  expect(pieces).toEqual([]);
  await making.answer();
  expect(pieces).toMatchObject([{ of: store.design, problem: null, key: "quick" }]);
  expect(pieces[0]?.value?.solid.bounds?.centre[2]).toBeCloseTo(10.5, 0);
  // Nothing is left to ask for.
  tick();
  expect(asked()).toHaveLength(1);
});

test("the wall is asked for again once a hand that moved on holds still, and not before", async () => {
  const { asked, drag, making, pieces, solved, store, tick } = await bench(POT);
  drag(21);
  await solved();
  tick();
  await settled();
  // The maker still has the wall of 21.
  drag(22);
  await solved();
  await making.answer();
  expect(pieces).toEqual([]);
  expect(asked()).toHaveLength(1);
  tick();
  expect(asked()).toHaveLength(2);
  expect(asked().at(-1)?.design).toEqual(store.design);
  await making.answer();
  expect(pieces).toMatchObject([{ of: store.design, problem: null, key: "quick" }]);
});

test("a hand that let go or moved on is shown no wall of what it held", async () => {
  const { asked, drag, making, pieces, solved, store, tick } = await bench(POT);
  drag(21);
  await solved();
  tick();
  await settled();
  drag(22);
  await solved();
  store.endGesture();
  await solved();
  await making.answer();
  tick();
  await settled();
  expect(pieces).toEqual([]);
  expect(asked()).toHaveLength(1);
});

test("a wall that is left out for its time comes all the same while the hand holds still", async () => {
  const { asked, drag, making, pieces, solved, store, tick } = await bench(POT, { took: 130 });
  for (let i = 1, before = -1; asked().length > before; i += 1) {
    before = asked().length;
    drag(20 + i / 10);
    await solved();
    if (asked().length > before) await making.answer();
  }
  const before = asked().length;
  expect(pieces.at(-1)?.of).not.toBe(store.design);
  tick();
  expect(asked()).toHaveLength(before + 1);
  await making.answer();
  expect(pieces.at(-1)).toMatchObject({ of: store.design, problem: null });
  // A hand that moves on goes without it, as before.
  drag(23);
  await solved();
  expect(asked()).toHaveLength(before + 1);
});

test("walls are made as coarsely as it takes, and left out for the rest of a drag when even that takes too long", async () => {
  const { asked, drag, height, making, solved, store } = await bench(POT, { took: 130 });
  for (let i = 1; i <= 20; i += 1) {
    const before = asked().length;
    drag(20 + i / 10);
    await solved();
    if (asked().length === before) break;
    await making.answer();
  }
  const tolerances = asked().map(({ tolerance }) => tolerance);
  expect(tolerances).toEqual([...tolerances].sort((a, b) => a - b));
  expect(tolerances.at(-1)).toBeGreaterThan(tolerances[0] ?? 0);
  expect(tolerances.length).toBeLessThan(10);
  // The next drag tries again.
  const before = asked().length;
  store.endGesture();
  await solved();
  expect(asked()).toHaveLength(before);
  drag(25);
  expect(asked()).toHaveLength(before + 1);
  await solved();
  expect(height()).toBeLessThan(25);
});

test("arrays that are not shown any more go back to be written over", async () => {
  const { asked, drag, inStep, making, pieces, solved } = await bench(POT);
  drag(21);
  await solved();
  await making.answer();
  const solid = pieces[0]?.value?.solid;
  if (!solid) throw new Error("there is no wall");
  const { length } = solid.positions;
  inStep.recycle(solid);
  drag(22);
  expect(asked().at(-1)?.spare?.positions.length).toBe(length);
  // They travel: nobody else writes to them.
  expect(solid.positions.length).toBe(0);
});

/** So many pots beside each other, and a jar without a wall before them. */
function row(count: number): Design {
  const [pot, jar] = [POT.parts[0], JAR.parts[0]];
  if (!pot || !jar) throw new Error("both have a part");
  const pots = Array.from({ length: count }, (_, at) => ({ ...pot, place: { shift: [30 * at, 0, 0] as const } }));
  return { ...POT, parts: [{ ...jar, place: { shift: [0, 40, 0] } }, ...pots] };
}

const tilted = (design: Design, part: number, angle: number) =>
  setPath(design, ["parts", part, "place"], { ...design.parts[part]?.place, axis: [1, 0, 0], angle });

test("of a scene whose walls stand on the stage only those of the part that changes are made", async () => {
  const scene = row(3);
  const { asked, making, parts, pieces, solved, stand, store } = await bench(scene);
  stand(scene);
  store.apply({ design: tilted(scene, 2, 0.3), undo: "merge", key: "tilt" });
  await solved();
  await making.answer();
  expect(asked()).toMatchObject([{ parts: [2] }]);
  expect(parts).toEqual([[2]]);
  const { groups, sides } = pieces[0]?.value?.solid ?? {};
  expect(groups?.length).toBeGreaterThan(0);
  expect(groups?.every((part, i) => i % 3 !== 2 || part === 2)).toBe(true);
  expect(sides).toEqual([null, "inside", "inside", "inside"]);
  // Where the walls stand of something else altogether, or of nothing, all are made.
  stand(POT);
  store.apply({ design: tilted(scene, 2, 0.4), undo: "merge", key: "tilt" });
  await solved();
  await making.answer();
  expect(asked().at(-1)?.parts).toBeNull();
  expect(new Set(pieces[1]?.value?.solid.groups.filter((_, i) => i % 3 === 2))).toEqual(new Set([1, 2, 3]));
});

test("a part without a wall changes no wall, and waits for none", async () => {
  const scene = row(2);
  const { asked, solved, stand, store, surface } = await bench(scene);
  stand(scene);
  const design = tilted(scene, 0, 0.3);
  store.apply({ design, undo: "merge", key: "tilt" });
  await solved();
  expect(asked()).toEqual([]);
  expect(surface.shown?.design).toBe(design);
});

test("what is refused of a part names it by its place in the whole scene", async () => {
  const scene = row(2);
  const { making, pieces, solved, stand, store } = await bench(scene);
  stand(scene);
  const wall = { thickness: 0.3, base: 30 };
  const design = setPath(tilted(scene, 2, 0.3), ["parts", 2, "wall"], wall);
  store.apply({ design, undo: "merge", key: "tilt" });
  await solved();
  await making.answer();
  expect(pieces).toMatchObject([{ value: null }]);
  expect(pieces[0]?.problem?.path).toMatch(/^parts\[2\]\.wall/);
});

test("water follows the hand in a few pots, all of which are made; in a scene of many it waits", async () => {
  for (const [count, expected] of [
    [3, { parts: null, fill: 0.5 }],
    [5, { parts: [2], fill: null }],
  ] as const) {
    const scene = row(count);
    const { asked, making, solved, stand, store } = await bench(scene);
    stand(scene);
    store.apply(setFill(store.state, 0.5));
    store.apply({ design: tilted(scene, 2, 0.3), undo: "merge", key: "tilt" });
    await solved();
    await making.answer();
    expect(asked()).toMatchObject([expected]);
    store.endGesture();
  }
});

test("nobody waits long for one wall among others", async () => {
  const scene = row(2);
  const { making, parts, solved, stand, store, surface, tick } = await bench(scene);
  stand(scene);
  const design = tilted(scene, 1, 0.3);
  store.apply({ design, undo: "merge", key: "tilt" });
  await solved();
  tick();
  await settled();
  expect(surface.shown?.design).toBe(design);
  await making.answer();
  // The hand still holds it: it comes after.
  expect(parts).toEqual([[1]]);
});
