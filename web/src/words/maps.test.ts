import { expect, test } from "vitest";
import { MAPS } from "../document/maps";
import { mapNote, mapWords } from "./maps";

test("values have units", () => {
  const words = MAPS.map(({ name }) => mapWords(name, 0.5, "cm").replace("\u00a0", " "));
  expect(words).toEqual(["0.5 /cm", "0.5 /cm²", "0.5 cm", "0.5°"]);
});

test("colours that rise where a middle has nothing to stand for are told as such", () => {
  const scale = { ramp: [], low: 1, high: 3 };
  expect(mapNote("mean-curvature", { ...scale, rises: false })).toBe("Blue is hollow, orange bulges.");
  expect(mapNote("mean-curvature", { ...scale, rises: true })).toBe("Violet is least, yellow most.");
});
