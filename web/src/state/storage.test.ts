import { expect, test } from "vitest";
import { NEW_SESSION } from "./session";
import { KEPT, keepSettings, keepWork, readSettings, readWork, type Shelf } from "./storage";

function shelf(): Shelf & { readonly map: Map<string, string> } {
  const map = new Map<string, string>();
  return { map, getItem: (key) => map.get(key) ?? null, setItem: (key, value) => void map.set(key, value) };
}

const BROKEN: Shelf = {
  getItem: () => {
    throw new Error("denied");
  },
  setItem: () => {
    throw new Error("full");
  },
};

test("every piece of state says where it is kept", () => {
  expect(Object.keys(KEPT).sort()).toEqual(["design", ...Object.keys(NEW_SESSION)].sort());
});

test("settings come back, and only those that are kept in the browser", () => {
  const place = shelf();
  const session = {
    ...NEW_SESSION,
    theme: "dark",
    selection: [3],
    compare: "mixed-order",
    tab: "look",
    explain: true,
  } as const;
  expect(keepSettings(place, session)).toBe(true);
  expect(readSettings(place)).toEqual({ ...NEW_SESSION, theme: "dark", tab: "look", explain: true });
});

test("nonsense on the shelf is the default, field by field", () => {
  const place = shelf();
  place.setItem(
    "pasu.settings",
    JSON.stringify({
      theme: "pink",
      tab: "order",
      overlays: { axes: true, isoU: 7, cut: true },
      unlocked: [1, "t"],
      export: { format: "exe", shrinkage: 12.5 },
    }),
  );
  expect(readSettings(place)).toEqual({
    ...NEW_SESSION,
    tab: "order",
    overlays: { ...NEW_SESSION.overlays, axes: true },
    unlocked: ["t"],
    export: { format: "3mf", shrinkage: 12.5 },
  });
  place.setItem("pasu.settings", "{");
  expect(readSettings(place)).toEqual(NEW_SESSION);
});

test("work comes back whole or not at all", () => {
  const place = shelf();
  const work = { text: "{}", link: "1/second-order", unsaved: true };
  keepWork(place, work);
  expect(readWork(place)).toEqual(work);
  place.setItem("pasu.work", JSON.stringify({ text: "{}" }));
  expect(readWork(place)).toBeNull();
});

test("a browser without storage costs nothing but the convenience", () => {
  for (const place of [BROKEN, null]) {
    expect(readWork(place)).toBeNull();
    expect(readSettings(place)).toEqual(NEW_SESSION);
    expect(keepWork(place, { text: "", link: "", unsaved: false })).toBe(false);
  }
});
