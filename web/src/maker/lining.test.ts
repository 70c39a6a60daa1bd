import { expect, test } from "vitest";
import { liningValues, type Mapped } from "./lining";

/** A ball of a radius, as a surface whose curvature everybody knows. */
function ball(radius: number, thickness: number): Mapped {
  const normals: number[] = [];
  for (let row = 0; row <= 40; row += 1) {
    for (let column = 0; column < 80; column += 1) {
      const [polar, turn] = [(Math.PI * row) / 40, (2 * Math.PI * column) / 80];
      normals.push(Math.sin(polar) * Math.cos(turn), Math.sin(polar) * Math.sin(turn), Math.cos(polar));
    }
  }
  const count = normals.length / 3;
  return {
    normals: Float32Array.from(normals),
    positions: Float32Array.from(normals, (x) => radius * x),
    mean: new Float32Array(count).fill(1 / radius),
    gaussian: new Float32Array(count).fill(1 / radius ** 2),
    thickness: new Float32Array(count).fill(thickness),
  };
}

const within = (surface: Mapped, radius: number) => Float32Array.from(surface.normals, (x) => radius * x);

test("the inside of a ball is a smaller ball", () => {
  const surface = ball(5, 1);
  const points = within(surface, 4);
  for (const value of liningValues("mean-curvature", surface, points)) expect(value).toBeCloseTo(1 / 4, 5);
  for (const value of liningValues("gaussian-curvature", surface, points)) expect(value).toBeCloseTo(1 / 16, 5);
  for (const value of liningValues("thickness", surface, points)) expect(value).toBe(1);
});

test("what lies behind no wall has no value: the middle of a floor, and what is outside", () => {
  const surface = ball(5, 1);
  expect([...liningValues("thickness", surface, new Float32Array([0, 0, 0, 0, 0, 2, 0, 0, 9]))]).toEqual([
    Number.NaN,
    Number.NaN,
    Number.NaN,
  ]);
});

test("between the vertices the nearest one answers", () => {
  const surface = ball(5, 1);
  const turned = Float32Array.from(within(surface, 4).slice(0, 300), (x) => x + 0.03);
  const values = liningValues("mean-curvature", surface, turned);
  expect(values.every((value) => Math.abs(value - 0.25) < 1e-5)).toBe(true);
});
