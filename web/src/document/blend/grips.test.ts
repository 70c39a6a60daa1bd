import { expect, test } from "vitest";
import type { Blend } from "../types";
import { type Grip, gripNumbers, gripped, gripsOf } from "./grips";
import { refigured, reformed } from "./section";

const ROUND: Blend = {
  kind: "blend",
  start: { form: "disc", radius: [4, 3], z: 0, taper: 0.5, dz: 8 },
  end: refigured({ form: "disc", radius: [5, 2], z: 10, taper: -0.2, dz: 6 }, { turn: 30, middle: [1, 0.5] }),
};

const find = (blend: Blend, { end, name }: Pick<Grip, "end" | "name">) =>
  gripsOf(blend).find((grip) => grip.end === end && grip.name === name);

test("a grip goes where the hand goes, and changes no number but its own", () => {
  for (const grip of gripsOf(ROUND)) {
    for (const [index, along] of grip.along.entries()) {
      const step = 0.01;
      const amounts = grip.along.map((_, at) => (at === index ? step : 0));
      const moved = {
        ...ROUND,
        [grip.end]: gripped(
          ROUND[grip.end],
          grip.name,
          amounts.map((each) => 100 * each),
        ),
      };
      const there = find(moved, grip);
      for (const axis of [0, 1, 2] as const) {
        const expected = grip.at[axis] + along[axis];
        // What turns goes round: a degree is nearly straight.
        expect(there?.at[axis]).toBeCloseTo(expected, grip.name === "turn" ? 2 : 3);
      }
      for (const other of gripsOf(ROUND)) {
        if (other.end === grip.end && other.name === grip.name) continue;
        const [before, after] = [ROUND, moved].map((blend) => gripNumbers(blend[other.end], other.name));
        expect(after?.map((each) => Number(each.toFixed(6)))).toEqual(before?.map((each) => Number(each.toFixed(6))));
      }
    }
  }
});

test("what is not closed round cannot be turned, and a size never comes to nothing", () => {
  const box: Blend = { ...ROUND, start: reformed(ROUND.start, "rectangle") };
  expect(find(box, { end: "start", name: "turn" })).toBeUndefined();
  expect(find(box, { end: "end", name: "turn" })).toBeDefined();
  expect(gripNumbers(gripped(ROUND.start, "width", [-100]), "width")[0]).toBeCloseTo(0.04, 8);
});
