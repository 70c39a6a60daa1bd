import { expect, test } from "vitest";
import { workbench } from "../../testing/workbench";
import { GLUED } from "../document/gallery/scenes";
import { ringed } from "../document/ringed";
import type { Design, Part } from "../document/types";
import { selectParts } from "../state/seen-actions";
import { lockParts } from "../state/several-actions";
import type { Designer } from "./designer";
import { Made } from "./made";
import { pushOnto } from "./pushing";

const [MUG, HANDLE] = (GLUED.find(({ id }) => id === "own-glued-mug")?.parts ?? []) as [Part, Part];

/** The mug of the gallery, its handle an object of its own and elsewhere. */
const LOOSE: Design = {
  pasu: 1,
  parts: [MUG, { ...HANDLE, object: 1, place: { ...HANDLE.place, shift: [4, 0, 0] } }],
};

async function bench(design: Design) {
  const there = await workbench(design);
  const { store, surface, maker, making } = there;
  const made = new Made(store, surface, maker, () => () => {});
  made.connect();
  await making.finish();
  const designer = {
    apply: (change: Parameters<typeof store.apply>[0]) => {
      store.apply(change);
      store.endGesture();
    },
    made,
    openMade: async () => made,
    surface,
    get state() {
      return store.state;
    },
  } as unknown as Designer;
  const push = async (course: "sideways" | "upright") => {
    const pushed = pushOnto(designer, course);
    await making.finish();
    return pushed;
  };
  return { ...there, made, push };
}

test("both ends of a handle come into the wall of a mug, which it is glued to by the same step", async () => {
  const { made, making, push, rests, store } = await bench(LOOSE);
  const [mug = 0, handle = 0] = store.ids;
  store.apply(selectParts(handle, mug));
  expect(await push("sideways")).toBe("set");
  const [, put] = store.design.parts;
  expect(put?.object ?? 0).toBe(MUG.object ?? 0);
  const [x = 0, y = 0, z = 0] = put?.place?.shift ?? [];
  // Where the gallery has it: there its ends stand in the middle of the wall.
  expect(Math.abs(x)).toBeLessThan(0.25);
  expect([Math.abs(y), z]).toEqual([expect.closeTo(0, 6), 0]);
  await rests();
  await making.finish();
  expect(made.constraints.value?.isKept).toBe(true);
  store.undo();
  expect(store.design).toEqual(LOOSE);
});

test("what is locked, alone or not in the way stays", async () => {
  const { making, push, rests, store } = await bench(LOOSE);
  const [mug = 0, handle = 0] = store.ids;
  store.apply(selectParts(mug));
  expect(await push("sideways")).toBe("nowhere");
  store.apply(selectParts(handle, mug));
  store.apply(lockParts(store.state, [handle], true));
  expect(await push("sideways")).toBe("nowhere");
  store.apply(lockParts(store.state, [handle], false));
  const aside: Design = { ...LOOSE, parts: [MUG, { ...HANDLE, object: 1, place: { shift: [60, 60, 0] } }] };
  store.apply({ design: aside, undo: "step" });
  await rests();
  await making.finish();
  expect(await push("upright")).toBe("nowhere");
  expect(store.design).toEqual(aside);
});

test("two cups of one kind on one table are pushed together, though their rims and feet are in one plane", async () => {
  const shape = ringed([2, 3, 3.2], [0, 3, 6]);
  const wall = { thickness: 0.4, base: 0.5 };
  const cups: Design = {
    pasu: 1,
    parts: [
      { shape, wall },
      { shape, wall, object: 1, place: { shift: [10, 4, 0] } },
    ],
  };
  const { made, making, push, rests, store } = await bench(cups);
  const [first = 0, second = 0] = store.ids;
  store.apply(selectParts(second, first));
  // Their walls bend away from each other: not all of what faces comes into the clay.
  expect(await push("sideways")).toBe("partly");
  const [x = 0, y = 0, z = 0] = store.design.parts[1]?.place?.shift ?? [];
  const far = Math.hypot(x, y);
  expect(z).toBe(0);
  expect(far).toBeLessThan(6.4);
  expect(far).toBeGreaterThan(6.4 - 2 * 0.4);
  await rests();
  await making.finish();
  expect(made.constraints.value?.isKept).toBe(true);
});
