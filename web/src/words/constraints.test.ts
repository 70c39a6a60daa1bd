import { afterEach, expect, test } from "vitest";
import type { Breach, Constraints, Design, Finding, Report } from "../document/types";
import { ENGLISH, speak } from "../language";
import { breachWords, keptWords, withoutPairs, withScene, witnessWords } from "./constraints";
import { PSEUDO_ENGLISH } from "./pseudo";

afterEach(() => speak(ENGLISH));

const octant = { kind: "octant", exponents: [2, 2, 2] } as const;
const DESIGN: Design = {
  pasu: 1,
  unit: "in",
  parts: [
    { name: "Jar", shape: octant },
    { shape: octant, object: 1 },
  ],
};

const breach = (code: string, more: Partial<Breach> = {}): Breach => ({
  code,
  severity: "error",
  part: 1,
  other: 0,
  group: [1],
  message: "what the library says in English",
  args: {},
  at: [0, 0, 0],
  distance: 0.1234,
  isProved: true,
  ...more,
});

/** Everything that `docs/scenes.md` lists. */
const CODES = [
  "interference",
  "not-connected",
  "within",
  "same-place",
  "contact",
  "undecided-interference",
  "undecided-connection",
  "undecided-within",
];

test("every report is in words of the page, with the names of both parts", () => {
  for (const code of CODES) {
    const text = breachWords(breach(code), DESIGN);
    expect(text).toContain("Jar");
    expect(text).toContain("Part 2");
    expect(text).not.toContain("library");
    expect(text).toMatch(/\.$/);
  }
  expect(breachWords(breach("of a later version"), DESIGN)).toBe("What the library says in English.");
  speak(PSEUDO_ENGLISH);
  for (const code of CODES)
    expect(breachWords(breach(code), { ...DESIGN, parts: [{ shape: octant }] })).not.toMatch(/[a-z]{4}/i);
});

test("a group that hangs together is named, and of a large one the first and how many more", () => {
  const parts = ["Jar", "Knob", "Lid", "Ring", "Ball", "Bead"].map((name) => ({ name, shape: octant }));
  const of = (group: readonly number[], code = "not-connected") =>
    breachWords(breach(code, { part: 2, group }), { ...DESIGN, parts });
  expect(of([2])).toBe(
    "Lid is glued to Jar, but is 0.12\u00a0in away from it at least. Move it there, or let it be an object of its own.",
  );
  expect(of([1, 2, 3])).toBe(
    "Knob, Lid, and Ring hang together and are glued to Jar, but Lid is 0.12\u00a0in away from it at least. Move them there, or let them be an object of their own.",
  );
  expect(of([1, 2, 3, 4, 5])).toContain("Knob, Lid, Ring, and 2 more hang together");
  expect(of([1, 2], "undecided-connection")).toContain("Whether any of Knob and Lid touches Jar");
});

test("a bound is said to be one, in the unit of the design, and what was measured is about that", () => {
  expect(breachWords(breach("interference"), DESIGN)).toBe(
    "Part 2 runs into Jar. Move them apart, or glue them together.",
  );
  expect(breachWords(breach("not-connected", { isProved: false }), DESIGN)).toContain(
    "is about 0.12\u00a0in away from it.",
  );
  expect(breachWords(breach("not-connected"), DESIGN)).toContain("but is 0.12\u00a0in away from it at least.");
  expect(breachWords(breach("not-connected", { distance: null }), DESIGN)).toContain("but does not touch it.");
  expect(witnessWords(breach("not-connected"), DESIGN)).toBe("0.12\u00a0in");
  expect(witnessWords(breach("interference"), DESIGN)).toBe("Here");
});

test("nothing of a broken scene is called good, and of one that could not be told all the rest stays", () => {
  const good = { severity: "good", text: "Closed." } as const;
  const thin = { severity: "warning", text: "Thin." } as const;
  const found = (...breaches: readonly Breach[]): Constraints => ({ isKept: false, slack: 1e-6, breaches, leftOut: 0 });
  const broken = withScene(
    [thin, good],
    found(breach("interference"), breach("contact", { severity: "note" })),
    DESIGN,
  );
  expect(broken.map(({ severity }) => severity)).toEqual(["warning", "warning"]);
  expect(broken[0]?.text).toContain("runs into");
  const doubtful = withScene([good], found(breach("undecided-interference", { severity: "warning" })), DESIGN);
  expect(doubtful.map(({ severity }) => severity)).toEqual(["warning", "good"]);
  expect(withScene([good], found(), DESIGN)).toEqual([good]);
  // What is not listed is broken too.
  expect(withScene([good], { ...found(), leftOut: 1 }, DESIGN)).toEqual([]);
});

test("what is said of a scene that fits goes by what there is in it", () => {
  const scene = (...objects: readonly number[]): Design => ({
    pasu: 1,
    parts: objects.map((object) => ({ object, shape: octant })),
  });
  expect(keptWords(scene(0, 1))).toBe("No two objects run into each other.");
  expect(keptWords(scene(0, 0))).toBe("What is glued together touches.");
  expect(keptWords(scene(0, 0, 1))).toContain("and what is glued together touches.");
});

test("what the scene tells of two parts is not told of them again, and all else is", () => {
  const finding = (code: string, part: number, other: number) =>
    ({ code, part, args: { other } }) as unknown as Finding;
  const findings = [finding("overlap", 0, 1), finding("overlap", 2, 1), finding("ceiling", 0, 1)];
  const found = { isKept: false, slack: 1e-6, leftOut: 0, breaches: [breach("interference")] };
  expect(withoutPairs({ findings } as unknown as Report, found, DESIGN).findings).toEqual(findings.slice(1));
});

test("that what is glued runs into each other is no fault, and told once", () => {
  const touches = (part: number, other: number) =>
    ({ code: "overlap", severity: "warning", part, args: { what: "touches", other } }) as unknown as Finding;
  const scene: Design = { pasu: 1, parts: [0, 0, 1].map((object) => ({ object, shape: octant })) };
  const report = { findings: [touches(0, 1), touches(1, 0), touches(1, 2)] } as unknown as Report;
  const kept = { isKept: true, slack: 1e-6, leftOut: 0, breaches: [] };
  expect(withoutPairs(report, kept, scene).findings).toEqual([touches(1, 2)]);
  const warning = { severity: "warning", text: "thin" } as const;
  const good = { severity: "good", text: "closed" } as const;
  const told = withScene([warning, good], kept, scene, report);
  expect(told.map(({ severity }) => severity)).toEqual(["warning", "note", "good"]);
  expect(told[1]?.text).toMatch(/^Glued parts run into each other/);
  const apart = { pasu: 1, parts: scene.parts.map((part, object) => ({ ...part, object })) } as const;
  expect(withScene([good], kept, apart, report)).toEqual([good]);
});
