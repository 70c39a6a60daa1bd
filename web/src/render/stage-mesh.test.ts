import { describe, expect, it } from "vitest";
import type { StageLook } from "./glaze";
import { partsOf, type StageMesh } from "./stage-mesh";

const LOOKS: readonly StageLook[] = [
  { glaze: "celadon", clay: "stoneware" },
  { glaze: "shino", clay: "porcelain" },
];

/** Squares of two triangles each, one after the other; `wound` says which are wound the other way round. */
function squares(wound: readonly boolean[]): StageMesh {
  const count = wound.length;
  const corners = wound.flatMap((_, part) => [0, 0, part, 1, 0, part, 0, 1, part, 1, 1, part]);
  const indices = wound.flatMap((other, part) =>
    (other ? [0, 2, 1, 1, 2, 3] : [0, 1, 2, 1, 3, 2]).map((vertex) => 4 * part + vertex),
  );
  return {
    positions: new Float32Array(corners),
    normals: new Float32Array(corners.length).fill(1),
    uvs: new Float32Array(wound.flatMap(() => [0, 0, 1, 0, 0, 1, 1, 1])),
    indices: new Uint32Array(indices),
    groups: new Uint32Array(wound.flatMap((_, part) => [6 * part, 6, part])),
    topology: wound.join(),
    ware: { texels: new Float32Array(16 * count).map((_, i) => i), rows: 2, columns: 2 },
    bounds: { min: [0, 0, 0], max: [1, 1, count], centre: [0.5, 0.5, count / 2], radius: count },
  };
}

describe("partsOf", () => {
  it("takes parts out of one mesh, each with vertices of its own and its look", () => {
    const { parts, bounds } = partsOf(squares([false, true]), LOOKS);
    expect(bounds?.max).toEqual([1, 1, 2]);
    expect(parts.map(({ id, look }) => [id, look.glaze])).toEqual([
      [0, "celadon"],
      [1, "shino"],
    ]);
    expect([...(parts[0]?.mesh.indices ?? [])]).toEqual([0, 1, 2, 1, 3, 2]);
    expect([...(parts[1]?.mesh.indices ?? [])]).toEqual([0, 2, 1, 1, 2, 3]);
    expect([...(parts[1]?.mesh.positions ?? [])]).toEqual([0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1]);
    expect(parts[1]?.mesh.ware.texels[0]).toBe(16);
  });

  it("copies nothing that is different in every mesh", () => {
    const mesh = squares([false, false, true]);
    for (const { mesh: part } of partsOf(mesh, LOOKS).parts) {
      expect(part.positions.buffer).toBe(mesh.positions.buffer);
      expect(part.normals.buffer).toBe(mesh.normals.buffer);
      expect(part.ware.texels.buffer).toBe(mesh.ware.texels.buffer);
    }
  });

  it("gives parts on the same grid the same lattice, in every mesh of that grid", () => {
    const mesh = squares([false, false, true]);
    const [one, two, three] = partsOf(mesh, LOOKS).parts;
    expect(two?.mesh.indices).toBe(one?.mesh.indices);
    expect(two?.mesh.uvs).toBe(one?.mesh.uvs);
    expect(three?.mesh.indices).not.toBe(one?.mesh.indices);
    const next = partsOf({ ...squares([false, false, true]), indices: mesh.indices }, LOOKS);
    expect(next.parts[2]?.mesh.indices).toBe(three?.mesh.indices);
  });

  it("counts another mesh as another revision, and the same one as the same", () => {
    const mesh = squares([false]);
    const revision = (of: StageMesh) => partsOf(of, LOOKS).parts[0]?.revision;
    expect(revision(mesh)).toBe(revision(mesh));
    expect(revision({ ...mesh })).not.toBe(revision(mesh));
  });

  it("has no parts of an empty mesh", () => {
    expect(partsOf({ ...squares([]), bounds: null }, LOOKS)).toEqual({ parts: [], bounds: null });
  });
});
