import { beforeEach, expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { realSolver } from "../../testing/real-solver";
import { moved, rowOf, taller, withPart } from "../../testing/row";
import type { Design, Placement } from "../document/types";
import type { Desk, SolveOptions } from "./desk";
import type { Solved } from "./solved";

const MANY = 20;
const ROW = rowOf(MANY);
const IDS = ROW.parts.map((_, index) => 100 + index);
const GRID = { rows: 13, columns: 25 };
const REST: SolveOptions = { ...GRID, lines: false, section: null, settle: true };
const HAND: SolveOptions = { ...REST, settle: false };

let worker: ReturnType<typeof realSolver>["worker"];
let solver: ReturnType<typeof realSolver>["solver"];
let desk: Desk;

beforeEach(() => {
  ({ solver, worker } = realSolver({ free: true }));
  desk = solver.desk();
});

async function solved(design: Design, options: SolveOptions, ids = IDS): Promise<Solved> {
  const outcome = await desk.solve({ design, ids }, options);
  if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
  return outcome.value;
}

/** The parts that were asked for since it was last looked, message by message, and those of which a mesh was. */
function asked(): { readonly parts: readonly number[]; readonly meshes: readonly number[]; readonly whole: boolean }[] {
  return worker.sent.splice(0).map(({ ask }) => {
    if (ask.kind !== "parts") throw new Error(ask.kind);
    const meshes = ask.parts.filter(({ mesh }) => mesh);
    return { parts: ask.parts.map(({ id }) => id), meshes: meshes.map(({ id }) => id), whole: ask.whole !== null };
  });
}

test("of twenty parts the one whose number changes is solved and sent, and no other", async () => {
  const before = await solved(ROW, REST);
  expect(asked()).toEqual([{ parts: IDS, meshes: IDS, whole: true }]);
  const now = await solved(withPart(ROW, 7, taller(3)), HAND);
  expect(asked()).toEqual([{ parts: [107], meshes: [107], whole: false }]);
  const others = (all: Solved) => all.parts.filter(({ id }) => id !== 107);
  for (const [index, part] of others(now).entries()) {
    expect(part.mesh).toBe(others(before)[index]?.mesh);
    expect(part.revision).toBe(others(before)[index]?.revision);
  }
  expect(now.parts[7]?.revision).not.toBe(before.parts[7]?.revision);
  // At rest the one that was drawn in haste is asked for again, and what is known of the whole.
  await solved(withPart(ROW, 7, taller(3)), REST);
  const [rest, ...more] = asked();
  expect(more).toEqual([]);
  expect(rest).toEqual({ parts: [107], meshes: [107], whole: true });
});

test("a part that is moved is a matrix: under the hand nothing is asked, and at rest no mesh", async () => {
  const before = await solved(ROW, REST);
  asked();
  const there = withPart(ROW, 3, moved({ shift: [9, 4, 0.5] }));
  const now = await solved(there, HAND);
  expect(asked()).toEqual([]);
  expect(now.parts.map(({ mesh }) => mesh)).toEqual(before.parts.map(({ mesh }) => mesh));
  expect(now.parts[3]?.mesh).toBe(before.parts[3]?.mesh);
  expect(now.parts[3]?.matrix.slice(12)).toEqual([9, 4, 0.5, 1]);
  expect(now.times).toBeNull();
  expect(now.bounds?.max[1]).toBeCloseTo((before.bounds?.max[1] ?? Number.NaN) + 4, 5);
  expect(now.facts?.depth).toBeGreaterThan((before.facts?.depth ?? Number.NaN) + 3);
  const rest = await solved(there, REST);
  expect(asked()).toEqual([{ parts: [], meshes: [], whole: true }]);
  expect(rest.parts[3]?.mesh).toBe(before.parts[3]?.mesh);
  expect(rest.link).not.toBe(before.link);
});

test("names, glazes and the order of parts are no matter of meshes, and one that goes or comes is one's own", async () => {
  const before = await solved(ROW, REST);
  asked();
  const named = withPart(ROW, 2, (part) => ({ ...part, name: "Lid", look: { glaze: "cobalt" } }));
  await solved(named, REST);
  expect(asked()).toEqual([{ parts: [], meshes: [], whole: true }]);
  const [first, second] = ROW.parts;
  if (!first || !second) throw new Error("no parts");
  const swapped = { ...ROW, parts: [second, first, ...ROW.parts.slice(2)] };
  const turned = await solved(swapped, REST, [101, 100, ...IDS.slice(2)]);
  expect(asked()).toEqual([{ parts: [], meshes: [], whole: true }]);
  expect(turned.parts[0]?.mesh).toBe(before.parts[1]?.mesh);
  const less = { ...ROW, parts: ROW.parts.toSpliced(4, 1) };
  await solved(less, REST, IDS.toSpliced(4, 1));
  expect(asked()).toEqual([{ parts: [], meshes: [], whole: true }]);
  const more = { ...ROW, parts: ROW.parts.toSpliced(5, 0, { ...first, place: { shift: [0, 3, 0] } }) };
  await solved(more, REST, IDS.toSpliced(5, 0, 200));
  expect(asked().flatMap(({ meshes }) => meshes)).toEqual([104, 200]);
});

test("a part that is turned or stretched is shown at once, and looked at anew when it rests", async () => {
  await solved(ROW, REST);
  asked();
  const there = withPart(ROW, 3, moved({ scale: [1, 1, 2], shift: [9, 0, 0] }));
  const now = await solved(there, HAND);
  expect(asked()).toEqual([]);
  expect(now.bounds?.max[2]).toBeCloseTo(2 * 2.03, 1);
  await solved(there, REST);
  expect(asked()).toEqual([{ parts: [103], meshes: [103], whole: true }]);
});

const PLACES: readonly Placement[] = [
  { shift: [1, 2, 3] },
  { scale: [1.5, 0.5, 2] },
  { axis: [0, 0, 1], angle: 0.7, shift: [0, 1, 0] },
  { axis: [0.6, 0.8, 0], angle: -1.1, scale: [2, 1, 1] },
  { scale: [1, -1, 1], axis: [0, 1, 0], angle: -Math.PI, shift: [4, 0, 0] },
];

test.each(PLACES)("a part stands where the crate puts it, and is said to be as large (%o)", async (place) => {
  const { mesh } = await import("pasu/drawing");
  // Neither a turn nor a mirror makes it its own image, so that its points have one place each.
  const wave = (n: number, cos: number, sin: number) => ({ n, cos, sin });
  const rings = [
    { u: 0, r: { mean: 1, waves: [wave(1, 0.1, 0), wave(2, 0.1, 0.05)] }, z: { mean: 0 } },
    { u: 1, r: { mean: 0.8, waves: [wave(3, 0, 0.1)] }, z: { mean: 2 } },
  ];
  const two = { ...ROW, parts: [...ROW.parts.slice(0, 1), { shape: { kind: "rings", rings }, place }] } as Design;
  const { parts, bounds, facts } = await solved(two, REST, [1, 2]);
  const whole = mesh(two as Parameters<typeof mesh>[0], GRID);
  const [, part] = parts;
  if (!part) throw new Error("no part");
  const first = GRID.rows * GRID.columns;
  const m = (i: number) => part.matrix[i] as number;
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const [i, value] of whole.positions.entries()) {
    min[i % 3] = Math.min(min[i % 3] as number, value);
    max[i % 3] = Math.max(max[i % 3] as number, value);
  }
  for (let v = 0; v < first; v += 1) {
    const [x, y, z] = part.mesh.positions.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
    for (const axis of [0, 1, 2]) {
      const there = m(axis) * x + m(4 + axis) * y + m(8 + axis) * z + m(12 + axis);
      expect(there).toBeCloseTo(whole.positions[3 * (first + v) + axis] as number, 4);
    }
  }
  for (const axis of [0, 1, 2] as const) {
    expect(bounds?.min[axis]).toBeCloseTo(min[axis] as number, 4);
    expect(bounds?.max[axis]).toBeCloseTo(max[axis] as number, 4);
  }
  expect(facts?.height).toBeCloseTo((max[2] as number) - (min[2] as number), 4);
  // Nothing is farther from the middle than is said.
  const { centre = [0, 0, 0], radius = 0 } = bounds ?? {};
  for (let v = 0; v < whole.positions.length; v += 3) {
    const far = Math.hypot(...[0, 1, 2].map((i) => (whole.positions[v + i] as number) - (centre[i] as number)));
    expect(far).toBeLessThan(radius + 1e-4);
  }
});

test("what is refused is named by its place in the whole design, and what concerns all is refused as well", async () => {
  await solved(ROW, REST);
  const bad = withPart(ROW, 3, taller(Number.POSITIVE_INFINITY));
  for (const options of [HAND, REST]) {
    const outcome = await desk.solve({ design: bad, ids: IDS }, options);
    expect(outcome).toMatchObject({ state: "refused", refusal: { path: "parts[3].shape.height" } });
  }
  const named = withPart(
    withPart(ROW, 1, (part) => ({ ...part, name: "Lid" })),
    5,
    (part) => ({ ...part, name: "Lid" }),
  );
  expect(await desk.solve({ design: named, ids: IDS }, REST)).toMatchObject({
    state: "refused",
    refusal: { path: "parts[5].name" },
  });
  const flat = withPart(ROW, 2, moved({ scale: [1, 1, 0] }));
  for (const options of [HAND, REST]) {
    expect(await desk.solve({ design: flat, ids: IDS }, options)).toMatchObject({
      state: "refused",
      refusal: { path: "parts[2].place.scale[2]" },
    });
  }
});

test("the section of another part is all that is sent for it, and once", async () => {
  await solved(ROW, { ...REST, section: 0 });
  asked();
  const { section } = await solved(ROW, { ...REST, section: 4 });
  expect(asked()).toEqual([{ parts: [104], meshes: [], whole: false }]);
  expect(section?.right.length).toBeGreaterThan(0);
  expect((await solved(ROW, { ...REST, section: 0 })).section).not.toBeNull();
  expect(asked()).toEqual([]);
});

test("every part has its lines where it stands, and its rim and its foot", async () => {
  const { lines } = await solved(ROW, { ...REST, lines: true });
  expect(lines).toHaveLength(MANY);
  const [first, second] = [lines?.[0]?.iso_u[0], lines?.[1]?.iso_u[0]];
  expect((second?.[0] ?? 0) - (first?.[0] ?? 0)).toBeCloseTo(3, 4);
  for (const { tangents, rim, foot } of lines ?? []) {
    expect(tangents).toHaveLength(48);
    expect(rim[2]).toBeGreaterThan(foot[2] ?? Number.NaN);
  }
});

test("two desks keep out of each other's way, and what one shows is not written over", async () => {
  const other = solver.desk();
  const first = await solved(ROW, REST);
  const outcome = await other.solve({ design: withPart(ROW, 0, taller(5)), ids: IDS }, REST);
  if (outcome.state !== "done") throw new Error(outcome.state);
  asked();
  // Still the newest of its part: it stays.
  for (const { mesh } of first.parts) desk.recycle(mesh);
  await solved(withPart(ROW, 0, taller(6)), HAND);
  await settled();
  expect(worker.sent[0]?.spares).toEqual([null]);
  expect(first.parts[1]?.mesh.positions.length).toBe(3 * GRID.rows * GRID.columns);
});
