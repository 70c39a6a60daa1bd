import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { familyOf } from "../document/schema";
import type { Kind, Part, Shape } from "../document/types";
import { NEW_SESSION } from "../state/session";
import { Store } from "../state/store";
import { cannotWords } from "../words/freeing";
import { finenessOf, followedByHand, freed, takeFreed } from "./freeing";

function reset(kind: Kind): Shape {
  const family = familyOf(kind);
  if (!family) throw new Error(`${kind} is no family`);
  return family.reset;
}

const DINTED = reset("bloor-wilson");

/** A store whose second part is selected. */
function bench(shape: Shape) {
  const second: Part = { name: "dinted", shape, place: { shift: [9, 0, 0] }, look: { glaze: "celadon" } };
  const store = new Store({ pasu: 1, parts: [{ shape: reset("second-order") }, second] }, NEW_SESSION);
  store.apply({ undo: "none", session: { selection: [store.ids[1] ?? 0] } });
  return { store, maker: realMaker({ free: true }).maker };
}

test("a part becomes rings where it stands, as one step, and says how far it is off", async () => {
  const { store, maker } = bench(DINTED);
  const { design: before } = store;
  const found = await freed(maker, store, 0.01);
  if (found.state !== "done") throw new Error(JSON.stringify(found));
  expect(found.value.distance).toBeGreaterThan(0);
  expect(found.value.distance).toBeLessThanOrEqual(0.01);
  // Nothing has changed before somebody takes it.
  expect(store.design).toBe(before);
  expect(takeFreed(store, found.value)).toBe(true);
  const [first, second] = store.design.parts;
  expect(first).toBe(before.parts[0]);
  expect(second).toMatchObject({ name: "dinted", place: { shift: [9, 0, 0] }, look: { glaze: "celadon" } });
  expect(second?.shape.kind).toBe("rings");
  store.undo();
  expect(store.design).toBe(before);
  expect(store.canUndo).toBe(false);
});

test("what was found for another form than there is now is not taken", async () => {
  const { store, maker } = bench(DINTED);
  const found = await freed(maker, store, 0.01);
  if (found.state !== "done") throw new Error(JSON.stringify(found));
  const parts = store.design.parts.map((part) => ({ ...part, shape: { ...part.shape } }));
  store.apply({ design: { ...store.design, parts }, undo: "step" });
  const { design } = store;
  expect(takeFreed(store, found.value)).toBe(false);
  expect(store.design).toBe(design);
});

test("what cannot be made of rings says why", async () => {
  // Five and a half petals leave it open.
  const { store, maker } = bench({ ...DINTED, n1: 5.5 } as Shape);
  const open = await freed(maker, store, 0.01);
  if (open.state !== "refused") throw new Error(JSON.stringify(open));
  expect(cannotWords(open.refusal, "cm")).toBe("This cannot be made of rings: its wall does not close round the axis.");
  const fine = await freed(maker, bench(DINTED).store, 1e-14);
  if (fine.state !== "refused") throw new Error(JSON.stringify(fine));
  expect(cannotWords(fine.refusal, "mm")).toMatch(
    /^More rings than are possible would be needed for that\. .+mm off at most/,
  );
});

test("a round number about as small as what nobody sees", () => {
  expect([25, 20, 19.9, 9, 1, 230, 2e-5].map(finenessOf)).toEqual([0.02, 0.02, 0.01, 0.005, 0.001, 0.2, 2e-8]);
  expect(finenessOf(0)).toBe(0.001);
  expect(followedByHand(20)).toBe(0.1);
});
