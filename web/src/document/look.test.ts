import { describe, expect, it } from "vitest";
import { lookOf } from "./look";
import { isOwn, swatchOf } from "./swatches";
import type { Look, Part } from "./types";

const part = (look: Look): Part => ({ shape: { kind: "second-order" }, look }) as unknown as Part;

describe("the look of a part", () => {
  it("has everything, whatever is left out", () => {
    expect(lookOf(undefined)).toEqual({ glaze: "celadon", inside: "celadon", line: 0, clay: "stoneware" });
    expect(lookOf(part({ glaze: "#1f3f8f" }))).toMatchObject({ glaze: "#1f3f8f", inside: "#1f3f8f" });
    expect(lookOf(part({ inside: "tin-white", line: 0.25 }))).toMatchObject({ inside: "tin-white", line: 0.25 });
  });

  it("begins with the colour that there was", () => {
    expect(isOwn("celadon")).toBe(false);
    expect(isOwn("#ffffff")).toBe(true);
    expect(swatchOf("cobalt")).toBe("#1f3f8f");
    expect(swatchOf("terracotta")).toBe("#b9613d");
    expect(swatchOf("#123456")).toBe("#123456");
  });
});
