import { expect, describe as group, test } from "vitest";
import { bodyOf, type Grid, isClosed } from "../document/body";
import { type Extents, extentsOf } from "../document/extents";
import { type Box, type Facts, factsOf } from "../document/facts";
import { boundsOf } from "../solver/bounds";
import { describe, describeAccuracy } from "./description";

/** A pot from its radius, height and ripple; `u = 0` is the rim. */
function pot(
  radius: (u: number, v: number) => number,
  height: (u: number, v: number) => number,
  turn = 1,
  columns = 121,
): Grid {
  const rows = 33;
  const positions = new Float32Array(3 * rows * columns);
  for (let i = 0; i < rows; i += 1) {
    for (let j = 0; j < columns; j += 1) {
      const u = i / (rows - 1);
      const v = (turn * 2 * Math.PI * j) / (columns - 1);
      const r = radius(u, v);
      positions.set([r * Math.cos(v), r * Math.sin(v), height(u, v)], 3 * (i * columns + j));
    }
  }
  return { positions, rows, columns };
}

const box = (grid: Grid) => boundsOf(grid.positions as Float32Array) as Box;
const facts = (grid: Grid, edges: Grid | null = grid) =>
  factsOf(
    [{ body: bodyOf(grid, edges), closed: isClosed(grid), lift: 0 }],
    box(grid),
    extentsOf(grid.positions) as Extents,
  );
const words = (grid: Grid) => describe(facts(grid) as Facts, "cm");
const up = (height: number) => (u: number) => height * (1 - u);

group("a pot in words", () => {
  test("a flared vase", () => {
    expect(words(pot((u) => 1.1 - 0.6 * u, up(3.6)))).toBe("A vase 3.6 cm high and 2.2 cm wide, widest at the rim.");
  });
  test("petals are counted as the eye counts them", () => {
    const text = words(pot((u, v) => 1 - 0.5 * u + 0.1 * Math.cos(8 * v), up(3)));
    expect(text).toContain("with 8 petals");
  });
  test("a thousand petals are counted where the grid is fine enough for them, and not guessed where there is none", () => {
    const many = (columns: number) => {
      return pot((u, v) => 1 - 0.5 * u + 0.1 * Math.cos(999 * v), up(3), 1, columns);
    };
    const [coarse, fine] = [many(121), many(16 * 999 + 1)];
    const said = (edges: Grid | null) => describe(facts(coarse, edges) as Facts, "cm");
    expect(said(fine)).toContain("with 999 petals");
    expect(said(null)).not.toContain("petals");
  });
  test("petals at the foot alone", () => {
    const text = words(pot((u, v) => 1 + 0.1 * u * Math.cos(5 * v), up(3)));
    expect(text).toContain("5 petals at the foot");
  });
  test("a bowl, a bottle, a jar, a plate", () => {
    expect(words(pot((u) => 2 - u, up(2)))).toMatch(/^A bowl/);
    expect(words(pot((u) => 0.3 + 0.9 * Math.sin(Math.PI * Math.min(1, 1.1 * u)), up(4)))).toMatch(/^A bottle/);
    expect(words(pot((u) => 0.6 + 0.7 * Math.sin(Math.PI * u), up(2.4)))).toMatch(/^A jar.*in the middle/);
    expect(words(pot((u) => 3 - 2 * u, up(0.5)))).toMatch(/^A plate/);
  });
  test("waves in the rim", () => {
    const wavy = (n: number) =>
      pot(
        () => 1,
        (u, v) => (1 - u) * (3 + 0.3 * Math.sin(n * v)),
      );
    expect(words(wavy(5))).toContain("5 waves in the rim");
    expect(words(wavy(2))).toContain("a saddle-shaped rim");
    expect(words(wavy(1))).toContain("a slanting rim");
  });
  test("a tulip is widest at the tips of its petals, where it is as wide as is said", () => {
    const text = words(pot((u, v) => 7 + 0.1 * Math.sin(Math.PI * u) + 0.6 * (1 - u) ** 3 * Math.cos(6 * v), up(20.9)));
    expect(text).toMatch(/^A vase 20.9 cm high and 15.2 cm wide, widest at the rim, with 6 petals/);
  });
  test("an open wall", () => {
    expect(words(pot(() => 1, up(3), 0.8))).toContain("The wall does not close.");
  });
  test("several parts", () => {
    const grid = pot(() => 1, up(3));
    const told = { body: bodyOf(grid), closed: isClosed(grid), lift: 0 };
    const both = factsOf([told, told], box(grid), extentsOf(grid.positions) as Extents);
    expect(describe(both as Facts, "mm")).toMatch(/^Two parts, .* high and .* wide together\.$/);
  });
  test("a part that is moved upwards is widest where it was", () => {
    const grid = pot((u) => 0.6 + 0.7 * Math.sin(Math.PI * u), up(2.4));
    const { min, max } = box(grid);
    const lifted: Box = { min: [min[0], min[1], min[2] + 5], max: [max[0], max[1], max[2] + 5] };
    const told = { body: bodyOf(grid), closed: isClosed(grid), lift: 5 };
    const facts = factsOf([told], lifted, extentsOf(grid.positions) as Extents);
    expect(facts?.widestAt).toBeCloseTo(0.5, 1);
    expect(facts?.outline[0]?.[0]).toBeCloseTo(5, 5);
  });
});

test("nothing is said of nothing", () => {
  const nothing = pot(() => 1, up(1));
  expect(factsOf([], box(nothing), extentsOf(nothing.positions) as Extents)).toBeNull();
  expect(bodyOf({ ...nothing, rows: 1 })).toBeNull();
});

test.each([
  [0.001234, "0.0013 cm"],
  [0.02, "0.02 cm"],
  [0.0996, "0.1 cm"],
  [17.2, "18 cm"],
  [0, "0 cm"],
])("an accuracy of %d is never called better than it is", (bound, words) => {
  expect(describeAccuracy(bound, "cm")).toBe(`Drawn to within ${words} of the true surface.`);
});
