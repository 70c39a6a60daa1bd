import { expect, test } from "vitest";
import { shelfOf } from "../../testing/surroundings";
import { allWork, keepWork, type Work } from "../state/storage";
import { type Claim, Seat } from "./seat";

const work = (text: string, unsaved = true): Work => ({ text, link: "", unsaved });

/** A browser with tabs; each has storage of its own, which a copy begins with. */
function browser(knows = true) {
  const shelf = shelfOf(new Map());
  const open = new Set<string>();
  const enter = async (linked = false, own = new Map<string, string>()) => {
    const held = new Set<string>();
    const claim: Claim = async (tab) => {
      if (!knows) return null;
      if (open.has(tab)) return false;
      open.add(tab);
      held.add(tab);
      return true;
    };
    const seat = new Seat(shelf, shelfOf(own), claim);
    const found = await seat.take(linked);
    return {
      seat,
      own,
      found: found?.text ?? null,
      keep: (text: string, at: number, unsaved = true) => keepWork(shelf, seat.name, work(text, unsaved), at),
      leave: () => {
        for (const tab of held) open.delete(tab);
      },
    };
  };
  return { enter, shelf, texts: () => allWork(shelf).map(({ work: { text } }) => text) };
}

test("two tabs keep two works, and each finds its own after a reload", async () => {
  const { enter, texts } = browser();
  const [a, b] = [await enter(), await enter()];
  expect([a.found, b.found]).toEqual([null, null]);
  a.keep("a", 1);
  b.keep("b", 2);
  a.keep("a again", 3);
  expect(texts()).toEqual(["a again", "b"]);
  for (const [tab, text] of [
    [a, "a again"],
    [b, "b"],
  ] as const) {
    tab.leave();
    expect((await enter(false, tab.own)).found).toBe(text);
  }
});

test("a new tab goes on with the newest work of the closed ones, and leaves the others where they are", async () => {
  const { enter, texts } = browser();
  const [a, b, c] = [await enter(), await enter(), await enter()];
  a.keep("a", 1);
  b.keep("b", 2);
  c.keep("c", 3);
  a.leave();
  b.leave();
  const d = await enter();
  expect(d.found).toBe("b");
  d.keep("d", 4);
  expect(texts()).toEqual(["d", "c", "a"]);
  expect((await enter()).found).toBe("a");
  expect((await enter()).found).toBeNull();
});

test("a tab that is duplicated begins with the same work and keeps it elsewhere", async () => {
  const { enter, texts } = browser();
  const a = await enter();
  a.keep("a", 1);
  const copy = await enter(false, new Map(a.own));
  expect(copy.found).toBe("a");
  expect(copy.seat.name).not.toBe(a.seat.name);
  copy.keep("copy", 2);
  expect(texts()).toEqual(["copy", "a"]);
});

test("a tab that is opened by a link takes nobody's work, and it stays where it is", async () => {
  const { enter, texts } = browser();
  const a = await enter();
  a.keep("a", 1);
  a.leave();
  const b = await enter(true);
  expect(b.found).toBeNull();
  b.keep("b", 2);
  expect(texts()).toEqual(["b", "a"]);
});

test("where nobody knows who is open, a new tab goes on with a copy", async () => {
  const { enter, texts } = browser(false);
  const a = await enter();
  a.keep("a", 1);
  const b = await enter();
  expect(b.found).toBe("a");
  b.keep("b", 2);
  expect(texts()).toEqual(["b", "a"]);
  expect((await enter(false, a.own)).found).toBe("a");
});
