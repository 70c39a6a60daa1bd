import { expect, test, vi } from "vitest";
import { came, comes, waitsForThoseSeen } from "./those-seen";

test("a pot near the screen waits for each on it, and for none when there is none", () => {
  const [one, other, begin] = [{}, {}, vi.fn()];
  expect(waitsForThoseSeen(begin)).toBe(false);
  comes(one);
  comes(other);
  comes(one);
  expect(waitsForThoseSeen(begin)).toBe(true);
  came({});
  came(one);
  came(one);
  expect(begin).not.toHaveBeenCalled();
  came(other);
  expect(begin).toHaveBeenCalledTimes(1);
  came(other);
  expect(begin).toHaveBeenCalledTimes(1);
  expect(waitsForThoseSeen(begin)).toBe(false);
});
