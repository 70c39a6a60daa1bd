import { expect, test } from "vitest";
import { boundWords } from "./bound";

test("a bound is never told smaller than it is", () => {
  const told = [0.00964, 0.0096, 0.00991, 0.995, 1, 12.01, 99.4, 1234, 0, 1.0000001e-7].map((value) =>
    boundWords(value, "cm"),
  );
  expect(told.map((words) => words.split(/\s/u)[0])).toEqual([
    "0.0097",
    "0.0096",
    "0.01",
    "1",
    "1",
    "13",
    "100",
    "1300",
    "0",
    "1.1e−7",
  ]);
});
