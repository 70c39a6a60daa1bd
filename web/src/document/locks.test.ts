import { expect, test } from "vitest";
import { BOTTLE, WRITTEN } from "../../testing/bottle";
import { realMaker } from "../../testing/real-maker";
import { NEW_BRUSH } from "./brush";
import { keptBy, LOCKS, locksOf, makingUp, withLock } from "./locks";
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

test("every family has a rim, a foot and a height to lock, rings their slopes too, and with a wall what they hold", () => {
  for (const { reset } of FAMILIES) expect(locksOf(reset, true)).toEqual(LOCKS);
  expect(locksOf(BOTTLE, false)).toEqual([...LOCKS, "slopes"]);
  expect(locksOf(BOTTLE, true)).toEqual([...LOCKS, "slopes", "capacity"]);
  expect(locksOf(WRITTEN, true)).toEqual([...LOCKS, "slopes"]);
});

test("of rings an end stays where it is locked, as high as it is where the height is, and others as they are", () => {
  expect(keptBy(BOTTLE, ["foot"], 0)).toEqual(["r", "z", "v"]);
  expect(keptBy(BOTTLE, ["foot", "height"], 1)).toEqual(["z"]);
  expect(keptBy(BOTTLE, ["rim"], 0.995)).toEqual(["r", "z", "v"]);
  expect(keptBy(BOTTLE, LOCKS, 0.35)).toEqual([]);
  expect(keptBy(BOTTLE, ["slopes"], 0.35)).toEqual(["slopes"]);
  expect(keptBy(BOTTLE, ["rim", "slopes"], 1)).toEqual(["r", "z", "v", "slopes"]);
});

test("of data that are written out the lower end is the foot, whichever comes first", () => {
  expect(keptBy(WRITTEN, ["foot"], 0)).toEqual(["x", "y", "z"]);
  expect(keptBy(WRITTEN, ["rim"], 0)).toEqual([]);
  expect(keptBy(WRITTEN, ["height"], 1)).toEqual(["z"]);
  expect(keptBy(WRITTEN, LOCKS, 0.35)).toEqual([]);
  const mode = { n: 0, cos: { start: 20, end: 0, rings: [15, 6] } };
  const turned = { ...WRITTEN, z: { ...WRITTEN.z, modes: [mode] } };
  expect(keptBy(turned, ["foot"], 0)).toEqual([]);
  expect(keptBy(turned, ["foot"], 1)).toEqual(["x", "y", "z"]);
});

test("what a pot holds is made up for by its height, or by the width of rings that neither a hand nor a lock is on", () => {
  expect(makingUp(BOTTLE, ["foot", "capacity"], 0.35)).toEqual({ along: "z", rings: [1, 2, 3] });
  expect(makingUp(BOTTLE, ["height", "capacity"], 0.35)).toEqual({ along: "r", rings: [0, 2, 3] });
  expect(makingUp(BOTTLE, ["rim", "foot", "capacity"], 0.35)).toEqual({ along: "r", rings: [2] });
  expect(makingUp(BOTTLE, ["rim", "capacity"], 0.5)).toEqual({ along: "r", rings: [0, 1, 2] });
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
        keep: keptBy(family.reset, [lock], 0.4),
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
