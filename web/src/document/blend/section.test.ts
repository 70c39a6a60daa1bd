import { expect, test } from "vitest";
import type { Blend, Section } from "../types";
import { figureOf } from "./figure";
import { borderOf, FORMS, numberOf, radiusOf, refigured, reformed, sizeFactor, withNumber } from "./section";
import { SECTION } from "./tables.gen";

const DISC: Section = { form: "disc", radius: [4, 3], z: 2, taper: 0.5, dz: 7 };

test("in every form a section is as large, as high and as steep as it was", () => {
  for (const from of FORMS) {
    const section = reformed(DISC, from);
    expect(section).toMatchObject({ form: from, z: 2, taper: 0.5, dz: 7 });
    for (const to of FORMS) {
      const made = reformed(section, to);
      expect(made.form).toBe(to);
      const [width, depth] = [0, 1].map((axis) => Math.max(...borderOf(made).map((point) => point[axis] ?? 0)));
      // A rectangle as an outline has round corners, and is no wider than its sides.
      const off = section.form === "rectangle" || to === "rectangle" ? 0.35 : 0.12;
      expect(Math.abs((width ?? 0) - 4)).toBeLessThan(4 * off);
      expect(Math.abs((depth ?? 0) - 3)).toBeLessThan(3 * off);
    }
  }
  expect(reformed(DISC, "disc")).toBe(DISC);
});

test("a rectangle as an outline has its sides where they were", () => {
  const box = reformed({ ...DISC, form: "rectangle" }, "outline");
  const border = borderOf(box);
  expect(Math.max(...border.map(([x]) => x))).toBeCloseTo(4, 1);
  expect(Math.max(...border.map(([, y]) => y))).toBeCloseTo(3, 1);
});

test("numbers are read as they were set, each alone, and the same one changes nothing", () => {
  for (const form of FORMS) {
    const section = reformed(DISC, form);
    for (const { key } of SECTION) {
      const next = withNumber(section, key, 1.25);
      for (const other of SECTION) {
        const expected = other.key === key ? 1.25 : numberOf(section, other.key);
        expect(numberOf(next, other.key)).toBeCloseTo(expected, 8);
      }
      expect(withNumber(next, key, numberOf(next, key))).toBe(next);
    }
  }
});

test("a disc that is turned is an outline that goes the same way", () => {
  const turned = refigured(DISC, { turn: 30 });
  expect(turned.form).toBe("outline");
  expect(turned.form === "outline" && figureOf(turned).turn).toBeCloseTo(30, 8);
  expect(radiusOf(turned)).toEqual([4, 3]);
  // Anticlockwise from above: what was behind is to the left.
  const [first] = borderOf(turned);
  expect(first?.[0]).toBeCloseTo(-3 * Math.sin(Math.PI / 6), 8);
  expect(first?.[1]).toBeCloseTo(3 * Math.cos(Math.PI / 6), 8);
});

test("sliders reach over what there is in one, two or five times a power of ten", () => {
  const blend = (radius: number, z: number): Blend => ({
    kind: "blend",
    start: { ...DISC, form: "disc", radius: [radius, radius], z: 0 },
    end: { ...DISC, form: "disc", radius: [radius, radius], z },
  });
  expect(sizeFactor(blend(1, 2))).toBe(1);
  expect(sizeFactor(blend(8, 14))).toBe(5);
  expect(sizeFactor(blend(80, 140))).toBe(50);
  expect(sizeFactor(blend(0.01, 0.02))).toBe(0.005);
});
