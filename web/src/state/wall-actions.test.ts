import { expect, test } from "vitest";
import { JAR } from "../../testing/jar";
import { NEW_SESSION } from "./session";
import { Store } from "./store";
import { setLining, setPot, setSide } from "./wall-actions";

const pot = () => {
  const store = new Store(JAR, NEW_SESSION);
  store.apply(setPot(store.state, true, 10));
  return store;
};
const wallOf = (store: Store) => store.design.parts[0]?.wall;

test("an inside of its own is chosen and left again, each in one step", () => {
  const store = pot();
  const before = wallOf(store);
  store.apply(setLining(store.state, 0));
  expect(wallOf(store)).toEqual({ ...before, lining: {} });
  expect(setLining(store.state, 0).undo).toBe("none");
  store.apply(setLining(store.state, 3));
  expect(wallOf(store)?.lining).toEqual({ waves: 3 });
  store.apply(setLining(store.state, null));
  expect(wallOf(store)).toEqual(before);
  expect("lining" in (wallOf(store) ?? {})).toBe(false);
  store.undo();
  expect(wallOf(store)?.lining).toEqual({ waves: 3 });
});

test("one drag of its waves is one step", () => {
  const store = pot();
  store.apply(setLining(store.state, 3));
  for (const waves of [4, 5, 6]) store.apply(setLining(store.state, waves, true));
  store.endGesture();
  store.undo();
  expect(wallOf(store)?.lining).toEqual({ waves: 3 });
});

test("clay that is laid outwards has no other inside", () => {
  const store = pot();
  store.apply(setLining(store.state, 0));
  store.apply(setSide(store.state, "outside"));
  expect(wallOf(store)?.lining).toBeUndefined();
  store.undo();
  expect(wallOf(store)?.lining).toEqual({});
});
