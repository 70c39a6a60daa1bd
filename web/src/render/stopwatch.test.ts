import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Stopwatch } from "./stopwatch";

/** A GPU that passes its fences when told to. */
function gpu() {
  const fences = new Set<object>();
  let passed = false;
  return {
    SYNC_GPU_COMMANDS_COMPLETE: 1,
    SYNC_STATUS: 2,
    SIGNALED: 3,
    fenceSync() {
      const fence = {};
      fences.add(fence);
      return fence;
    },
    flush() {},
    getSyncParameter: () => (passed ? 3 : 4),
    deleteSync: (fence: object) => fences.delete(fence),
    fences,
    pass(now: boolean) {
      passed = now;
    },
  };
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout", "performance"] });
});
afterEach(() => {
  vi.useRealTimers();
});

it("tells how long the GPU took, one frame at a time, and leaves no fence behind", () => {
  const gl = gpu();
  const told: number[] = [];
  const stopwatch = new Stopwatch(gl as unknown as WebGL2RenderingContext);
  stopwatch.measure(performance.now(), (milliseconds) => told.push(milliseconds));
  stopwatch.measure(performance.now(), () => told.push(-1));
  vi.advanceTimersByTime(30);
  expect(told).toEqual([]);
  gl.pass(true);
  vi.advanceTimersByTime(10);
  expect(told).toHaveLength(1);
  expect(told[0]).toBeGreaterThanOrEqual(30);
  expect(told[0]).toBeLessThan(40);
  expect(gl.fences.size).toBe(0);
  expect(vi.getTimerCount()).toBe(0);
});

it("gives up a frame that does not end, and one whose context went", () => {
  const gl = gpu();
  const told: number[] = [];
  const stopwatch = new Stopwatch(gl as unknown as WebGL2RenderingContext);
  stopwatch.measure(performance.now(), (milliseconds) => told.push(milliseconds));
  vi.advanceTimersByTime(5000);
  expect(gl.fences.size).toBe(0);
  stopwatch.measure(performance.now(), (milliseconds) => told.push(milliseconds));
  stopwatch.release();
  gl.pass(true);
  vi.advanceTimersByTime(5000);
  expect(told).toEqual([]);
  expect(gl.fences.size).toBe(0);
});
