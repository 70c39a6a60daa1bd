import { describe, expect, it } from "vitest";
import { Damper } from "./damper";

/** Steps until the motion ends and returns how many frames that took. */
function run(damper: Damper, seconds: number): number {
  for (let frame = 1; frame < 100_000; frame++) if (!damper.step(seconds)) return frame;
  throw new Error("the motion does not end");
}

describe("Damper", () => {
  it("ends, exactly at its goal, at every frame rate", () => {
    for (const seconds of [1 / 1000, 1 / 240, 1 / 60, 1 / 10, 5]) {
      for (const goal of [1, -3, 1e-9, 1e6]) {
        const damper = new Damper(0, 2e-4, 0.1);
        damper.goal = goal;
        run(damper, seconds);
        expect(damper.value).toBe(goal);
        expect(damper.moving).toBe(false);
      }
    }
  });

  it("does not overshoot from rest", () => {
    const damper = new Damper(0, 1e-6, 0.1);
    damper.goal = 1;
    let before = 0;
    while (damper.step(1 / 60)) {
      expect(damper.value).toBeGreaterThanOrEqual(before);
      expect(damper.value).toBeLessThanOrEqual(1);
      before = damper.value;
    }
  });

  it("moves the same way whatever the frames", () => {
    const coarse = new Damper(0, 1e-9, 0.1);
    const fine = new Damper(0, 1e-9, 0.1);
    coarse.goal = fine.goal = 2;
    coarse.step(0.08);
    for (let i = 0; i < 80; i++) fine.step(0.001);
    expect(fine.value).toBeCloseTo(coarse.value, 10);
  });

  it("stands still on a clock that stands still or goes back, and ends all the same", () => {
    const damper = new Damper(0, 1e-3, 0.1);
    damper.goal = 1;
    expect(damper.step(0)).toBe(true);
    expect(damper.step(-1)).toBe(true);
    expect(damper.step(Number.NaN)).toBe(true);
    expect(damper.value).toBe(0);
    run(damper, 1 / 60);
  });

  it("follows a goal that moves on its way", () => {
    const damper = new Damper(0, 1e-4, 0.05);
    for (let i = 1; i <= 50; i++) {
      damper.goal = i;
      damper.step(1 / 60);
    }
    run(damper, 1 / 60);
    expect(damper.value).toBe(50);
  });
});
