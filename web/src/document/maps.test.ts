import { expect, test } from "vitest";
import { MAPS, mapOf, mapWords, rangeOf } from "./maps";

test("colours with a middle have 0 there", () => {
  const map = mapOf("mean-curvature");
  expect(rangeOf(map, -1, 3)).toEqual([-3, 3]);
  expect(rangeOf(map, 1, 3)).toEqual([-3, 3]);
  const [low, high] = rangeOf(map, 0, 0);
  expect(high).toBeGreaterThan(low);
});

test("a wall of one thickness has a range all the same", () => {
  const map = mapOf("thickness");
  expect(rangeOf(map, 0.2, 0.3)).toEqual([0.2, 0.3]);
  for (const value of [0.3, 0]) {
    const [low, high] = rangeOf(map, value, value);
    expect(low).toBeLessThan(value);
    expect(high).toBeGreaterThan(value);
  }
});

test("overhangs are compared with all that there can be", () => {
  expect(rangeOf(mapOf("overhang"), 3, 20)).toEqual([0, 90]);
});

test("values have units", () => {
  const words = MAPS.map(({ name }) => mapWords(name, 0.5, "cm").replace("\u00a0", " "));
  expect(words).toEqual(["0.5 /cm", "0.5 /cm²", "0.5 cm", "0.5°"]);
});
