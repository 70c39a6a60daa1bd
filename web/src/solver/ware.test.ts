import { describe, expect, it } from "vitest";
import type { GridSize } from "../document/waves";
import { boundsOf } from "./bounds";
import { WARE_SIZE, type WareMesh, ware, wareGrid } from "./ware";

/** A cylinder, or a part of a ball when `radius` bends, as the solver hands it over: rows along u from the rim, last column on the first. */
function turned(
  rows: number,
  columns: number,
  profile: (u: number) => { r: number; z: number; nr: number; nz: number },
): WareMesh & GridSize {
  const positions: number[] = [];
  const normals: number[] = [];
  for (let i = 0; i < rows; i++) {
    const u = i / (rows - 1);
    const { r, z, nr, nz } = profile(u);
    for (let j = 0; j < columns; j++) {
      const v = j / (columns - 1);
      const angle = 2 * Math.PI * (j === columns - 1 ? 0 : v);
      positions.push(r * Math.cos(angle), r * Math.sin(angle), z);
      normals.push(nr * Math.cos(angle), nr * Math.sin(angle), nz);
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    rows,
    columns,
  };
}

const cylinder = () => turned(9, 33, (u) => ({ r: 2, z: 5 * (1 - u), nr: 1, nz: 0 }));

describe("bounds", () => {
  it("are those of the points, and null for none", () => {
    const bounds = boundsOf(cylinder().positions as Float32Array);
    expect(bounds?.min).toEqual([-2, -2, 0]);
    expect(bounds?.max).toEqual([2, 2, 5]);
    expect(bounds?.radius).toBeCloseTo(Math.hypot(2, 2.5), 5);
    expect(boundsOf(new Float32Array())).toBeNull();
    expect(boundsOf(cylinder().positions as Float32Array, new Float32Array([2, 0, 2.5]))?.radius).toBeCloseTo(2, 5);
  });
});

describe("ware", () => {
  const read = (mesh: WareMesh & GridSize) => {
    const out = new Float32Array((mesh.positions.length / 3) * WARE_SIZE);
    ware(mesh, mesh, out);
    return (vertex: number) => out.subarray(vertex * WARE_SIZE, (vertex + 1) * WARE_SIZE);
  };

  it("measures from rim and foot, and finds no edge on a cylinder", () => {
    const of = read(cylinder());
    for (let row = 0; row < 9; row++) {
      for (const column of [0, 11, 32]) {
        const [curvature, rim, foot, depth] = of(row * 33 + column) as unknown as [number, number, number, number];
        expect(curvature).toBeCloseTo(0, 2);
        expect(rim).toBeCloseTo((5 * row) / 8, 4);
        expect(foot).toBeCloseTo(5 - (5 * row) / 8, 4);
        // The seam counts twice in the mean of a ring.
        expect(depth).toBeCloseTo((5 * row) / 8 / 2, 2);
      }
    }
  });

  it("gives a ball the curvature of a ball, less that of its girth, the seam included", () => {
    const ball = turned(65, 129, (u) => {
      const t = 0.3 + 2.5 * u;
      return { r: 3 * Math.sin(t), z: 3 * Math.cos(t), nr: Math.sin(t), nz: Math.cos(t) };
    });
    const of = read(ball);
    for (const column of [0, 50, 128]) expect(of(32 * 129 + column)[0]).toBeCloseTo(1 / 3 - 1 / 6, 2);
  });

  it("is finite for triangles without area", () => {
    const mesh = turned(5, 9, () => ({ r: 0, z: 1, nr: 0, nz: 0 }));
    const out = new Float32Array(45 * WARE_SIZE);
    ware(mesh, mesh, out);
    expect(out.every(Number.isFinite)).toBe(true);
  });

  it("fits a texture for any number of parts and waves", () => {
    for (const parts of [1, 2, 30, 500]) {
      for (const waves of [1, 8, 300, 1e6]) {
        const { rows, columns } = wareGrid(parts, waves);
        expect(rows).toBeLessThanOrEqual(4096);
        expect(columns).toBeLessThanOrEqual(4096);
        expect(Math.min(rows, columns)).toBeGreaterThanOrEqual(8);
      }
    }
  });

  it("samples one part more as it sampled the others", () => {
    for (const parts of [2, 5, 20, 40, 300]) expect(wareGrid(parts + 1, 8)).toEqual(wareGrid(parts + 2, 8));
  });
});
