import { expect, test } from "vitest";
import { upright } from "./upright";

test("what is up is up after that, and nothing is seen in the mirror", () => {
  expect([...upright(Float32Array.of(1, 2, 3, 0, 1, 0, 0, 0, 1))]).toEqual([1, -3, 2, 0, -0, 1, 0, -1, 0]);
});
