import { expect, test } from "vitest";
import { Rest } from "./rest";

test("a fine frame comes soon, and under a hand after as long as the last one took", () => {
  const rest = new Rest();
  expect(rest.delay).toBe(120);
  expect(rest.hold(true)).toBe(true);
  expect(rest.hold(true)).toBe(false);
  expect(rest.delay).toBe(120);
  rest.took(16);
  expect(rest.delay).toBe(120);
  rest.took(700);
  expect(rest.delay).toBe(700);
  expect(rest.hold(false)).toBe(true);
  expect(rest.delay).toBe(120);
  // What a frame took is known in the next gesture.
  rest.hold(true);
  expect(rest.delay).toBe(700);
});
