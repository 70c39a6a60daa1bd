import { expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { FORMS } from "./forms";
import { designOf } from "./gallery/exhibit";
import { RINGED } from "./gallery/rings";
import { inUnitOf, type Mixed, mixable, mixedDesign, mixedRings, places, through, wanted } from "./mixing";
import { ringed, wave } from "./ringed";
import type { Design, Rings } from "./types";

const { solver } = realSolver({ free: true });

const LOW = ringed([4, 7, 5.5, 4], [0, 3, 6, 8], { a: 0.5 });
const TALL = ringed([3.5, 5, 6, 2.5, 1.8, 2.2], [0, 5, 11, 16, 20, 24], { a: 0.5 });

const ALL = new Float64Array(
  Array.from({ length: 40 }, (_, i) => i / 39).flatMap((u) => Array.from({ length: 9 }, (_, j) => [u, 0.7 * j]).flat()),
);

async function points(shape: Rings, at = ALL): Promise<Float64Array> {
  const read = await solver.read(`points ${JSON.stringify(shape)}`, shape, at);
  if (read.state !== "done") throw new Error(JSON.stringify(read));
  return read.value.points;
}

async function both(one: Rings, other: Rings): Promise<Mixed> {
  const us = places(one, other);
  if (!us) throw new Error("too many rings");
  const [foot, rim] = [Boolean(one.foot ?? other.foot), Boolean(one.rim ?? other.rim)];
  const put = async (shape: Rings) => {
    const at = wanted(shape, us);
    const read = await solver.read(`both ${JSON.stringify(shape)}`, shape, at.at);
    if (read.state !== "done") throw new Error(JSON.stringify(read));
    return through(shape, at, read.value, { foot, rim });
  };
  return { mine: await put(one), theirs: await put(other) };
}

/** How far two surfaces are apart at most, point by point. */
const apart = (a: Float64Array, b: Float64Array) =>
  a.reduce((most, value, i) => Math.max(most, Math.abs(value - (b[i] ?? 0))), 0);

test("both ends are the two pots, and the middle is their mean, all over the surface", async () => {
  const mixed = await both(LOW, TALL);
  expect(mixed.mine.rings.map(({ u }) => u)).toEqual(mixed.theirs.rings.map(({ u }) => u));
  expect(mixed.mine.rings.length).toBe(8);
  const [low, tall] = [await points(LOW), await points(TALL)];
  expect(apart(await points(mixedRings(mixed, 0)), low)).toBeLessThan(1e-9);
  expect(apart(await points(mixedRings(mixed, 1)), tall)).toBeLessThan(1e-9);
  expect(
    apart(
      await points(mixedRings(mixed, 0.5)),
      low.map((value, i) => (value + (tall[i] ?? 0)) / 2),
    ),
  ).toBeLessThan(1e-9);
  expect(apart(low, tall)).toBeGreaterThan(10);
});

test("so they are with slopes at an end of one, which the other is given as it has them", async () => {
  const sloped: Rings = {
    ...TALL,
    foot: { r: { mean: 9 }, z: { mean: 14 } },
    rim: { r: { mean: 5 }, z: { mean: 20 } },
  };
  const mixed = await both(LOW, sloped);
  expect(mixed.theirs.foot).toBe(sloped.foot);
  expect(apart(await points(mixed.mine), await points(LOW))).toBeLessThan(1e-9);
  const mean = (await points(LOW)).map((value) => value / 2);
  const other = await points(sloped);
  expect(
    apart(
      await points(mixedRings(mixed, 0.5)),
      mean.map((value, i) => value + (other[i] ?? 0) / 2),
    ),
  ).toBeLessThan(1e-9);
});

test("waves are mixed as numbers; what a new ring cannot keep of them is of their square", async () => {
  for (const depth of [0.4, 0.04]) {
    const wavy = ringed([4, [7, wave(3, depth)], [5.5, wave(3, depth, 0.1), wave(5, depth / 2)], 4], [0, 3, 6, 8], {
      a: 0.5,
    });
    const mixed = await both(wavy, TALL);
    // Its own rings are what they were, to the bit.
    for (const hoop of wavy.rings) expect(mixed.mine.rings).toContainEqual(hoop);
    const shift = apart(
      (await points(mixed.mine)).map((_, i, all) => distance(all, i)),
      (await points(wavy)).map((_, i, all) => distance(all, i)),
    );
    expect(shift).toBeLessThan(0.35 * depth * depth + 1e-9);
    const half = mixedRings(mixed, 0.5).rings[1];
    const [one, other] = [mixed.mine.rings[1], mixed.theirs.rings[1]];
    expect(half?.r.waves?.[0]?.cos).toBeCloseTo(
      ((one?.r.waves?.[0]?.cos ?? 0) + (other?.r.waves?.[0]?.cos ?? 0)) / 2,
      11,
    );
  }
});

/** From the axis, at the point that a number belongs to: what moves round the axis does not count. */
const distance = (all: Float64Array, i: number) => {
  const at = 3 * Math.floor(i / 3);
  return i % 3 === 2 ? (all[i] ?? 0) : Math.sqrt((all[at] ?? 0) ** 2 + (all[at + 1] ?? 0) ** 2);
};

test("which rings are sharp is as in the nearer pot", async () => {
  const sharp: Rings = { ...LOW, rings: LOW.rings.map((hoop, at) => (at === 1 ? { ...hoop, sharp: true } : hoop)) };
  const mixed = await both(sharp, TALL);
  const count = (share: number) => mixedRings(mixed, share).rings.filter((hoop) => hoop.sharp).length;
  expect([0, 0.49, 0.5, 1].map(count)).toEqual([1, 1, 0, 0]);
  expect(apart(await points(mixedRings(mixed, 0)), await points(sharp))).toBeLessThan(1e-9);
});

test("rings nearly at the same place are one, and more than a document may have are none", () => {
  const moved: Rings = {
    ...LOW,
    rings: LOW.rings.map((hoop, at) => (at === 1 ? { ...hoop, u: hoop.u + 5e-5 } : hoop)),
  };
  expect(places(LOW, moved)).toEqual(LOW.rings.map(({ u }) => u));
  const many = (shift: number): Rings => ({
    ...LOW,
    rings: Array.from({ length: 40 }, (_, i) => ({
      u: i === 0 || i === 39 ? i / 39 : (i + shift) / 39,
      r: { mean: 4 },
      z: { mean: i },
    })),
  });
  expect(places(many(0), many(0))?.length).toBe(40);
  expect(places(many(0), many(0.5))).toBeNull();
});

test("a design keeps its title, its place and its unit; wall and glaze come along", async () => {
  const mine: Design = {
    pasu: 1,
    title: "Mine",
    parts: [
      {
        shape: LOW,
        wall: { thickness: 0.2, base: 0.4, drain: 1 },
        place: { shift: [1, 2, 0] },
        look: { glaze: "shino" },
      },
    ],
  };
  const theirs: Design = {
    pasu: 1,
    unit: "mm",
    parts: [{ shape: TALL, wall: { thickness: 6, base: 8, foot: [5, 4] }, look: { glaze: "cobalt" } }],
  };
  const other = inUnitOf(mine, theirs);
  const tall = mixable(other);
  expect(tall?.rings[1]?.z.mean).toBe(0.5);
  const mixed = await both(LOW, tall ?? LOW);
  expect(mixedDesign(mine, other, mixed, 0)).toBe(mine);
  const nearly = mixedDesign(mine, other, mixed, 0.25);
  expect(nearly).toMatchObject({
    title: "Mine",
    parts: [{ place: { shift: [1, 2, 0] }, look: { glaze: "shino" }, wall: { thickness: 0.3, base: 0.5, drain: 1 } }],
  });
  const most = mixedDesign(mine, other, mixed, 0.75);
  expect(most.parts[0]?.look).toEqual({ glaze: "cobalt" });
  expect(most.parts[0]?.wall).toEqual({ thickness: 0.5, base: 0.7, foot: [0.5, 0.4] });
  const whole = mixedDesign(mine, other, mixed, 1).parts[0];
  expect(whole).toEqual({ ...other.parts[0], place: { shift: [1, 2, 0] } });
});

test("what is no single pot of rings is not mixed", () => {
  expect(mixable({ pasu: 1, parts: [{ shape: LOW }, { shape: TALL }] })).toBeNull();
  expect(mixable({ pasu: 1, parts: [{ shape: { kind: "second-order", r: [1, 0, 1, 0] } }] })).toBeNull();
});

test("every form and every pot of the gallery is itself through the rings of another", async () => {
  for (const exhibit of [...FORMS, ...RINGED]) {
    const shape = mixable(designOf(exhibit));
    if (!shape) throw new Error(exhibit.id);
    const { mine } = await both(shape, TALL);
    const [before, after] = [await points(shape), await points(mine)];
    // A twentieth of a millimetre.
    expect(apart(before, after), exhibit.id).toBeLessThan(0.005);
  }
});
