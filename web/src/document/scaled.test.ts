import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { designOf } from "./gallery/exhibit";
import { OWN } from "./gallery/own";
import { PAPERS } from "./gallery/papers";
import { inUnit, scaled, shapeBy } from "./scaled";
import { type Family, familyOf, fieldValue } from "./schema";
import type { Design, Shape } from "./types";

const FAMILIES = (["second-order", "mixed-order", "fourth-order", "bloor-wilson"] as const).map(
  (kind) => familyOf(kind) as Family,
);

test.each(FAMILIES.map((family) => [family.kind, family] as const))(
  "every length of %s grows, and nothing else",
  (_, family) => {
    const twice = shapeBy(family.reset, 2);
    for (const field of family.fields) {
      const grows = field.dimension === "length" || field.path[0] === "force";
      expect(fieldValue(twice, field), field.key).toBeCloseTo((grows ? 2 : 1) * fieldValue(family.reset, field), 12);
    }
  },
);

const tables = JSON.parse(readFileSync(new URL("../../../tests/reference/tables.json", import.meta.url), "utf8")) as {
  readonly name: string;
  readonly shape: Shape;
}[];

test("free boundary data grow with their slopes and forces, and keep their waves and weights", () => {
  const gourd = tables.find(({ name }) => name === "table-gourd")?.shape;
  if (gourd?.kind !== "boundary-value") throw new Error("the gourd is of free boundary data");
  const half = shapeBy(gourd, 0.5) as typeof gourd;
  const [mode, smaller] = [gourd.x.modes[0]?.cos, half.x.modes[0]?.cos];
  expect(smaller).toEqual(
    Object.fromEntries(
      Object.entries(mode ?? {}).map(([name, value]: [string, number | readonly number[]]) => [
        name,
        typeof value === "number" ? value / 2 : value.map((each) => each / 2),
      ]),
    ),
  );
  expect(smaller?.force).toHaveLength(3);
  expect({ ...half.x, modes: [] }).toEqual({ ...gourd.x, modes: [] });
});

test("the points of a network move apart and its forces grow, the rectangles of these and the parameters of patches stay", () => {
  const force = { f0: [1, 0, -2], u: [0.25, 0.75] } as const;
  const patch = { frame: [0, 1, 2, 3, 4, 5, 6, 7], a1: [1, 2, 3] } as const;
  const network = {
    kind: "vertex-frame",
    vertices: [
      [1, 2, 3],
      [0, -0.5, 0],
    ],
    patches: [{ ...patch, forces: [force] }, patch],
    crease: 0.3,
  } as const;
  expect(shapeBy(network, 10)).toEqual({
    ...network,
    vertices: [
      [10, 20, 30],
      [0, -5, 0],
    ],
    patches: [{ ...patch, forces: [{ ...force, f0: [10, 0, -20] }] }, patch],
  });
});

const POT: Design = {
  pasu: 1,
  parts: [
    {
      shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06] },
      place: { scale: [1, 1, 2], shift: [1, 0, 3] },
      wall: { thickness: 0.5, base: 0.4, foot: [0.6, 0.3], drain: 1 },
    },
  ],
};

test("a wall grows along, or stays as thick as it was said to be", () => {
  expect(scaled(POT, 3, "scale").parts[0]).toEqual({
    shape: { kind: "second-order", r: [3, 0.3, 1.8, 0.18], height: 10.8, force: [0, 0] },
    place: { scale: [1, 1, 2], shift: [3, 0, 9] },
    wall: { thickness: 1.5, base: 1.2, foot: [1.8, 0.9], drain: 3 },
  });
  expect(scaled(POT, 3, "stay").parts[0]?.wall).toBe(POT.parts[0]?.wall);
});

test("a unit converts: there and back leads to the same document", () => {
  const inches = inUnit(POT, "in");
  expect(inches.unit).toBe("in");
  expect(inches.parts[0]?.wall?.thickness).toBeCloseTo(0.5 / 2.54, 11);
  expect(inUnit(POT, "cm")).toBe(POT);
  for (const exhibit of [...OWN, ...PAPERS]) {
    const design = designOf(exhibit);
    const back = inUnit(inUnit(design, "mm"), "cm");
    const again = inUnit(inUnit(back, "mm"), "cm");
    expect(again).toEqual(back);
  }
});

test("an octant grows by its placement: it has no length of its own", () => {
  const octant = { kind: "octant", exponents: [2, 3, 0.5] } as const;
  const design: Design = {
    pasu: 1,
    parts: [{ shape: octant }, { shape: octant, place: { scale: [1, -2, 3], shift: [1, 0, 2] } }],
  };
  expect(scaled(design, 2, "stay").parts).toEqual([
    { shape: octant, place: { scale: [2, 2, 2] } },
    { shape: octant, place: { scale: [2, -4, 6], shift: [2, 0, 4] } },
  ]);
});
