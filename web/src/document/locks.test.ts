import { expect, test } from "vitest";
import { BOTTLE } from "../../testing/bottle";
import { realMaker } from "../../testing/real-maker";
import { NEW_BRUSH } from "./brush";
import { keptBy, LOCKS, locksOf, withLock } from "./locks";
import { getPath } from "./path";
import { familyOf } from "./schema";

const FAMILIES = (["second-order", "mixed-order", "fourth-order", "bloor-wilson"] as const).map((kind) => {
  const family = familyOf(kind);
  if (!family) throw new Error(kind);
  return family;
});

test("a lock is put on and taken off, in the order in which they stand", () => {
  expect(withLock(withLock([], "height", true), "rim", true)).toEqual(["rim", "height"]);
  expect(withLock(["rim", "height"], "rim", false)).toEqual(["height"]);
});

test("every family has a rim, a foot and a height to lock, and rings have none", () => {
  for (const { reset } of FAMILIES) expect(locksOf(reset)).toEqual(LOCKS);
  expect(locksOf(BOTTLE)).toEqual([]);
  expect(keptBy(BOTTLE, LOCKS)).toEqual([]);
});

test.each(FAMILIES.map((family) => [family.kind, family] as const))(
  "what is locked of %s stays to the bit while a hand pulls, and the rest follows",
  async (_, family) => {
    const { maker } = realMaker({ free: true });
    for (const lock of LOCKS) {
      const outcome = await maker.ask({
        kind: "pull",
        shape: family.reset,
        at: [0.4, 0.3],
        by: { out: 0.2, up: 0.1, round: 0 },
        brush: NEW_BRUSH,
        keep: keptBy(family.reset, [lock]),
      });
      if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
      const { shape } = outcome.value;
      expect(shape).not.toEqual(family.reset);
      for (const field of family.fields) {
        const [before, after] = [family.reset, shape].map((each) => getPath(each, field.path));
        if (field.group === lock) expect(after ?? before, `${lock} ${field.key}`).toBe(before ?? after);
      }
    }
  },
);
