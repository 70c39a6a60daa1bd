// Works out what is written, from its text alone, and compares it with the solver.

import { evaluate } from "pasu/drawing";
import temml from "temml";
import { beforeAll, expect, test } from "vitest";
import { DOUBLES, fixed } from "../../testing/arithmetic";
import { Formulary } from "../../testing/latex";
import { library, type Reference, references } from "../../testing/references";
import { AXES } from "../document/boundary-value";
import { frozen } from "../document/path";
import type { BoundaryValue, Sent, TwoSided } from "../document/types";
import { closed } from "./closed";
import { differential } from "./differential";
import { edges } from "./edges";
import { problemOf } from "./posed";
import { fastest } from "./roots";
import { type Formula, type Hand, WHOLE } from "./writer";

const SHOWN: Hand = { ...WHOLE, digits: 5, marked: true };

beforeAll(library);

/** How far the surface that the text describes is from the solver's, by the size of the pot. */
function distance({ shape, points }: Pick<Reference, "shape" | "points">, hand: Hand, digits = 0): number {
  const form = closed(problemOf(shape), hand);
  const formulas = [...form.sums, ...form.solved.map(({ formula }) => formula), ...form.systems];
  const texts = formulas.map(({ tex }) => tex);
  const text = digits === 0 ? new Formulary(texts, DOUBLES) : new Formulary(texts, fixed(digits));
  const solved = evaluate({ pasu: 1, parts: [{ shape }] } as unknown as Sent, 0, points.flat());
  const scale = solved.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const errors = points.flatMap(([u, v], index) =>
    AXES.map((axis, place) => Math.abs(text.at(axis, u, v) - (solved[3 * index + place] ?? Number.NaN))),
  );
  return errors.reduce((most, error) => (error <= most ? most : error), 0) / scale;
}

/** How many binary digits it takes to work a form out as it is written: none beyond those of a double, unless its rates are next to nothing or one outgrows the other. */
function digitsFor({ shape }: Reference): number {
  const most = closed(problemOf(shape), WHOLE).solved.map(({ roots }) => {
    const rate = fastest(roots);
    if (roots.order === 2) return 0;
    const slowest = roots.kind === "two" && roots.pairs[1].z > 0 ? roots.pairs[1].rate : 0;
    const apart = roots.kind === "two" && roots.pairs[0].z > 0 ? rate - slowest : 0;
    const isLost = (rate > 0 && rate < 1e-2) || apart > 5 || rate > 150;
    return isLost ? 256 + Math.ceil(3 * rate) : 0;
  });
  return Math.max(0, ...most);
}

/** Whether a form is written at all. */
function isOpen({ shape }: Reference): boolean {
  return closed(problemOf(shape), WHOLE).solved.some(({ open }) => open);
}

for (const file of ["surfaces", "rings", "ring-regimes"] as const) {
  test(`the text of every surface of ${file}.json is what the solver has`, async () => {
    const all = await references(file);
    const written = all.filter((each) => !isOpen(each));
    // Forces on what is all but unbent.
    expect(all.length - written.length).toBeLessThanOrEqual(4);
    for (const reference of written) {
      const digits = digitsFor(reference);
      const some = { ...reference, points: reference.points.slice(0, digits === 0 ? 6 : 2) };
      expect(distance(some, WHOLE, digits), `${reference.name}, all digits`).toBeLessThan(1e-8);
      expect(distance(some, SHOWN, digits), `${reference.name}, five digits`).toBeLessThan(3e-4);
    }
  });
}

/** One of each kind, with everything that it can have. */
const KINDS: readonly TwoSided[] = [
  { kind: "second-order", r: [1, 0.1, 0.6, 0.06], n: [1, 8], force: [0.4, -0.7], t: [0.5, 0.9] },
  { kind: "mixed-order", r: [1, 0.1, 0.6, 0.06], rise: -10, s: [2, 1], force: [1, 0] },
  {
    kind: "fourth-order",
    r0: 0.4,
    r1: 0.3,
    rm: 0.8,
    h1: 2,
    eta: [0.5, -0.5],
    dz: [6, 3],
    s: [1, 1],
    t: [3, 1],
    w: [1, 2],
  },
  { kind: "bloor-wilson", a: 2.5, r: [1, 0.1, 0.1, 0.8], R: [-3, -0.5, -0.5, 2], h: [3, 0.3], H: [-0.5, -0.7], n1: 5 },
  {
    kind: "rings",
    a: 2,
    rings: [
      { u: 0, r: { mean: 4 }, z: { mean: 0 } },
      { u: 0.6, sharp: true, r: { mean: 6, waves: [{ n: 3, cos: 0.5, sin: -0.2 }] }, z: { mean: 8 } },
      { u: 0.8, r: { mean: 5 }, z: { mean: 11 } },
      { u: 1, r: { mean: 4.5 }, z: { mean: 14, waves: [{ n: 1, cos: 0.5, sin: 0.125 }] } },
    ],
    rim: { r: { mean: 2 }, z: { mean: 9 } },
  },
  {
    kind: "boundary-value",
    span: 3,
    rings: [{ u: 0.3 }, { u: 0.7, sharp: true }],
    x: {
      order: 4,
      s: 1,
      t: 2,
      w: 0.5,
      free: "start",
      modes: [{ n: 1, cos: { start: 1, end: 2, end_u: 1, rings: [3, 1], force: [1, 2, 3] } }],
    },
    y: { order: 2, s: 1, t: 2, modes: [{ n: 1, sin: { start: 1, end: 2, rings: [3, 1], force: [0, 5] } }] },
    z: { order: 4, s: 1, t: 0, w: 0, modes: [{ n: 0, cos: { end: 5, rings: [1, 2], force: [0.5] } }] },
  },
];

test("the text of one of each kind is what the solver has", () => {
  const points = [0, 0.17, 0.3, 0.5, 0.65, 0.9, 1].map((u, index) => [u, 0.4 * index] as const);
  for (const shape of KINDS) {
    expect(distance({ shape, points }, WHOLE), shape.kind).toBeLessThan(1e-9);
    expect(distance({ shape, points }, SHOWN), shape.kind).toBeLessThan(2e-5);
  }
});

/** All that is written of a shape. */
function everything(shape: TwoSided, hand: Hand): Formula[] {
  const problem = problemOf(shape);
  const form = closed(problem, hand);
  const given = edges(problem, hand).map(({ formula }) => formula);
  return [
    ...differential(problem, hand),
    ...given,
    ...form.sums,
    ...form.solved.map(({ formula }) => formula),
    ...form.systems,
  ];
}

test("everything that is written can be read as LaTeX, and speaks of numbers of the shape alone", () => {
  const trust = ({ command }: { command: string }) => command === "\\class";
  for (const shape of KINDS) {
    const places = new Set(placesOf(shape));
    for (const { tex, marks } of everything(shape, SHOWN)) {
      expect(temml.renderToString(tex, { throwOnError: true, trust }), tex).toContain("<math");
      for (const place of marks.flat()) expect(places, `${shape.kind}: ${place}`).toContain(place);
    }
    for (const { tex, marks } of everything(shape, WHOLE)) {
      expect(temml.renderToString(tex, { throwOnError: true, strict: true }), tex).toContain("<math");
      expect(tex).not.toContain("\\class");
      expect(marks).toEqual([]);
    }
  }
});

/** The place of every number of a shape that a person can set; what is left out of a family has one too. */
function placesOf(shape: TwoSided): string[] {
  const found: string[] = shape.kind === "second-order" || shape.kind === "mixed-order" ? ["height"] : [];
  for (const name of found.length > 0 ? ["s", "t", "n", "force"] : []) found.push(`${name}[0]`, `${name}[1]`);
  const visit = (node: unknown, path: string) => {
    if (typeof node === "number") found.push(path);
    else if (Array.isArray(node)) for (const [index, each] of node.entries()) visit(each, `${path}[${index}]`);
    else if (typeof node === "object" && node !== null) {
      for (const [key, each] of Object.entries(node)) visit(each, path === "" ? key : `${path}.${key}`);
    }
  };
  visit(shape, "");
  return found;
}

test("every number of every kind is somewhere in what is written", () => {
  for (const shape of KINDS) {
    const told = new Set(everything(shape, SHOWN).flatMap(({ marks }) => marks.flat()));
    const silent = placesOf(shape).filter((place) => !told.has(place));
    // The ends are 0 and 1 whatever happens.
    const expected = ["rings[0].u", "rings[3].u"];
    const orders = ["x.order", "y.order", "z.order"];
    const zero = silent.filter((place) => !expected.includes(place) && !orders.includes(place));
    expect(
      zero.filter((place) => numberOf(shape, place) !== 0),
      shape.kind,
    ).toEqual([]);
  }
});

function numberOf(shape: TwoSided, place: string): unknown {
  return place
    .split(/[.[\]]/)
    .filter((key) => key !== "")
    .reduce<unknown>((node, key) => (node as Record<string, unknown> | undefined)?.[key], shape);
}

test("of many waves the first are written, and how many there are more", () => {
  const modes = Array.from({ length: 128 }, (_, n) => ({ n, cos: { start: 1 / (n + 1) } }));
  const x = { order: 4, s: 1, t: 2, w: 1, modes } as const;
  const shape: BoundaryValue = frozen({ kind: "boundary-value", span: "2pi", x, y: x, z: x });
  const form = closed(problemOf(shape), { ...SHOWN, most: 6 });
  expect(form.solved.map(({ index }) => index)).toEqual([1, 2, 3, 4, 5, 6]);
  expect(form.hidden).toBe(122);
  expect(form.sums[0]?.tex.endsWith("+\\cdots")).toBe(true);
  expect(form.sums[0]?.tex.match(/q_/g)).toHaveLength(6);
  const all = closed(problemOf(shape), { ...SHOWN, most: 1000 });
  expect([all.hidden, all.solved.length, all.systems.length]).toEqual([0, 128, 128]);
});

test("a number is as long as its digits, with the decimal mark of the language", () => {
  const [first] = closed(problemOf(KINDS[0] as TwoSided), { ...SHOWN, decimal: "," }).solved;
  expect(first?.formula.tex).toContain("{4{,}4429}");
});

test("a force on what hardly bends is written with the digits that it takes, or left open", () => {
  const planar = (t: number): TwoSided => ({
    kind: "boundary-value",
    span: "2pi",
    x: { order: 2, s: 1, t, modes: [{ n: 1, cos: { start: 1, end: 2, force: [1, 3] } }] },
    y: { order: 2, s: 1, t: 1, modes: [] },
    z: { order: 2, s: 1, t: 1, modes: [{ n: 0, cos: { start: 1 } }] },
  });
  const points = [0, 0.3, 0.8, 1].map((u) => [u, 0.2] as const);
  for (const t of [0, 1e-6, 1e-4, 1e-2, 1, 100]) {
    expect(distance({ shape: planar(t), points }, SHOWN, 256), `t = ${t}`).toBeLessThan(3e-5);
    expect(distance({ shape: planar(t), points }, WHOLE, 256), `t = ${t}`).toBeLessThan(1e-9);
  }
  const [first] = closed(problemOf(planar(1e-12)), SHOWN).solved;
  expect(first?.open).toBe(true);
  expect(first?.formula.tex).toContain("q_{1}''-");
});
