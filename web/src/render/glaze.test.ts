import { describe, expect, it } from "vitest";
import { CLAY_NAMES, CLAYS } from "./clay";
import { GLAZE_NAMES, GLAZES, isDark } from "./glaze";

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

  it("tell dark looks from light ones", () => {
    expect(isDark({ glaze: "tenmoku", clay: "porcelain" })).toBe(true);
    expect(isDark({ glaze: "bare", clay: "black" })).toBe(true);
    expect(isDark({ glaze: "tin-white", clay: "black" })).toBe(false);
    expect(isDark({ glaze: "celadon", clay: "stoneware" })).toBe(false);
  });
});
