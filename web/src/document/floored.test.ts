import { expect, test } from "vitest";
import { floored } from "./floored";
import { ringed } from "./ringed";
import type { Design, Part } from "./types";

const shape = ringed([4, 6, [5, { n: 3, cos: 0.2 }]], [1, 5, 9], { a: 0.5 });
const wall = { thickness: 0.3, base: 0.4 };
const of = (part: Part): Design => ({ pasu: 1, parts: [part] });

test("the floor goes round with the foot, in the same place and the same glaze", () => {
  const foot = { mean: 4, waves: [{ n: 4, cos: 0.3 }] };
  const [first, ...above] = shape.rings;
  const pot = {
    shape: { ...shape, rings: [{ u: 0, z: { mean: 1 }, ...first, r: foot }, ...above] },
    wall,
  } satisfies Part;
  const [, floor] = floored(of({ ...pot, place: { shift: [1, 2, 3] }, look: { glaze: "shino" } })).parts;
  expect(floor).toMatchObject({
    place: { shift: [1, 2, 3] },
    look: { glaze: "shino" },
    shape: { kind: "rings", a: 0.5 },
  });
  expect(floor?.shape.kind === "rings" && floor.shape.rings).toEqual([
    { u: 0, r: { mean: 0.08 }, z: { mean: 1 } },
    { u: 1, r: foot, z: { mean: 1 } },
  ]);
  expect(floor?.wall).toBeUndefined();
});

test("a surface, a tube and what is no pot of rings stay as they are", () => {
  for (const part of [
    { shape },
    { shape, wall: { ...wall, base: 0 } },
    { shape: { kind: "second-order", r: [4, 0, 3, 0] }, wall },
  ] satisfies Part[]) {
    const design = of(part);
    expect(floored(design)).toBe(design);
  }
});
