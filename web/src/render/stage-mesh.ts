import { IDENTITY } from "./gl/view";
import type { StageLook } from "./glaze";
import type { Bounds, PartMesh, StageModel, StageWare } from "./mesh";
import { at } from "./triple";

/** All parts of a design in one mesh, placed, as the solver answers: `groups` has a (first index, index
 * count, part) triple for each part in turn, and the vertices of a part follow those of the one before. */
export interface StageMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly groups: Uint32Array;
  readonly topology: string;
  /** The tables of all parts, one below the other, `rows` of each. */
  readonly ware: StageWare;
  readonly bounds: Bounds | null;
}

const DEFAULT_LOOK: StageLook = { glaze: "celadon", clay: "stoneware" };

/** What depends on the grid alone, of one part. */
interface Lattice {
  readonly first: number;
  readonly vertices: number;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
}

/** By the indices of the whole: meshes of the same grid have the very same. */
const known = new WeakMap<Uint32Array, readonly Lattice[]>();

let revisions = 0;
const revisionOf = new WeakMap<StageMesh, number>();

/** The parts of a whole mesh, with the numbers of the parts for identities. Nothing that differs from mesh to mesh is copied. */
export function partsOf(mesh: StageMesh, looks: readonly StageLook[]): StageModel {
  let revision = revisionOf.get(mesh);
  if (revision === undefined) {
    revisions += 1;
    revision = revisions;
    revisionOf.set(mesh, revision);
  }
  let lattices = known.get(mesh.indices);
  if (!lattices) {
    lattices = latticesOf(mesh);
    known.set(mesh.indices, lattices);
  }
  const { rows, columns, texels } = mesh.ware;
  const size = 4 * rows * columns;
  const parts = lattices.map(({ first, vertices, uvs, indices }, id) => ({
    id,
    revision: revision as number,
    mesh: {
      positions: mesh.positions.subarray(3 * first, 3 * (first + vertices)),
      normals: mesh.normals.subarray(3 * first, 3 * (first + vertices)),
      uvs,
      indices,
      ware: { texels: texels.subarray(id * size, (id + 1) * size), rows, columns },
    } satisfies PartMesh,
    matrix: IDENTITY,
    look: looks[id] ?? DEFAULT_LOOK,
  }));
  return { parts, bounds: mesh.bounds };
}

function latticesOf({ uvs, indices, groups }: StageMesh): readonly Lattice[] {
  const count = groups.length / 3;
  const vertices = uvs.length / 2 / count;
  const lattices: Lattice[] = [];
  for (let part = 0; part < count; part++) {
    const first = part * vertices;
    const start = at(groups, 3 * part);
    const own = {
      uvs: uvs.subarray(2 * first, 2 * (first + vertices)),
      indices: indices.slice(start, start + at(groups, 3 * part + 1)).map((vertex) => vertex - first),
    };
    // Parts on the same grid have the same triangles, unless one is wound the other way round.
    const twin = lattices.find((other) => equal(other.indices, own.indices) && equal(other.uvs, own.uvs));
    lattices.push({ first, vertices, uvs: twin?.uvs ?? own.uvs, indices: twin?.indices ?? own.indices });
  }
  return lattices;
}

function equal(a: Float32Array | Uint32Array, b: Float32Array | Uint32Array): boolean {
  return a.length === b.length && a.every((each, i) => each === b[i]);
}
