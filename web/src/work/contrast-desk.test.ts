import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { workbench } from "../../testing/workbench";
import type { Design, Part } from "../document/types";
import { Contrast } from "./contrast";
import { contrastDesk } from "./contrast-desk";
import type { Designer } from "./designer";
import { Made } from "./made";

const block = (name: string, x: number): Part => ({
  name,
  shape: { kind: "octant", exponents: [4, 4, 4] },
  place: { shift: [x, 0, 0] },
});
const HERE: Design = { pasu: 1, parts: [block("Jar", 0), block("Cup", 1)] };
const THERE: Design = { pasu: 1, parts: [block("Jar", 0), block("Cup", 3)] };

async function bench() {
  const there = await workbench(HERE);
  const { maker, store, surface } = there;
  const made = new Made(store, surface, maker, () => () => {});
  const contrast = new Contrast();
  const designer = {
    contrast,
    openMade: async () => made,
    solver: there.solver,
    store,
    surface,
  } as unknown as Designer;
  const desk = contrastDesk(designer);
  /** As a component does, whenever something changes, until nothing more happens. */
  const rest = async () => {
    await there.rests();
    desk.follow();
    await settled();
    await there.making.finish();
    await there.solved();
  };
  return { ...there, contrast, desk, designer, rest };
}

test("the difference is told of both scenes as they are, and of no earlier one", async () => {
  const { contrast, desk, designer, making, rest, store } = await bench();
  await rest();
  expect([desk.told, desk.seen]).toEqual([null, null]);
  contrast.show(THERE);
  await rest();
  expect(desk.told?.difference).toMatchObject({ isSame: false, moved: [{ before: 1, after: 1 }] });
  expect(desk.seen?.solved.parts.map(({ box }) => Math.round(box?.min[0] ?? Number.NaN))).toEqual([0, 3]);
  // What is asked for is asked once.
  const count = making.sent.length;
  desk.follow();
  await rest();
  expect(making.sent.length).toBe(count);
  store.apply({ design: THERE, undo: "step" });
  expect(desk.told).toBeNull();
  await rest();
  expect(desk.told?.difference.isSame).toBe(true);
  expect(contrastDesk(designer)).toBe(desk);
  contrast.close();
  expect([desk.told, desk.seen]).toEqual([null, null]);
});

test("of two that are asked for the later is told, and what is refused says why", async () => {
  const { contrast, desk, making, rest, solved } = await bench();
  contrast.show(THERE);
  desk.follow();
  await settled();
  contrast.show(HERE);
  await rest();
  expect(desk.told).toMatchObject({ there: HERE, difference: { isSame: true } });
  const broken = {
    ...THERE,
    parts: [{ ...block("Jar", 0), shape: { kind: "octant", exponents: [0, 1, 1] } }],
  } as Design;
  contrast.show(broken);
  await rest();
  await making.finish();
  await solved();
  expect(desk.told).toBeNull();
  expect(desk.problem?.path).toBe("parts[0].shape.exponents[0]");
});
