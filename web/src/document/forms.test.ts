import { expect, test } from "vitest";
import { realMaker } from "../../testing/real-maker";
import { beginnings } from "../words/english/beginnings";
import { FORMS } from "./forms";
import { designOf } from "./gallery/exhibit";

const { maker } = realMaker({ free: true });

/** Millilitres, and centimetres of height: from what to what such a thing is in use. */
const USUAL: Readonly<
  Record<(typeof FORMS)[number]["id"], readonly [holds: readonly [number, number], high: readonly [number, number]]>
> = {
  "form-cylinder": [
    [600, 1200],
    [12, 18],
  ],
  "form-bowl": [
    [500, 1200],
    [6, 10],
  ],
  "form-jar": [
    [1500, 3000],
    [15, 22],
  ],
  "form-bottle": [
    [700, 1100],
    [22, 30],
  ],
  "form-vase": [
    [1500, 3000],
    [22, 32],
  ],
  "form-teapot": [
    [800, 1200],
    [9, 14],
  ],
  "form-planter": [
    [2000, 4000],
    [13, 20],
  ],
  "form-cup": [
    [250, 350],
    [7, 10],
  ],
  "form-plate": [
    [400, 1200],
    [2, 4],
  ],
  "form-jug": [
    [1000, 2000],
    [17, 25],
  ],
  "form-moon-jar": [
    [4000, 7000],
    [18, 30],
  ],
  "form-gourd": [
    [1000, 2000],
    [20, 30],
  ],
};

test("there are twelve, each under a name of its own", () => {
  expect(FORMS.map(({ id }) => id)).toEqual(Object.keys(beginnings.forms));
  expect(new Set(Object.values(beginnings.forms).map(({ title }) => title)).size).toBe(12);
});

test.each(FORMS.map((form) => [form.id, form] as const))(
  "%s can be made, stands, and holds what such a thing holds",
  async (id, form) => {
    expect(form.shape.kind).toBe("rings");
    const design = designOf(form);
    const report = await maker.ask({ kind: "check", design, making: {} });
    if (report.state !== "done") throw new Error(JSON.stringify(report));
    expect(report.value.ok).toBe(true);
    expect(report.value.findings.filter(({ severity }) => severity !== "note")).toEqual([]);
    // At the size of a hand clay is no thinner than a potter throws it.
    const clay = await maker.ask({ kind: "check", design, making: { craft: "clay" } });
    expect(clay.state === "done" && clay.value.findings.filter(({ severity }) => severity !== "note")).toEqual([]);
    const measured = await maker.ask({ kind: "measure", design, product: "pot", fill: null });
    if (measured.state !== "done") throw new Error(JSON.stringify(measured));
    const { height, capacity, tipping } = measured.value;
    const [[least, most], [low, high]] = USUAL[id];
    expect(capacity?.brim.value).toBeGreaterThan(least);
    expect(capacity?.brim.value).toBeLessThan(most);
    expect(height.value).toBeGreaterThan(low);
    expect(height.value).toBeLessThan(high);
    expect(tipping.empty?.degrees).toBeGreaterThan(15);
    expect(tipping.full?.degrees).toBeGreaterThan(15);
  },
);
