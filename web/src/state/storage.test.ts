import { expect, test } from "vitest";
import { shelfOf } from "../../testing/surroundings";
import { NEW_SESSION } from "./session";
import {
  allWork,
  forgetOldWork,
  forgetWork,
  KEPT,
  keepSettings,
  keepWork,
  readSettings,
  readWork,
  type Shelf,
} from "./storage";

const shelf = () => shelfOf(new Map());

const BROKEN: Shelf = {
  getItem: () => {
    throw new Error("denied");
  },
  setItem: () => {
    throw new Error("full");
  },
  removeItem: () => {
    throw new Error("denied");
  },
  key: () => {
    throw new Error("denied");
  },
  length: 1,
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
    allowance: 35,
  } as const;
  expect(keepSettings(place, session)).toBe(true);
  expect(readSettings(place)).toEqual({ ...NEW_SESSION, theme: "dark", tab: "look", explain: true, allowance: 35 });
});

test("nonsense on the shelf is the default, field by field", () => {
  const place = shelf();
  place.setItem(
    "pasu.settings",
    JSON.stringify({
      theme: "pink",
      tab: "equation",
      overlays: { axes: true, isoU: 7, cut: true },
      unlocked: [1, "t"],
      export: { format: "exe", shrinkage: 12.5 },
      allowance: 200,
    }),
  );
  expect(readSettings(place)).toEqual({
    ...NEW_SESSION,
    tab: "equation",
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
  keepWork(place, "a", work);
  expect(readWork(place, "a")).toEqual(work);
  expect(readWork(place, "b")).toBeNull();
  place.setItem("pasu.work.a", JSON.stringify({ text: "{}" }));
  expect(readWork(place, "a")).toBeNull();
});

test("every tab's work is found, the newest first, that of the time before tabs had names among it", () => {
  const place = shelf();
  const work = { text: "{}", link: "", unsaved: true };
  place.setItem("pasu.work", JSON.stringify(work));
  place.setItem("pasu.work.broken", "{");
  place.setItem("pasu.tab", "x");
  keepWork(place, "a", work, 1000);
  keepWork(place, "b", work, 3000);
  keepWork(place, "c", work, 2000);
  const tabs = () => allWork(place).map(({ tab }) => tab);
  expect(tabs()).toEqual(["b", "c", "a", "old"]);
  expect(allWork(place).at(-1)?.work).toEqual(work);
  forgetWork(place, "c");
  forgetWork(place, "old");
  expect(tabs()).toEqual(["b", "a"]);
});

test("old works are forgotten where they are somewhere else too, and never where they are not", () => {
  const place = shelf();
  for (let at = 1; at <= 30; at += 1) keepWork(place, `${at}`, { text: "{}", link: "", unsaved: at % 2 === 0 }, at);
  forgetOldWork(place);
  const left = allWork(place);
  expect(left.filter(({ work }) => work.unsaved)).toHaveLength(15);
  expect(left.flatMap(({ at, work }) => (work.unsaved ? [] : [at]))).toEqual([
    29, 27, 25, 23, 21, 19, 17, 15, 13, 11, 9, 7,
  ]);
});

test("a browser without storage costs nothing but the convenience", () => {
  for (const place of [BROKEN, null]) {
    expect(readWork(place, "a")).toBeNull();
    expect(allWork(place)).toEqual([]);
    expect(() => forgetWork(place, "a")).not.toThrow();
    expect(readSettings(place)).toEqual(NEW_SESSION);
    expect(keepWork(place, "a", { text: "", link: "", unsaved: false })).toBe(false);
  }
});
