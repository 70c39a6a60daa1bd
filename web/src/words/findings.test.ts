// Every finding and every reason of the library is said in the words of the page.

import { readdirSync, readFileSync } from "node:fs";
import { afterEach, expect, test } from "vitest";
import type { Finding, Measures } from "../document/types";
import { ENGLISH, speak } from "../language";
import { emptyReason } from "./measures";
import { PSEUDO_ENGLISH } from "./pseudo";
import { whyWords } from "./refusals";
import { findingWords } from "./report";

afterEach(() => speak(ENGLISH));

/** A sentence of the library that must not be shown. */
const LIBRARY = "what the library says in English";

/** All that any of them names. */
const ARGS = {
  face: "lining",
  other: "outer",
  end: "foot",
  base: 0.3,
  width: 0.4,
  drain: 1,
  room: 0.8,
  thickness: 0.01,
  found: 4,
  least: 10,
  waves: 5,
};

/** By code, the words by which several things with one code are told apart. */
const REASONS: Readonly<Record<string, readonly string[]>> = {
  "open-surface": ["no-foot", "not-closed", "free-edge", "one-sided"],
  "unsupported-shape": [
    "no-ends",
    "no-template",
    "closes",
    "open-sections",
    "no-inside",
    "hollow",
    "collapsed",
    "left-out",
    "no-foot",
    "no-lining",
  ],
  "pinched-surface": ["no-area", "waist", "shrinks", "section", "no-height", "corners", "no-normal", "thin-edge"],
  "crosses-itself": [
    "surface",
    "surface-close",
    "outline",
    "does-not-close",
    "section",
    "sections",
    "edge",
    "region",
    "not-joined",
    "pinched-joint",
    "touching",
  ],
  "no-room": [
    "no-disc",
    "no-base",
    "above-rim",
    "round-bottom",
    "tip",
    "foot-not-level",
    "ring-too-wide",
    "ring-fills-foot",
    "middle-outside",
    "drain-too-wide",
    "bends-too-sharply",
    "sharp-ring",
    "ends-in-ring",
    "lining",
    "crossing",
    "close",
    "sharp-crease",
    "turned-over",
    "uneven",
  ],
  "out-of-range": ["few-terms", "lining-outside"],
  "too-large": ["tolerance", "triangles", "weights"],
};

const FINDINGS: readonly (readonly [string, Finding["args"]])[] = [
  ...["not-printed", "breaks-printed", "no-clay", "breaks-fired"].map(
    (what) => ["thin-base", { what, thicknessMm: 0.1, leastMm: 0.2, safeMm: 0.6 }] as const,
  ),
  ["ceiling", { what: "within-ring", widthMm: 50, heightMm: 2.5 }],
  ["ceiling", { what: "underside", heightMm: 12 }],
  ...["touches", "within", "round"].map((what) => ["overlap", { what, other: 0 }] as const),
  ["few-terms", { found: 4, least: 10, waves: 5, distance: 3.2 }],
  ...["not-joined", "pinched-joint"].map((what) => ["crosses-itself", { what, other: 0 }] as const),
  ["same-place", { what: "same-body", other: 0 }],
  ...["unkept", "joined"].map((what) => ["tolerance-too-fine", { what, bound: 0.02, asked: 0.01 }] as const),
];

const finding = (code: string, args: Finding["args"], severity: Finding["severity"] = "error"): Finding => ({
  code,
  severity,
  part: 1,
  path: null,
  message: LIBRARY,
  args,
  at: null,
  remedy: null,
});

/** What is left of a sentence in the changed language that was not changed: no unit has so many letters. */
const unchanged = (text: string) => text.match(/[a-z]{4,}/gi) ?? [];

/** Every file of the crate. */
function sources(folder: URL): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const at = new URL(`${entry.name}${entry.isDirectory() ? "/" : ""}`, folder);
    if (entry.isDirectory()) return sources(at);
    return entry.name.endsWith(".rs") ? [readFileSync(at, "utf8")] : [];
  });
}

test("every reason for which a part is refused has a sentence of the page", () => {
  for (const [code, whats] of Object.entries(REASONS)) {
    for (const what of whats) {
      const args = code === "too-large" ? { what, greatest: 8e6 } : { ...ARGS, what };
      speak(ENGLISH);
      const english = findingWords(finding(code, args), [], "cm");
      expect(english, `${code} ${what}`).toMatch(/^[A-Z].*\.$/);
      expect(english).not.toMatch(/what the library|undefined|null/i);
      speak(PSEUDO_ENGLISH);
      expect(unchanged(findingWords(finding(code, args), [], "cm")), `${code} ${what}`).toEqual([]);
    }
  }
  speak(PSEUDO_ENGLISH);
  for (const code of ["no-opening", "no-wall", "overflow", "resonant-problem"]) {
    expect(unchanged(findingWords(finding(code, {}), [], "cm"))).toEqual([]);
  }
});

test("every other finding has one", () => {
  const measures = { parts: [{ part: 0, name: null }] } as unknown as Measures;
  for (const [code, args] of FINDINGS) {
    speak(ENGLISH);
    expect(findingWords(finding(code, args), [], "cm", measures)).not.toMatch(/what the library|undefined|null/i);
    speak(PSEUDO_ENGLISH);
    expect(unchanged(findingWords(finding(code, args), [], "cm", measures)), code).toEqual([]);
  }
});

test("lengths have their unit, and those of what is made millimetres", () => {
  const said = (code: string, args: Finding["args"]) =>
    findingWords(finding(code, args), [], "in").replaceAll("\u00a0", " ");
  expect(said("no-room", { ...ARGS, what: "ring-too-wide" })).toBe("A ring 0.4 in wide has no room within the foot.");
  expect(said("ceiling", { what: "underside", heightMm: 12 })).toMatch(/^The underside is up to 12 mm above/);
  // Nobody knows the unit of a refusal without its design.
  expect(whyWords({ code: "no-room", path: "", message: "", args: { what: "tip", base: 0.3 } })).toMatch(
    /base of 0\.3\./,
  );
});

test("patches with a free edge are told what makes a body of them", () => {
  expect(findingWords(finding("open-surface", { what: "free-edge" }), [], "cm")).toContain("a thickness, under Wall");
});

test("what fine triangles alone run into says so", () => {
  const said = findingWords(finding("crosses-itself", { what: "surface", bound: 0.01 }), [], "cm");
  expect(said.replaceAll("\u00a0", " ")).toBe(
    "The surface runs through itself. Triangles within 0.01 cm step over it.",
  );
});

test("why something holds nothing is said in the words of the page", () => {
  const codes = ["solid", "open-surface", "no-opening", "crosses-itself", "no-foot", "no-bottom", "dry", "too-long"];
  const part = (capacityCause: object) =>
    ({ parts: [{ capacityCause, capacityReason: LIBRARY }] }) as unknown as Measures;
  for (const code of codes) {
    speak(PSEUDO_ENGLISH);
    expect(unchanged(emptyReason(part({ code, path: null, args: {} }), "cm")), code).toEqual([]);
  }
  // What keeps it from being a pot keeps it dry.
  speak(ENGLISH);
  const crossed = part({ code: "crosses-itself", path: null, args: { what: "surface" } });
  expect(emptyReason(crossed, "cm")).toBe("The surface runs through itself.");
});

test("no reason of the crate is missing here", () => {
  const all = sources(new URL("../../../crates/pasu/src/", import.meta.url)).join("\n");
  const named = [...all.matchAll(/\.with\("what", "([a-z-]+)"\)/g)].map(([, what]) => what ?? "");
  // Of a design that no link holds the keeper of the address speaks; rays and points are asked for by programs alone.
  const known = [...Object.values(REASONS).flat(), "link", "ray", "point"];
  expect(named.length).toBeGreaterThan(15);
  expect(named.filter((what) => !known.includes(what))).toEqual([]);
  const dry = [...all.matchAll(/Dry::new\(\s*"([a-z-]+)"/g)].map(([, code]) => code ?? "");
  expect(new Set(dry)).toEqual(
    new Set(["solid", "open-surface", "no-opening", "crosses-itself", "no-foot", "no-bottom", "dry", "too-long"]),
  );
});
