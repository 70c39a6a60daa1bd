import { describe, expect, it } from "vitest";
import { ofArrows, ofPolylines, reachOf } from "./segments";

describe("segments", () => {
  it("are the pieces of polylines", () => {
    const line = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0]);
    expect([...ofPolylines([line, new Float32Array(3), new Float32Array()])]).toEqual([
      0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0,
    ]);
  });

  it("know how far what they stand on reaches", () => {
    const at = ([x, y, z]: readonly number[]) => ({ at: Float32Array.of(x ?? 0, y ?? 0, z ?? 0) });
    const round = (z: number) => [at([1, 0, z]), at([0, 1, z]), at([-1, 0, z]), at([0, -1, z])];
    expect(reachOf([...round(0), ...round(1.5)])).toBe(1.25);
    expect(reachOf([])).toBe(0);
  });

  it("make no arrow without a direction, and finite ones in every direction", () => {
    const at = new Float32Array([1, 2, 3]);
    expect(ofArrows([{ at, along: new Float32Array(3) }], 1)).toHaveLength(0);
    for (const along of [
      [0, 0, 1],
      [0, 0, -5],
      [1, 0, 0],
      [1e-20, 1e-20, 0],
    ]) {
      const arrow = ofArrows([{ at, along: new Float32Array(along) }], 0.5);
      expect(arrow).toHaveLength(18);
      expect(arrow.every(Number.isFinite)).toBe(true);
      const [x, y, z] = [3, 4, 5].map((k) => (arrow[k] as number) - (at[k - 3] as number)) as [number, number, number];
      expect(Math.hypot(x, y, z)).toBeCloseTo(0.5, 5);
    }
  });
});
