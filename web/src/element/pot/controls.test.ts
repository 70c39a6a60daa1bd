import { describe, expect, it } from "vitest";
import { FAMILIES } from "../../document/families.gen";
import type { Design, Refusal, Shape } from "../../document/types";
import { shownFields } from "./controls";

const design = (kind: keyof typeof FAMILIES): Design => ({
  pasu: 1,
  parts: [{ shape: (FAMILIES[kind] as unknown as { reset: Shape }).reset }],
});

function shown(of: Design, names: string) {
  const refusals: Refusal[] = [];
  const fields = shownFields(of, names, (refusal) => refusals.push(refusal));
  return { keys: fields.map(({ key }) => key), refusals };
}

describe("the parameters that a page names", () => {
  it("are shown in its order, each once, by path, key or symbol", () => {
    expect(shown(design("bloor-wilson"), "n1, h[0] r-3,n1").keys).toEqual(["n1", "h-0", "r-3"]);
    expect(shown(design("second-order"), "height r1 h0'").keys).toEqual(["height", "r-0"]);
  });

  it("that are not there are told with those that are", () => {
    const { keys, refusals } = shown(design("second-order"), "height, spout");
    expect(keys).toEqual(["height"]);
    expect(refusals).toMatchObject([{ code: "unknown-name", path: "controls" }]);
    expect(refusals[0]?.message).toMatch(/“spout”.*r\[0\].*height/);
  });

  it("are none of a shape that has none", () => {
    const free: Design = {
      pasu: 1,
      parts: [{ shape: { kind: "boundary-value", span: "2pi" } as unknown as Shape }],
    };
    const { keys, refusals } = shown(free, "height");
    expect(keys).toEqual([]);
    expect(refusals[0]?.message).toBe("this kind of shape has no parameter “height” to show");
  });

  it("are none where none are named", () => {
    expect(shown(design("fourth-order"), " , ")).toEqual({ keys: [], refusals: [] });
  });
});
