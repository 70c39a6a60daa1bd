import { describe, expect, it } from "vitest";
import { CLAY_NAMES, CLAYS, clayOf } from "./clay";
import { GLAZE_NAMES, GLAZES, glazeOf, isDark, plainColour } from "./glaze";
import { codedOf, linearOf } from "./own-colour";

const colours = (record: object) => Object.values(record).flat() as number[];

describe("the tables of glazes and clays", () => {
  it("have every name of the format once", () => {
    expect([...GLAZE_NAMES].sort()).toEqual(Object.keys(GLAZES).sort());
    expect([...CLAY_NAMES].sort()).toEqual(Object.keys(CLAYS).sort());
    expect(GLAZE_NAMES).toHaveLength(8);
    expect(CLAY_NAMES).toHaveLength(4);
  });

  it("hold only what a surface can do: reflect and let through between nothing and everything", () => {
    for (const entry of [...Object.values(GLAZES), ...Object.values(CLAYS)]) {
      for (const x of colours(entry)) {
        expect(x).toBeGreaterThanOrEqual(0);
        expect(x).toBeLessThanOrEqual(1);
      }
    }
  });

  it("have a glaze and a clay for every colour, which look like it", () => {
    for (const colour of ["#000000", "#ffffff", "#1f3f8f"] as const) {
      const shown = plainColour(colour, "stoneware").map(codedOf);
      const asked = linearOf(colour).map(codedOf);
      for (const [i, channel] of shown.entries()) expect(channel).toBeCloseTo(asked[i] ?? Number.NaN, 0.9);
      for (const x of [...colours(glazeOf(colour)), ...colours(clayOf(colour))]) {
        expect(x).toBeGreaterThanOrEqual(0);
        expect(x).toBeLessThanOrEqual(1);
      }
    }
    expect(linearOf("#ff0080").map((x) => Math.round(255 * codedOf(x)))).toEqual([255, 0, 128]);
  });

  it("tell dark looks from light ones", () => {
    expect(isDark({ glaze: "cobalt", clay: "stoneware" })).toBe(true);
    expect(isDark({ glaze: "copper-red", clay: "stoneware" })).toBe(true);
    expect(isDark({ glaze: "clear", clay: "black" })).toBe(true);
    expect(isDark({ glaze: "shino", clay: "stoneware" })).toBe(false);
    expect(isDark({ glaze: "#101820", clay: "porcelain" })).toBe(true);
    expect(isDark({ glaze: "#e0d020", clay: "black" })).toBe(false);
    expect(isDark({ glaze: "tenmoku", clay: "porcelain" })).toBe(true);
    expect(isDark({ glaze: "bare", clay: "black" })).toBe(true);
    expect(isDark({ glaze: "tin-white", clay: "black" })).toBe(false);
    expect(isDark({ glaze: "celadon", clay: "stoneware" })).toBe(false);
  });
});
