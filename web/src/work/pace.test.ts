import { expect, it } from "vitest";
import { designOf } from "../document/gallery/exhibit";
import { FIRST } from "../document/gallery/first";
import { COARSEST, gridFor } from "./grid";
import { Pace } from "./pace";

/** Lets a pace learn the same cost so many times. */
function learn(pace: Pace, times: number, milliseconds: number, coarsest = true): number {
  for (let i = 0; i < times; i++) pace.learn(milliseconds, coarsest);
  return pace.step;
}

it("gets to the grid at rest where changes are quick", () => {
  expect(learn(new Pace(), 100, 5)).toBe(0);
});

it("gets coarser where they are slow, but pixels first", () => {
  const pace = new Pace();
  const first = pace.step;
  expect(learn(pace, 100, 90, false)).toBe(first);
  expect(learn(pace, 2, 90)).toBe(first + 1);
  expect(learn(pace, 100, 90)).toBe(COARSEST);
});

it("does not change for one slow change, nor where changes are neither slow nor quick", () => {
  const pace = new Pace();
  const first = pace.step;
  for (let i = 0; i < 20; i++) {
    learn(pace, 1, 500);
    learn(pace, 1, 20);
  }
  expect(learn(pace, 1000, 25)).toBe(first);
});

it("does not go to and fro between a grid that is too fine and one that is quick", () => {
  const pace = new Pace();
  let changes = 0;
  let before = pace.step;
  for (let i = 0; i < 2000; i++) {
    // Step 1 and finer are slow on this machine, step 2 is quick.
    pace.learn(pace.step < 2 ? 60 : 8, true);
    if (pace.step !== before) changes += 1;
    before = pace.step;
  }
  expect(changes).toBeLessThan(20);
});

it("has grids on which the lines of the overlays stand still", () => {
  const design = designOf(FIRST);
  let last = Infinity;
  for (let step = 0; step <= COARSEST; step++) {
    const { rows, columns } = gridFor(design, step);
    expect((rows - 1) % 12).toBe(0);
    expect((columns - 1) % 24).toBe(0);
    expect(rows * columns).toBeLessThan(last);
    last = rows * columns;
  }
});
