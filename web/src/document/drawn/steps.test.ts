import { expect, test } from "vitest";
import { Steps } from "./steps";

test("steps go back one by one to where they began, and no further", () => {
  const steps = new Steps("a");
  expect(steps.isFirst).toBe(true);
  steps.settle("b");
  steps.settle("b");
  steps.settle("c");
  expect(steps.settled).toBe("c");
  expect([steps.back(), steps.back(), steps.isFirst, steps.back()]).toEqual(["b", "a", true, "a"]);
});

test("of very many the oldest are forgotten", () => {
  const steps = new Steps(0);
  for (let i = 1; i <= 150; i += 1) steps.settle(i);
  while (!steps.isFirst) steps.back();
  expect(steps.settled).toBe(50);
});
