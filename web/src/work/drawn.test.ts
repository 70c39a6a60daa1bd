import { expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import { realMaker } from "../../testing/real-maker";
import { realSolver } from "../../testing/real-solver";
import type { Design } from "../document/types";
import { NEW_SESSION } from "../state/session";
import { Store } from "../state/store";
import { drawnOf, drawnPot, redraw } from "./drawn";

/** The right side of a cone. */
const RIGHT = [4, 0, 6, 10];

test("rings are found, and seen from the side where they are", async () => {
  const { maker } = realMaker({ free: true });
  const drawn = await drawnOf(maker, realSolver({ free: true }).solver, { right: RIGHT, left: [4, 0, 8, 10] }, 0.05);
  if (drawn.state !== "done") throw new Error(JSON.stringify(drawn));
  const { right, left, rings, shape, distance } = drawn.value;
  expect(distance).toBeLessThanOrEqual(0.05);
  expect(rings).toHaveLength(shape.rings.length);
  const ends = [right[0], right.at(-1), left[0], left.at(-1)];
  const wanted = [
    [4, 0],
    [6, 10],
    [-4, 0],
    [-8, 10],
  ] as const;
  wanted.forEach(([across, up], i) => {
    expect(ends[i]?.[0]).toBeCloseTo(across, 1);
    expect(ends[i]?.[1]).toBeCloseTo(up, 1);
  });
  expect(rings[0]?.map(([across]) => Math.round(across))).toEqual([4, -4]);
});

test("what is no line is refused", async () => {
  const { maker } = realMaker({ free: true });
  const refused = await drawnOf(maker, realSolver({ free: true }).solver, { right: [1, 2] }, 0.05);
  expect(refused).toMatchObject({ state: "refused", refusal: { path: "right" } });
});

test("a new pot has a wall that suits its height, in its unit, and can be made", async () => {
  const pot = drawnPot(BOTTLE, 200, "mm");
  expect(pot).toMatchObject({ unit: "mm", parts: [{ wall: { thickness: 4, base: 5 } }] });
  const { maker } = realMaker({ free: true });
  const report = await maker.ask({ kind: "check", design: drawnPot(BOTTLE, 20, "cm"), making: { craft: "clay" } });
  expect(report.state === "done" && report.value.ok).toBe(true);
  expect(drawnPot(BOTTLE, 20, "cm").unit).toBeUndefined();
});

test("in the place of a part only its shape changes, and what stretched it", () => {
  const parts: Design["parts"] = [
    { shape: BOTTLE },
    { name: "lid", shape: BOTTLE, place: { scale: [2, 2, 2], shift: [1, 0, 0] }, look: { glaze: "cobalt" } },
  ];
  const store = new Store({ pasu: 1, parts }, NEW_SESSION);
  store.apply({ undo: "none", session: { selection: [store.ids[1] ?? 0] } });
  const shape = { ...BOTTLE, a: 2 };
  store.apply(redraw(store.state, shape));
  expect(store.design.parts[0]).toBe(parts[0]);
  expect(store.design.parts[1]).toEqual({ name: "lid", shape, place: { shift: [1, 0, 0] }, look: { glaze: "cobalt" } });
  store.undo();
  expect(store.design.parts).toEqual(parts);
});
