import { signal } from "@preact/signals-core";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { BETWEEN, BUSY, Unhurried } from "./unhurried";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function hand(holds: boolean) {
  const held = signal(holds);
  return {
    held,
    store: {
      get inGesture() {
        return held.value;
      },
    },
  };
}

test("at rest every change is drawn at once", async () => {
  const { store } = hand(false);
  const unhurried = new Unhurried();
  await unhurried.turn(store);
  await unhurried.turn(store);
  expect(vi.getTimerCount()).toBe(0);
});

test("under the hand the first is drawn a while after it began, and the next one as long after that", async () => {
  const { held, store } = hand(true);
  const unhurried = new Unhurried();
  for (let drag = 0; drag < 2; drag += 1) {
    held.value = true;
    for (let drawing = 0; drawing < 2; drawing += 1) {
      const drawn = vi.fn();
      void unhurried.turn(store).then(drawn);
      await vi.advanceTimersByTimeAsync(BETWEEN - 1);
      expect(drawn).not.toHaveBeenCalled();
      await vi.advanceTimersByTimeAsync(1);
      expect(drawn).toHaveBeenCalledOnce();
    }
    held.value = false;
    await unhurried.turn(store);
  }
});

test("under the hand it waits for a page that draws pictures all the time, but not for long", async () => {
  const waits: number[] = [];
  vi.stubGlobal("requestIdleCallback", (done: () => void, { timeout }: IdleRequestOptions) => {
    waits.push(timeout ?? 0);
    setTimeout(done, timeout);
  });
  const { store } = hand(true);
  const drawn = vi.fn();
  void new Unhurried().turn(store).then(drawn);
  await vi.advanceTimersByTimeAsync(BETWEEN + BUSY - 1);
  expect([drawn.mock.calls.length, waits]).toEqual([0, [BUSY]]);
  await vi.advanceTimersByTimeAsync(1);
  expect(drawn).toHaveBeenCalledOnce();
  vi.unstubAllGlobals();
});

test("what waits is drawn once the picture is, when the hand lets go, and leaves no timer behind", async () => {
  const frames: FrameRequestCallback[] = [];
  vi.stubGlobal("requestAnimationFrame", (frame: FrameRequestCallback) => frames.push(frame));
  const { held, store } = hand(true);
  const unhurried = new Unhurried();
  const drawn = vi.fn();
  void unhurried.turn(store).then(drawn);
  held.value = false;
  await vi.advanceTimersByTimeAsync(BETWEEN);
  expect([drawn.mock.calls.length, frames.length]).toEqual([0, 1]);
  frames[0]?.(0);
  await vi.advanceTimersByTimeAsync(0);
  expect(drawn).toHaveBeenCalledOnce();
  expect(vi.getTimerCount()).toBe(0);
  vi.unstubAllGlobals();
});
