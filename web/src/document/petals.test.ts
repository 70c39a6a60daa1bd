import { expect, test } from "vitest";
import { petalsAt, withPetals } from "./petals";
import type { Shape } from "./types";

const VASE: Shape = { kind: "second-order", r: [1, 0.1, 0.6, 0.06] };
const N2 = ["n", 1];

/** How often the drawn rim swings out while the wall goes round. */
function counted({ n }: { readonly n?: readonly [number, number] }): number {
  const [turns, waves] = n ?? [1, 8];
  const samples = 4096;
  const radius = (k: number) => {
    const v = (2 * Math.PI * k) / samples;
    return Math.hypot(Math.cos(turns * v) + 0.1 * Math.cos(waves * v), Math.sin(turns * v) + 0.1 * Math.sin(waves * v));
  };
  let hills = 0;
  for (let k = 0; k < samples; k += 1) if (radius(k) > radius(k - 1) && radius(k) >= radius(k + 1)) hills += 1;
  return hills;
}

test.each([3, 5, 7, 8, 12])("%d petals are %d for the eye", (petals) => {
  const shape = withPetals(VASE, N2, petals) as Shape & { readonly n: readonly [number, number] };
  expect(shape.n).toEqual([1, petals + 1]);
  expect(counted(shape)).toBe(petals);
  expect(petalsAt(shape, N2)).toBe(petals);
});

test("the paper's eight waves are seven petals", () => {
  expect(petalsAt(VASE, N2)).toBe(7);
  expect(counted({})).toBe(7);
});

test("turns leave the petals as many as they were", () => {
  const twice = withPetals(VASE, ["n", 0], 2) as Shape & { readonly n: readonly [number, number] };
  expect(twice.n).toEqual([2, 9]);
  expect(counted(twice)).toBe(7);
  expect(petalsAt(twice, N2)).toBe(7);
});

test("fractions keep their digits, and no other number has petals", () => {
  const open = withPetals({ ...VASE, n: [1.1, 8] } as Shape, N2, 0.3) as Shape;
  expect(open).toMatchObject({ n: [1.1, 1.4] });
  expect(petalsAt(open, N2)).toBe(0.3);
  expect(petalsAt(VASE, ["n", 0])).toBeNull();
  expect(withPetals(VASE, ["height"], 5)).toBeNull();
});
