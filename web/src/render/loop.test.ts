import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Loop } from "./loop";

/** Animation frames by hand: `frame()` runs what was asked for. */
let asked: ((now: number) => void) | null = null;
let clock = 0;

function frame(): boolean {
  const run = asked;
  asked = null;
  clock += 16;
  run?.(clock);
  return run !== null;
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("requestAnimationFrame", (run: (now: number) => void) => {
    asked = run;
    return 1;
  });
  vi.stubGlobal("cancelAnimationFrame", () => {
    asked = null;
  });
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  asked = null;
});

it("draws once for any number of changes, and then stops", () => {
  const draw = vi.fn(() => false);
  const loop = new Loop(draw);
  expect(frame()).toBe(false);
  loop.invalidate();
  loop.invalidate();
  expect(frame()).toBe(true);
  expect(frame()).toBe(false);
  expect(draw).toHaveBeenCalledTimes(1);
  expect(loop.pending).toBe(false);
});

it("goes on while there is motion, with the time that passed", () => {
  const seconds: number[] = [];
  const loop = new Loop((passed) => seconds.push(passed) < 4);
  loop.invalidate();
  while (frame());
  expect(seconds).toEqual([0, 0.016, 0.016, 0.016]);
});

it("tells when it is idle: at once at rest, else after the last frame and the late one", async () => {
  const loop = new Loop(() => false);
  await loop.whenIdle();
  let idle = false;
  loop.invalidate();
  loop.later(100);
  void loop.whenIdle().then(() => {
    idle = true;
  });
  frame();
  await vi.advanceTimersByTimeAsync(99);
  expect(idle).toBe(false);
  await vi.advanceTimersByTimeAsync(2);
  frame();
  await vi.advanceTimersByTimeAsync(0);
  expect(idle).toBe(true);
});

it("keeps what was asked for while it is held back", () => {
  const draw = vi.fn(() => false);
  const loop = new Loop(draw);
  loop.invalidate();
  loop.pause();
  expect(frame()).toBe(false);
  loop.invalidate();
  expect(frame()).toBe(false);
  loop.resume();
  expect(frame()).toBe(true);
  expect(draw).toHaveBeenCalledTimes(1);
});
