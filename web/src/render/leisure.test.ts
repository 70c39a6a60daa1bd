import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Leisure } from "./leisure";

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

it("runs what is due one at a time, the longest due first", () => {
  const leisure = new Leisure();
  const ran: string[] = [];
  const [a, b, c] = ["a", "b", "c"].map((name) => () => {
    ran.push(name);
  }) as [() => void, () => void, () => void];
  leisure.after(100, a);
  leisure.after(90, b);
  leisure.after(100, c);
  expect([a, b, c].map((run) => leisure.has(run))).toEqual([true, true, true]);
  vi.advanceTimersByTime(89);
  expect(ran).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(ran).toEqual(["b"]);
  vi.advanceTimersByTime(19);
  expect(ran).toEqual(["b"]);
  vi.advanceTimersByTime(1);
  expect(ran).toEqual(["b", "a"]);
  vi.advanceTimersByTime(100);
  expect(ran).toEqual(["b", "a", "c"]);
  expect(leisure.has(c)).toBe(false);
});

it("waits anew when it is asked again, and forgets", () => {
  const leisure = new Leisure();
  const [run, other] = [vi.fn(), vi.fn()];
  leisure.after(100, run);
  vi.advanceTimersByTime(60);
  leisure.after(100, run);
  leisure.after(100, other);
  leisure.forget(other);
  vi.advanceTimersByTime(99);
  expect(run).not.toHaveBeenCalled();
  vi.advanceTimersByTime(300);
  expect(run).toHaveBeenCalledTimes(1);
  expect(other).not.toHaveBeenCalled();
});
