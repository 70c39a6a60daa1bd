import { describe, expect, it } from "vitest";
import { gridOf } from "./grid";
import { boundsOf, checkMesh, MeshError, type StageMesh } from "./mesh";
import { edgesOf, ofArrows, ofPolylines } from "./overlay/segments";
import { WARE_SIZE, ware } from "./ware";

/** A cylinder, or a part of a ball when `radius` bends, as the solver hands it over: rows along u from the rim, last column on the first. */
function turned(
  rows: number,
  columns: number,
  profile: (u: number) => { r: number; z: number; nr: number; nz: number },
): StageMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i < rows; i++) {
    const u = i / (rows - 1);
    const { r, z, nr, nz } = profile(u);
    for (let j = 0; j < columns; j++) {
      const v = j / (columns - 1);
      const angle = 2 * Math.PI * (j === columns - 1 ? 0 : v);
      positions.push(r * Math.cos(angle), r * Math.sin(angle), z);
      normals.push(nr * Math.cos(angle), nr * Math.sin(angle), nz);
      uvs.push(u, v);
      if (i === 0 || j === 0) continue;
      const d = i * columns + j;
      const [a, b, c] = [d - columns - 1, d - columns, d - 1];
      // Rows go downwards: counter-clockwise from outside.
      indices.push(a, c, b, b, c, d);
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    indices: new Uint32Array(indices),
    groups: new Uint32Array([0, indices.length, 0]),
  };
}

const cylinder = () => turned(9, 33, (u) => ({ r: 2, z: 5 * (1 - u), nr: 1, nz: 0 }));
const nothing = (): StageMesh => ({
  positions: new Float32Array(),
  normals: new Float32Array(),
  uvs: new Float32Array(),
  indices: new Uint32Array(),
  groups: new Uint32Array(),
});

describe("the check of a mesh", () => {
  it("lets whole and empty meshes through", () => {
    checkMesh(cylinder());
    checkMesh(nothing());
  });

  it("refuses what would be drawn as garbage, and says where", () => {
    const cases: [(mesh: StageMesh) => void, string][] = [
      [(mesh) => mesh.positions.set([Number.NaN], 7), "positions[7] is NaN"],
      [(mesh) => mesh.normals.set([Number.POSITIVE_INFINITY], 4), "normals[4] is Infinity"],
      [(mesh) => mesh.uvs.set([Number.NEGATIVE_INFINITY], 3), "uvs[3] is -Infinity"],
      [(mesh) => mesh.indices.set([1e6], 5), "indices[5] is 1000000"],
      [(mesh) => mesh.groups.set([mesh.indices.length + 3], 1), "group 0 ends at"],
      [(mesh) => Object.assign(mesh, { normals: new Float32Array(3) }), "normals has 3 numbers"],
      [(mesh) => Object.assign(mesh, { uvs: new Float32Array(3) }), "uvs has 3 numbers"],
      [(mesh) => Object.assign(mesh, { positions: new Float32Array(4) }), "positions has 4 numbers"],
    ];
    for (const [spoil, message] of cases) {
      const mesh = cylinder();
      spoil(mesh);
      expect(() => checkMesh(mesh)).toThrow(MeshError);
      expect(() => checkMesh(mesh)).toThrow(message);
    }
  });
});

describe("bounds", () => {
  it("are those of the points, and null for none", () => {
    const bounds = boundsOf(cylinder().positions);
    expect(bounds?.min).toEqual([-2, -2, 0]);
    expect(bounds?.max).toEqual([2, 2, 5]);
    expect(bounds?.radius).toBeCloseTo(Math.hypot(2, 2.5), 5);
    expect(boundsOf(new Float32Array())).toBeNull();
  });
});

describe("the grid of a part", () => {
  it("is recognised by its parameters", () => {
    expect(gridOf(cylinder(), 0, 9 * 33)).toEqual({ first: 0, rows: 9, columns: 33 });
  });

  it("is not seen where there is none", () => {
    const mesh = cylinder();
    mesh.uvs.set([0.77], 2 * 40);
    expect(gridOf(mesh, 0, 9 * 33 - 1)).toBeNull();
    expect(gridOf(mesh, 0, 0)).toBeNull();
    mesh.uvs.fill(0);
    expect(gridOf(mesh, 0, 9 * 33)).toBeNull();
  });
});

describe("ware", () => {
  const read = (mesh: StageMesh) => {
    const out = new Float32Array((mesh.positions.length / 3) * WARE_SIZE);
    ware(mesh, out);
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
    ware(mesh, out);
    expect(out.every(Number.isFinite)).toBe(true);
  });
});

describe("segments", () => {
  it("are the pieces of polylines", () => {
    const line = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0]);
    expect([...ofPolylines([line, new Float32Array(3), new Float32Array()])]).toEqual([
      0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0,
    ]);
  });

  it("have every edge of the triangles once", () => {
    const edges = edgesOf(new Uint32Array([0, 1, 2, 2, 1, 3]));
    const names = new Set<string>();
    for (let i = 0; i < edges.length; i += 2) names.add([edges[i], edges[i + 1]].sort().join("-"));
    expect([...names].sort()).toEqual(["0-1", "0-2", "1-2", "1-3", "2-3"]);
    expect(edges).toHaveLength(10);
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
