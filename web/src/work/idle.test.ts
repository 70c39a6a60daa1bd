import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { whenIdle } from "./idle";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test("what waits runs once, in its order, where no browser says that it is idle too", async () => {
  const ran: string[] = [];
  whenIdle(() => ran.push("first"));
  whenIdle(() => ran.push("second"));
  expect(ran).toEqual([]);
  await vi.runAllTimersAsync();
  await vi.runAllTimersAsync();
  expect(ran).toEqual(["first", "second"]);
});
