import { expect, test } from "vitest";
import type { Measures, Unit } from "../document/types";
import { waterRange } from "../document/water";
import { isolated } from "../language";
import { holdsText, measureGroups } from "./measures";

const q = (value: number, error = 1e-12) => ({ value, error });

const MEASURES = {
  height: q(12.3),
  bottom: -1,
  top: 11.3,
  width: { least: q(7), greatest: q(8.25), leastDirection: 90, greatestDirection: 0 },
  area: q(300),
  clay: { area: q(610), volume: q(90), mass: q(207) },
  capacity: {
    brim: q(420.5, 3e-9),
    spill: { level: q(11, 1e-9), at: [1, 0, 11] },
    floor: -0.5,
    fill: null,
    stopped: true,
  },
  centre: { empty: { at: [0, 0, 4], error: 1e-12 }, full: { at: [0.3, 0.4, 5], error: 1e-12 } },
  footprint: { level: -1, area: q(10), hullArea: q(12), hull: [] },
  tipping: { empty: { degrees: 24.31, error: 1e-9, toward: 0 }, full: { degrees: 19, error: 1e-9, toward: 10 } },
  parts: [
    {
      part: 0,
      name: null,
      isPot: true,
      reason: null,
      capacityReason: null,
      thickness: {
        asked: 0.5,
        least: { value: 0.4, error: 0, at: null },
        greatest: { value: 0.5, error: 0 },
        thinned: { value: 0.1, error: 0 },
      },
      overhang: { degrees: 31.2, error: 0, at: [0, 0, 0], face: "outer" },
      curvature: {
        mean: { least: { value: -0.5, error: 0, at: [0, 0, 0] }, greatest: null },
        gaussian: { least: { value: -1, error: 0, at: [0, 0, 0] }, greatest: { value: 2, error: 0, at: [0, 0, 0] } },
      },
    },
  ],
} as unknown as Measures;

const lines = (measures: Measures, unit: Unit = "cm") =>
  Object.fromEntries(
    measureGroups(measures, 0, unit).flatMap(({ lines: all }) =>
      all.map(({ name, value, note }) => [name, `${value}${note ? ` (${note})` : ""}`.replaceAll("\u00a0", " ")]),
    ),
  );

test("every measure is told with its unit", () => {
  expect(lines(MEASURES)).toEqual({
    Height: "12.3 cm",
    "Greatest width": "8.25 cm (across, at 0°)",
    "Least width": "7 cm (across, at 90°)",
    "Area of the surface": "300 cm²",
    "To the brim": "420.5 ml (with the drain hole stopped)",
    "Spills at a height of": "12 cm",
    Volume: "90 ml",
    "Mass, fired": "207 g",
    "Area to glaze, all sides": "610 cm²",
    "Centre of mass": "5 cm (above the foot)",
    "Centre of mass, full": "6 cm (above the foot, 0.5 cm from the axis)",
    Footprint: "12 cm² (of which 10 cm² touch the table)",
    "Tips when tilted by": "24.3° (towards 0°)",
    "Tips when full, by": "19° (towards 10°)",
    Thickness: "0.4 to 0.5 cm (0.5 cm was asked for)",
    "Largest overhang": "31.2° (from upright, where it faces down)",
    "Mean curvature": "−0.5 to no greatest /cm",
    "Gaussian curvature": "−1 to 2 /cm²",
  });
});

test("where no curvature is known none is told", () => {
  const none = { least: null, greatest: null };
  const [own] = MEASURES.parts;
  const told = lines({ ...MEASURES, parts: [{ ...own, curvature: { mean: none, gaussian: none } }] } as Measures);
  expect(Object.keys(told).filter((name) => name.includes("curvature"))).toEqual([]);
});

test("a curvature without either bound is told so beside one that has one", () => {
  const [own] = MEASURES.parts;
  const none = { least: null, greatest: null };
  const told = lines({
    ...MEASURES,
    parts: [
      { ...own, curvature: { mean: none, gaussian: { ...none, greatest: { value: 2, error: 0, at: [0, 0, 0] } } } },
    ],
  } as unknown as Measures);
  expect(told).toMatchObject({ "Mean curvature": "without a bound", "Gaussian curvature": "no least to 2 /cm²" });
});

test("a pot on a round foot tips in every direction alike, and all of a full foot touches the table", () => {
  const radius = 5 * Math.tan((24.31 * Math.PI) / 180);
  const disc = q(Math.PI * radius * radius);
  const on = (hullArea: { value: number; error: number }) =>
    lines({ ...MEASURES, footprint: { level: -1, area: hullArea, hullArea, hull: [] } } as unknown as Measures);
  expect(on(disc)).toMatchObject({ "Tips when tilted by": "24.3° (in every direction)" });
  expect(on(disc).Footprint).toMatch(/\(all of it touches the table\)$/);
  // A foot that is a little longer one way tips first the other way.
  expect(on(q(1.001 * disc.value))).toMatchObject({ "Tips when tilted by": "24.3° (towards 0°)" });
  // The water stands beside the axis: full, it tips to that side.
  expect(on(disc)).toMatchObject({ "Tips when full, by": "19° (towards 10°)" });
});

test("what stands on an edge or a point is not said to touch the table with all of nothing", () => {
  const on = (hullArea: number) =>
    lines({
      ...MEASURES,
      footprint: { level: -1, area: q(0), hullArea: q(hullArea), hull: [] },
    } as unknown as Measures);
  for (const area of [0, 1e-7]) expect(on(area).Footprint).toBe("0 cm² (it stands on an edge or a point)");
  // A tube that flares.
  expect(on(12).Footprint).toBe("12 cm² (of which only edges or points touch the table)");
  // Of a round foot that only just touches, rounding leaves as much.
  const touch = { level: -1, area: q(1e-6), hullArea: q(12), hull: [] };
  const barely = lines({ ...MEASURES, footprint: touch } as unknown as Measures);
  expect(barely.Footprint).toBe("12 cm² (of which only edges or points touch the table)");
  const footprint = { level: -1, area: q(3), hullArea: q(12), hull: [] };
  const ring = lines({ ...MEASURES, footprint } as unknown as Measures);
  expect(ring.Footprint).toBe("12 cm² (of which 3 cm² touch the table)");
});

test("widths that read alike are one, unless they are told more exactly", () => {
  const width = { least: q(8.2511), greatest: q(8.2514), leastDirection: 90, greatestDirection: 0 };
  expect(lines({ ...MEASURES, width })).toMatchObject({ Width: "8.25 cm (the same all round)" });
  const [exact] = measureGroups({ ...MEASURES, width }, 0, "cm", true);
  expect(exact?.lines.map(({ value }) => value.replaceAll("\u00a0", " ")).slice(1, 3)).toEqual([
    "8.2514 cm",
    "8.2511 cm",
  ]);
});

test("a direction all the way round is 0°, and a width across half way round too", () => {
  const { width, tipping } = MEASURES;
  const told = lines({
    ...MEASURES,
    width: { ...width, greatestDirection: 179.97, leastDirection: 89.97 },
    tipping: { ...tipping, empty: { ...tipping.empty, toward: 359.96 }, full: { ...tipping.full, toward: 359.94 } },
  } as Measures);
  expect(told["Greatest width"]).toMatch(/\(across, at 0°\)$/);
  expect(told["Least width"]).toMatch(/\(across, at 90°\)$/);
  expect(told["Tips when tilted by"]).toMatch(/\(towards 0°\)$/);
  expect(told["Tips when full, by"]).toMatch(/\(towards 359.9°\)$/);
});

test("a curvature that may as well be nothing is told as 0", () => {
  const [own] = MEASURES.parts;
  const end = (value: number) => ({ value, error: 3e-18, at: [0, 0, 0] });
  const gaussian = { least: end(-6.307), greatest: end(-1.664e-33) };
  const told = lines({
    ...MEASURES,
    parts: [{ ...own, curvature: { mean: gaussian, gaussian } }],
  } as unknown as Measures);
  expect(told["Gaussian curvature"]).toBe("−6.307 to 0 /cm²");
});

test("in inches what is fired is weighed in pounds too, and volumes are told in measures of the United States", () => {
  expect(lines(MEASURES, "in").Volume?.replaceAll("\u00a0", " ")).toMatch(/ l .*\([\d.]+ US (pt|gal)\)$/);
  expect(holdsText(MEASURES, "in").replaceAll("\u00a0", " ")).toMatch(/^Holds 1.82 US gal to the brim/);
  expect(lines(MEASURES, "in")["Mass, fired"]).toBe("207 g (0.456 lb)");
});

test("of several parts it is said whose wall is told", () => {
  const titles = (name: string | null) => measureGroups(MEASURES, 0, "cm", false, name).map(({ title }) => title);
  expect(titles(null).at(-1)).toBe("Wall");
  expect(titles("Lid").at(-1)).toBe(`Wall of ${isolated("Lid")}`);
  expect(titles("Lid").slice(0, -1)).toEqual(titles(null).slice(0, -1));
});

test("errors are there to be told", () => {
  const [size, capacity] = measureGroups(MEASURES, 0, "cm");
  expect(size?.lines[0]?.error.replaceAll("\u00a0", " ")).toBe("± 10⁻¹²");
  expect(capacity?.lines[0]?.error.replaceAll("\u00a0", " ")).toBe("± 3 × 10⁻⁹");
});

test("errors are in the unit of their numbers", () => {
  const [, capacity] = measureGroups(MEASURES, 0, "mm");
  expect(capacity?.lines[0]).toMatchObject({ value: "0.4205\u00a0ml", error: "±\u00a03\u00a0×\u00a010⁻¹²" });
});

test("what holds nothing says why", () => {
  const [part] = MEASURES.parts;
  if (!part) throw new Error("part");
  const tube: Measures = {
    ...MEASURES,
    capacity: null,
    parts: [{ ...part, capacityReason: "a tube", capacityCause: { code: "no-bottom", path: null, args: {} } }],
  };
  expect(measureGroups(tube, 0, "cm")[1]).toMatchObject({
    lines: [],
    reason: "A tube has no bottom to hold anything. A base closes it.",
  });
  expect(holdsText(tube, "cm")).toBe("A tube has no bottom to hold anything. A base closes it.");
  expect(waterRange(tube)).toBeNull();
});

test("how much it holds, and between which heights water stands", () => {
  expect(holdsText(MEASURES, "cm").replaceAll("\u00a0", " ")).toBe(
    "Holds 421 ml to the brim with its drain hole stopped.",
  );
  const range = waterRange(MEASURES);
  expect(range?.low).toBe(-0.5);
  expect(range?.high).toBeCloseTo(11, 8);
  expect(range?.high).toBeLessThan(11);
});

test("a round pot has one width", () => {
  const { width } = MEASURES;
  const round = lines({ ...MEASURES, width: { ...width, least: width.greatest } });
  expect(round.Width).toBe("8.25 cm (the same all round)");
  expect(round["Least width"]).toBeUndefined();
});
