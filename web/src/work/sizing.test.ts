import { expect, test } from "vitest";
import type { Design, Measures } from "../document/types";
import { factorFor, type Sized, sizeOf } from "./sizing";

/** A cup: a cylinder of radius 3 and height 8 with a wall of 0.5 inwards and a base of 0.6. */
const CUP: Design = {
  pasu: 1,
  parts: [
    {
      shape: { kind: "second-order", r: [3, 0, 3, 0], t: [0, 0], n: [1, 2], height: 8 },
      wall: { thickness: 0.5, base: 0.6 },
    },
  ],
};

/** What such a cup measures; null where its wall leaves no room. */
function measured({ parts: [part] }: Design): Measures | null {
  if (part?.shape.kind !== "second-order") return null;
  const { r, height = 0 } = part.shape;
  const { thickness, base } = part.wall ?? { thickness: 0, base: 0 };
  const [inside, deep] = [r[0] - thickness, height - base];
  if (!(inside > 0 && deep > 0)) return null;
  const exactly = (value: number) => ({ value, error: 0 });
  return {
    height: exactly(height),
    width: { greatest: exactly(2 * r[0]), least: exactly(2 * r[0]) },
    capacity: { brim: exactly(Math.PI * inside ** 2 * deep) },
  } as Measures;
}

const NOW = measured(CUP) as Measures;

async function found(sized: Sized, size: number, walls: "scale" | "stay") {
  let asked = 0;
  const factor = await factorFor(CUP, NOW, { sized, size, walls }, async (design) => {
    asked += 1;
    return measured(design);
  });
  const stays = walls === "stay";
  const wall = CUP.parts[0]?.wall ?? { thickness: 0, base: 0 };
  const by = factor ?? Number.NaN;
  const made = measured({
    ...CUP,
    parts: [
      {
        shape: { kind: "second-order", r: [3 * by, 0, 3 * by, 0], height: 8 * by },
        wall: stays ? wall : { thickness: wall.thickness * by, base: wall.base * by },
      },
    ],
  });
  return { asked, size: made && sizeOf(made, sized) };
}

test.each([
  ["height", 12],
  ["width", 3.5],
  ["capacity", 330],
  ["capacity", 20],
] as const)("a %s of %d, with a wall that grows along and one that stays", async (sized, size) => {
  const grown = await found(sized, size, "scale");
  expect(grown.size).toBeCloseTo(size, 8);
  expect(grown.asked).toBe(0);
  const kept = await found(sized, size, "stay");
  expect(kept.size).toBeCloseTo(size, 5);
  expect(kept.asked).toBeLessThan(10);
});

test("a size that makes no sense, or that the wall leaves no room for, has no factor", async () => {
  for (const size of [0, -3, Number.NaN, Number.POSITIVE_INFINITY]) {
    expect(await factorFor(CUP, NOW, { sized: "height", size, walls: "scale" }, async () => NOW)).toBeNull();
  }
  expect(await factorFor(CUP, NOW, { sized: "capacity", size: 9, walls: "stay" }, async () => null)).toBeNull();
});
