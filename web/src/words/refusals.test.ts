import { readFileSync } from "node:fs";
import initWhole, { parse as parseWhole } from "pasu";
import init, { mesh, PasuError, parse } from "pasu/drawing";
import { beforeAll, expect, test } from "vitest";
import type { Design, Refusal } from "../document/types";
// What only makers refuse.
import "./making";
import { refusalWords, whyWords } from "./refusals";

beforeAll(() => init());

/** What the library says of a document, as the worker hands it on. */
function refusalOf(document: unknown): Refusal {
  try {
    const design = parse(typeof document === "string" ? document : JSON.stringify(document));
    mesh(design, { rows: 33, columns: 65 });
  } catch (error) {
    if (error instanceof PasuError) return error;
    throw error;
  }
  throw new Error("accepted");
}

const shape = { kind: "second-order", r: [1, 0.1, 0.6, 0.06] } as const;
const design = (change: object, part: object = {}) =>
  ({ pasu: 1, parts: [{ shape: { ...shape, ...change }, ...part }] }) as unknown as Design;

test("a number out of its range is told by its name, and by what it has to be", () => {
  const wrong = design({ s: [1, 0] });
  expect(refusalWords(refusalOf(wrong), wrong)).toBe("Wall stiffness: It has to be a number other than 0, and is 0.");
});

test("a limit of a slider is told by the label of that, and as it is called beside its field", () => {
  const labelled = design({}, { joints: { z: { label: "Lift the lid", limits: [5, 1] } } });
  const told = refusalWords(refusalOf(labelled), labelled);
  expect(told.replaceAll(/[\u2066-\u2069]/g, "")).toMatch(/^Slider, “Lift the lid”, To: It has to be /);
  const plain = design({}, { joints: { turn: { limits: [1, 1] } } });
  expect(refusalWords(refusalOf(plain), plain)).toMatch(/^Slider, To: It has to be /);
});

test("what is wrong in one of several parts is told with the part's name, of a document that was not opened with its number", () => {
  const one = design({});
  const [part] = one.parts;
  const wrong = {
    ...one,
    parts: [part, { ...part, name: "Lid", shape: { ...shape, s: [0, 1] } }],
  } as unknown as Design;
  const refusal = refusalOf(wrong);
  expect(refusalWords(refusal, wrong)).toMatch(/^Lid, Wall stiffness: /);
  expect(refusalWords(refusal)).toMatch(/^Part 2, “s\[0\]”: /);
});

test("what is wrong in a network, an octant or a placement is told by what the page calls that", async () => {
  await initWhole();
  const frame = [0, 1, 2, 3, 4, 5, 6, 7];
  const vertices = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [Math.cos(i), Math.sin(i), i]);
  const part = (more: object, place: object = {}) =>
    ({
      pasu: 1,
      parts: [{ name: "Leaf", shape: { kind: "vertex-frame", vertices, ...more }, place }, design({}).parts[0]],
    }) as unknown as Design;
  const patch = (more: object) => part({ patches: [{ frame }, { frame, ...more }] });
  const force = (more: object) => patch({ forces: [{ f0: [0, 0, 1], ...more }] });
  const octant = { pasu: 1, parts: [{ shape: { kind: "octant", exponents: [2, 0.01, 2] } }] } as unknown as Design;
  for (const [wrong, said] of [
    [force({ u: [0.5, 0.2] }), "Leaf, patch 2, force 1, u to: It has to be a number greater than 0.5, and is 0.2."],
    [
      force({ f0: [0, Number.NaN, 0] }),
      "Leaf, patch 2, force 1, strength, in y: It has to be a number that can be computed with.",
    ],
    [force({ falloff: "cubic" }), "Leaf, patch 2, force 1, falls off: It has to be sine or smooth, and is “cubic”."],
    [
      patch({ a1: [1, Number.NaN, 1] }),
      "Leaf, patch 2, along u, in y: It has to be a number that can be computed with.",
    ],
    [
      patch({ frame: [0, 1, 2, 3, 4, 5, 6, 9] }),
      "Leaf, patch 2, number of its point 8: It has to be a number from 0 to 7, and is 9.",
    ],
    [
      patch({ frame: [0, 1, 2] }),
      "Leaf, patch 2, its points: Expected a list of 8 numbers of vertices, found a list of 3.",
    ],
    [part({ patches: [] }), "Leaf, patches: Expected a list of 1 to 100000 patches, found an empty list."],
    [
      part({ vertices: [[0, 0, Number.NaN]], patches: [] }),
      "Leaf, point 1, in z: It has to be a number that can be computed with.",
    ],
    [
      part({ patches: [{ frame }] }, { scale: [1, 0, 1] }),
      "Leaf, scale along y: It has to be a number other than 0, and is 0.",
    ],
    [
      part({ patches: [{ frame }] }, { shift: [0, 0, Number.NaN] }),
      "Leaf, moved along z: It has to be a number that can be computed with.",
    ],
    [octant, "Exponent of y: It has to be a number from 0.05 to 50, and is 0.01."],
  ] as const) {
    let refusal: Refusal | null = null;
    try {
      parseWhole(wrong as never);
    } catch (error) {
      refusal = error as PasuError;
    }
    expect(refusal && refusalWords(refusal, wrong).replaceAll(/[\u2066-\u2069]/g, "")).toBe(said);
  }
});

test("no sentence begins with a path, a code or brackets", () => {
  const hostile = [
    design({ foo: 1 }),
    design({ r: [1, 2, 3] }),
    design({ r: [1, 0.1, 0.6, "wide"] }),
    design({ height: 1e308 }),
    design({ kind: "teapot" }),
    design({}, { wall: { thickness: -1, base: 0 } }),
    design({}, { look: { glaze: "gold" } }),
    { beach: true },
    { pasu: 99, parts: [] },
    { pasu: 1, title: "x".repeat(300), parts: [{ shape }] },
    "milk, eggs",
    "#1~AAAA",
    "",
  ];
  for (const document of hostile) {
    const words = refusalWords(refusalOf(document));
    expect(words).toMatch(/^[\p{Lu}“].*[.!?]$/su);
    expect(words).not.toMatch(/parts\[|shape\.|undefined|null|NaN/);
    // What was wrong is read before where.
    expect(words.split(": ")[0]).not.toMatch(/[[\]{}].*[[\]{}].*[[\]]/);
  }
  expect(refusalWords(refusalOf(design({}, { look: { glaze: "gold" } })))).toContain("“gold”");
  expect(refusalWords(refusalOf({ beach: true }))).toBe("“pasu”: It is missing.");
});

test("what runs beyond numbers is told without rows and columns", () => {
  const refusal: Refusal = {
    code: "overflow",
    path: "parts[0]",
    message: "the surface runs beyond what a mesh can hold at row 1, column 0; numbers up to 3e38 can be held",
  };
  expect(refusalWords(refusal, design({}))).toBe(
    "Its numbers grow so large that they cannot be computed. Smaller ones can.",
  );
});

test("waves in free boundary data are told by their equation and how many they are", () => {
  const free = {
    kind: "boundary-value",
    span: "2pi",
    x: { order: 2, s: 1, t: 0, modes: [{ n: 3, cos: { start: 1 } }] },
    y: { order: 2, s: 1, t: 0, modes: [] },
    z: { order: 2, s: 1, t: 0, modes: [] },
  };
  const refusal: Refusal = {
    code: "resonant-problem",
    path: "parts[0].shape.x.modes[0]",
    message: "no",
    args: { n: 3 },
  };
  expect(refusalWords(refusal, { pasu: 1, parts: [{ shape: free }] } as unknown as Design)).toMatch(
    /^Equation of x, wave 3: The equation swings/,
  );
});

test("waves of which there are too many to be made are told with what they are good for", () => {
  const args = { greatest: 4096, found: 10000 };
  const refusal: Refusal = { code: "too-large", path: "parts[0].shape.n[1]", message: "no", args };
  expect(refusalWords(refusal, design({}))).toBe(
    "Petals: A pot that is measured or made has at most 4096 waves round it, and this has 10000: it can only be drawn.",
  );
  expect(whyWords({ ...refusal, path: "title" })).toBe("There are 10000; at most 4096 are possible.");
  expect(whyWords({ ...refusal, path: "parts[0].shape.x", args: { ...args, component: "x" } })).toMatch(
    /^The equation of x changes too fast/,
  );
});

test("a code without words of its own speaks in the library's, as a sentence", () => {
  const refusal: Refusal = { code: "of-tomorrow", path: "", message: "the clay is still wet" };
  expect(whyWords(refusal)).toBe("The clay is still wet.");
  // So does one whose arguments are not there.
  expect(whyWords({ ...refusal, code: "out-of-range" })).toBe("The clay is still wet.");
});

test("every code of the library has words or is known to speak in the library's", () => {
  const declared = readFileSync(new URL("../../../crates/pasu-wasm/js/pasu.d.ts", import.meta.url), "utf8");
  const codes = [...(/type PasuErrorCode =([^;]*);/.exec(declared)?.[1] ?? "").matchAll(/"([a-z-]+)"/g)].map(
    ([, code]) => code,
  );
  expect(codes.length).toBeGreaterThan(20);
  const args = { found: 3, least: 0, greatest: 2, words: ["one"] };
  const said = (code: string) =>
    whyWords({
      code,
      path: "",
      message: "in other words",
      args: code.startsWith("unknown") ? { ...args, found: "three" } : args,
    });
  const library = codes.filter((code) => said(code ?? "") === "In other words.");
  // These name too little here for a sentence without the library's: which field it was, where a link broke; which of several things it is that is in the way, of which `findings.test.ts` knows all.
  expect(library).toMatchInlineSnapshot(`
    [
      "not-json",
      "duplicate",
      "wrong-type",
      "unknown-version",
      "unsupported-shape",
      "damaged-link",
      "no-such-point",
      "open-surface",
      "pinched-surface",
      "crosses-itself",
      "no-room",
      "not-ready",
      "cancelled",
      "busy",
      "bug",
    ]
  `);
});
