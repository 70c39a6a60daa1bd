import { expect, it } from "vitest";
import { Resolution } from "./resolution";

it("draws finely at rest, whatever was learnt", () => {
  const resolution = new Resolution();
  for (let i = 0; i < 100; i++) resolution.learn(300);
  expect(resolution.next(2, false)).toEqual({ ratio: 2, samples: 4 });
  expect(resolution.next(3, false).ratio).toBe(2);
});

it("gets coarser in slow motion and finer again in quick motion", () => {
  const resolution = new Resolution();
  const first = resolution.next(2, true);
  for (let i = 0; i < 100; i++) resolution.learn(100);
  const slow = resolution.next(2, true);
  expect(slow.ratio).toBeLessThan(first.ratio);
  expect(slow.ratio).toBeGreaterThanOrEqual(0.5);
  for (let i = 0; i < 1000; i++) resolution.learn(8);
  expect(resolution.next(2, true)).toEqual({ ratio: 2, samples: 4 });
});

it("does not change for one slow frame", () => {
  const resolution = new Resolution();
  const before = resolution.next(1, true);
  resolution.learn(500);
  resolution.learn(16);
  resolution.learn(500);
  expect(resolution.next(1, true)).toEqual(before);
});
