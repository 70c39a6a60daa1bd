import { expect, test } from "vitest";
import type { Outline } from "../document/places";
import type { Finding, Measures, PartMeasures, Report, Triple } from "../document/types";
import { checked, findingWords, inFile, madeOf, verdict } from "./report";

const OUTLINE: Outline = [
  [0, 2],
  [4, 4],
  [5, 3.6],
  [6, 2],
  [7, 1.2],
  [10, 1.5],
];
const SHOULDER: Triple = [3, 0, 5.5];
const RIM: Triple = [1.5, 0, 10];

const part = (given: Partial<PartMeasures>): PartMeasures =>
  ({
    part: 0,
    name: null,
    isPot: true,
    reason: null,
    cause: null,
    thickness: null,
    overhang: null,
    overhangInside: null,
    ...given,
  }) as PartMeasures;
const measures = (given: Partial<Measures>, ...parts: readonly Partial<PartMeasures>[]): Measures =>
  ({ tipping: { empty: null, full: null }, parts: parts.map(part), ...given }) as Measures;
const texts = (made: Measures, report: Report | null = null) =>
  verdict(made, report, OUTLINE, "cm").map(({ severity, text }) => `${severity}: ${text.replaceAll("\u00a0", " ")}`);

test("an overhang is told by its angle and place", () => {
  const overhang = (degrees: number) => measures({}, { overhang: { degrees, error: 0, at: SHOULDER, face: "outer" } });
  expect(texts(overhang(61.6))).toEqual([
    "warning: Overhang of 62 degrees at the shoulder: a printer needs support there.",
  ]);
  expect(texts(overhang(30))).toEqual([
    "good: The steepest overhang is 30 degrees, at the shoulder: it prints without support.",
  ]);
  expect(texts(overhang(-3))).toEqual(["good: Nothing hangs over: it prints without support."]);
});

test("of a pot with a ceiling beneath it only the wall is said to print without support", () => {
  const message =
    "the base within the foot ring is a ceiling, 50 mm wide and 2.5 mm above the ground: printers bridge it";
  const args = { what: "within-ring", widthMm: 50, heightMm: 2.5 };
  const finding = {
    code: "ceiling",
    severity: "note",
    part: 0,
    path: null,
    message,
    args,
    at: [0, 0, 0],
    remedy: null,
  };
  const report = { ok: false, findings: [finding], meshes: [] } as unknown as Report;
  const told = (degrees: number) =>
    texts(measures({}, { overhang: { degrees, error: 0, at: SHOULDER, face: "outer" } }), report);
  const ceiling =
    "note: The base within the foot ring is a ceiling, 50 mm wide and 2.5 mm above the ground: printers bridge it or need support.";
  expect(told(30)).toEqual([
    ceiling,
    "good: The steepest overhang of the wall is 30 degrees, at the shoulder: it prints without support.",
  ]);
  expect(told(-3)).toEqual([ceiling, "good: The wall hangs over nowhere: it prints without support."]);
});

test("what is found of one of several parts has its name", () => {
  const finding = {
    code: "overlap",
    severity: "warning",
    part: 1,
    path: null,
    message: "they touch",
    args: { what: "touches", other: 0 },
    at: null,
    remedy: null,
  };
  const report = { ok: false, findings: [finding], meshes: [] } as unknown as Report;
  const two = measures({}, { part: 0, name: "Lid" }, { part: 1, name: "Jar" });
  expect(texts(two, report).map((text) => text.replaceAll(/[\u2068\u2069]/g, ""))).toEqual([
    "warning: Jar: It touches or runs through Lid.",
  ]);
  expect(texts(measures({}, { part: 1, name: "Jar" }), report)).toEqual([
    "warning: It touches or runs through Part 1.",
  ]);
});

test("the inside hangs over too, and is told by its own place however thick the wall is", () => {
  const hangs = (outside: number, inside: number, z: number) =>
    measures(
      {},
      {
        overhang: { degrees: outside, error: 0, at: [2, 0, 0.3], face: "outer" },
        overhangInside: { degrees: inside, error: 0, at: [1, 0, z], face: "lining" },
      },
    );
  // A lining whose shoulder lies as low as the belly of the outside.
  expect(texts(hangs(33, 72.6, 4.1))).toEqual([
    "warning: Overhang of 73 degrees inside the shoulder: a printer needs support there.",
  ]);
  expect(texts(hangs(61, 50, 8))).toEqual([
    "warning: Overhang of 61 degrees at the foot: a printer needs support there.",
    "warning: Overhang of 50 degrees inside the neck: a printer needs support there.",
  ]);
  expect(texts(hangs(20, 44, 9.9))).toEqual([
    "good: The steepest overhang is 44 degrees, inside the rim: it prints without support.",
  ]);
  expect(texts(hangs(33, -2, 5))).toEqual([
    "good: The steepest overhang is 33 degrees, at the foot: it prints without support.",
  ]);
});

test("no place of another part is named by the outline of the first, and none of what has no outline", () => {
  const over = (degrees: number): Partial<PartMeasures> => ({
    overhang: { degrees, error: 0, at: SHOULDER, face: "outer" },
    overhangInside: { degrees: degrees - 5, error: 0, at: SHOULDER, face: "lining" },
  });
  const bare = (text: string) => text.replaceAll(/[\u2068\u2069]/g, "");
  const scene = measures({}, { part: 0, name: "Jar", ...over(60) }, { part: 1, name: "Lid", ...over(70) });
  expect(texts(scene).map(bare)).toEqual([
    "warning: Jar: Overhang of 60 degrees at the shoulder: a printer needs support there.",
    "warning: Jar: Overhang of 55 degrees inside the shoulder: a printer needs support there.",
    "warning: Lid: Overhang of 70 degrees in places: a printer needs support there.",
  ]);
  expect(texts(measures({}, { part: 0 }, { part: 1, name: "Lid", ...over(30) })).map(bare)).toEqual([
    "good: Lid: The steepest overhang is 30 degrees: it prints without support.",
  ]);
  const network = verdict(measures({}, over(90)), null, [], "cm");
  expect(network.map(({ text }) => text.replaceAll("\u00a0", " "))).toEqual([
    "Overhang of 90 degrees in places: a printer needs support there.",
  ]);
});

/** A wall that is thin at the rim, and thinner than asked for in such a share of it. */
const thin = (thinned: number) => ({
  asked: 0.3,
  least: { value: 0.07, error: 0, at: RIM },
  greatest: { value: 0.3, error: 0 },
  thinned: { value: thinned, error: 0 },
});

test("a wall is told where it was thinned and where it is too thin to print", () => {
  const thickness = thin(0.1);
  expect(texts(measures({}, { thickness }))).toEqual([
    "warning: The wall is thinned to 0.07 cm at the rim, where the pot bends too tightly for 0.3 cm.",
    "warning: The wall is only 0.7 mm thick at the rim: too thin for most clay and most printers at this size.",
  ]);
});

test("before saving, a wall is too thin or not by the size of the file", () => {
  const thickness = thin(0);
  const report = { ok: true, findings: [], meshes: [], triangles: 4 } as unknown as Report;
  const at = (millimetres: number) =>
    madeOf(report, measures({}, { thickness }), OUTLINE, "cm", millimetres).map(({ severity, text }) => [
      severity,
      text,
    ]);
  const closed = ["good", "The mesh is closed, every edge is shared by two triangles, and it does not cross itself."];
  expect(at(20)).toEqual([closed]);
  expect(at(5).map((sentence) => sentence.join(": ").replaceAll("\u00a0", " "))).toEqual([
    "warning: The wall is only 0.35 mm thick at the rim: too thin for most clay and most printers at this size.",
    closed.join(": "),
  ]);
});

test("a tolerance is told in the millimetres of the file", () => {
  const at = (args: Finding["args"], millimetres: number) => {
    const finding = { code: "tolerance-too-fine", severity: "warning", part: 0, path: "tolerance", message: "", args };
    const report = { product: "pot", findings: [finding], meshes: [], unions: [], ok: false } as unknown as Report;
    const [sentence] = checked(inFile(report, millimetres), null, OUTLINE, "cm");
    return sentence?.text.replaceAll("\u00a0", " ");
  };
  expect(at({ what: "joined", bound: 0.0503, asked: 0.05 }, 20)).toMatch(/within 1.006 mm.* not within 1 mm/);
  expect(at({ what: "unkept", bound: 0.02, asked: 0 }, 10)).toMatch(/0.2 mm.* 0 mm/);
  expect(at({ found: 1e-7 }, 10)).toMatch(/^Triangles as fine as 0.000001 mm /);
});

test("how thin a wall is made is told in the millimetres of the file", () => {
  const finding = { code: "thinned", severity: "warning", part: 0, path: null, message: "", args: {}, at: RIM };
  const meshes = [{ part: 0, thinnest: 0.0532, thinned: 0.43 }];
  const report = { product: "pot", findings: [finding], meshes, unions: [], ok: false } as unknown as Report;
  const said = (millimetres?: number) => checked(report, null, OUTLINE, "cm", millimetres)[0]?.text;
  expect(said()?.replaceAll("\u00a0", " ")).toMatch(/^The wall is thinned to 0.0532 cm at the rim/);
  expect(said(20)?.replaceAll("\u00a0", " ")).toMatch(/^The wall is thinned to 1.1 mm at the rim/);
  const thin = { least: { value: 0.0532, at: RIM }, thinned: { value: 0.43 } } as never;
  const [first] = madeOf(
    report,
    measures({ parts: [{ part: 0, name: null, thickness: thin }] as never }),
    OUTLINE,
    "cm",
    10,
  );
  expect(first?.text.replaceAll("\u00a0", " ")).toMatch(/^The wall is thinned to 0.53 mm at the rim/);
});

test("how it stands, empty and full", () => {
  const tip = (empty: number, full: number | null) =>
    texts(
      measures({
        tipping: {
          empty: { degrees: empty, error: 0, toward: 0 },
          full: full === null ? null : { degrees: full, error: 0, toward: 0 },
        },
      }),
    );
  expect(tip(24, 19.6)).toEqual([
    "good: It stands: empty it tips when tilted by 24 degrees, and when full by 20 degrees.",
  ]);
  expect(tip(24, null)).toEqual(["good: It stands: empty it tips when tilted by 24 degrees."]);
  expect(tip(8, 5)).toEqual(["warning: It tips easily: empty when tilted by 8 degrees, and when full by 5 degrees."]);
  expect(tip(0, null)).toEqual(["error: It falls over: its weight is not above its foot."]);
  expect(tip(12, 0)).toEqual(["error: It stands empty, but falls over when it is full."]);
});

test("the worst comes first, and parts are named where there are several", () => {
  const made = measures(
    { tipping: { empty: { degrees: 30, error: 0, toward: 0 }, full: null } },
    { overhang: { degrees: 80, error: 0, at: SHOULDER, face: "outer" } },
    { part: 1, name: "lid", isPot: false, cause: { code: "open-surface", path: null, args: { what: "not-closed" } } },
  );
  expect(texts(made).map((text) => text.split(":")[0])).toEqual(["error", "warning", "good"]);
  expect(texts(made)[0]).toBe(
    "error: lid: The surface does not meet itself after one turn. It does with whole numbers of waves.",
  );
});

test("a handle that is a solid as it is, and a part that the checks leave out, are no fault of the pot", () => {
  const solid = { part: 1, name: "Handle", isPot: false, clay: {} } as Partial<PartMeasures>;
  const cause = { code: "open-surface", path: "parts[1].shape", args: { what: "no-foot" } } as const;
  expect(texts(measures({}, {}, { ...solid, cause }))).toEqual([]);
  const bare = { part: 1, name: "Vase", isPot: false, clay: null, cause: { ...cause, code: "no-wall" } };
  const finding = { code: "no-wall", severity: "warning", part: 1, path: null, message: "", args: {}, at: null };
  const report = { ok: true, findings: [finding], meshes: [] } as unknown as Report;
  expect(texts(measures({}, {}, bare as Partial<PartMeasures>), report)).toEqual([
    "warning: Vase: This part has no wall and is left out of the pots: with thickness and base it is one.",
    "good: The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  ]);
});

test("what the checks say of a thinned wall is told once, with its unit and place", () => {
  const thickness = {
    asked: 0.3,
    least: { value: 0.12, error: 0, at: RIM },
    greatest: { value: 0.3, error: 0 },
    thinned: { value: 0.034, error: 0 },
  };
  const finding = {
    code: "thinned",
    severity: "warning",
    part: 0,
    path: "parts[0].wall.thickness",
    message: "thin",
    args: {},
    at: SHOULDER,
    remedy: null,
  } as const;
  const report = { ok: true, findings: [finding], meshes: [{ part: 0, thinnest: 0.12, thinned: 0.034 }] };
  expect(texts(measures({}, { thickness }), report as unknown as Report)).toEqual([
    "warning: The wall is thinned to 0.12 cm at the shoulder, where the pot bends more tightly or comes closer to itself than the wall is thick: 3.4 % of it is thinner than asked for.",
    "good: The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  ]);
});

test("findings are given the name of their place, once", () => {
  const finding = {
    code: "thinned",
    severity: "warning",
    part: 0,
    path: "parts[0].wall.thickness",
    message: "The wall is thin.",
    args: {},
    at: RIM,
    remedy: null,
  } as const;
  expect(findingWords(finding, OUTLINE, "cm")).toBe("The wall is thin (at the rim).");
  expect(findingWords({ ...finding, message: "Thin at the rim." }, OUTLINE, "cm")).toBe("Thin at the rim.");
  expect(findingWords({ ...finding, at: null }, OUTLINE, "cm")).toBe("The wall is thin.");
  expect(texts(measures({}), { ok: true, findings: [] } as unknown as Report)).toEqual([
    "good: The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  ]);
});

test("a ring that was fitted is told with its size and unit", () => {
  const wall = { thickness: 0.3, base: 0.3, foot: [1.1, 0.4326] as const };
  const finding = {
    code: "fitted-foot",
    severity: "warning",
    part: 0,
    path: "parts[0].wall.foot",
    message: "the foot ring is made otherwise",
    args: {},
    at: null,
    remedy: { path: "parts[0].wall", wall, message: "" },
  } as const;
  const report = { ok: true, findings: [finding], meshes: [] } as unknown as Report;
  expect(texts(measures({}), report)[0]).toBe(
    "warning: There is no room for the foot ring that was asked for: it is made 1.1 cm wide and 0.43 cm high.",
  );
});
