import { expect, test } from "vitest";
import { JAR } from "../../testing/jar";
import { UNMOVED } from "../document/placement";
import { changePlace } from "./place-actions";
import { NEW_SESSION } from "./session";
import { Store } from "./store";

const fresh = () => new Store(JAR, NEW_SESSION);
const placeOf = (store: Store) => store.design.parts[0]?.place;

test("a part is moved, and as if it had never been when it is put back", () => {
  const store = fresh();
  store.apply(changePlace(store.state, (place) => ({ ...place, shift: [0, 0, 2] })));
  expect(placeOf(store)).toEqual({ ...UNMOVED, shift: [0, 0, 2] });
  store.apply(changePlace(store.state, (place) => ({ ...place, shift: [0, 0, 0] })));
  expect(placeOf(store)).toBe(undefined);
  expect("place" in (store.design.parts[0] ?? {})).toBe(false);
});

test("what changes nothing is no step, and one drag is one", () => {
  const store = fresh();
  expect(changePlace(store.state, (place) => ({ ...place, scale: [1, 1, 1] })).undo).toBe("none");
  for (const x of [1, 2, 3])
    store.apply(changePlace(store.state, (place) => ({ ...place, shift: [x, 0, 0] }), "shift-0"));
  store.endGesture();
  expect(placeOf(store)?.shift).toEqual([3, 0, 0]);
  store.undo();
  expect(placeOf(store)).toBe(undefined);
});
