import type { Triple } from "./triple";

/**
 * The mesh contract of the stage, which is the solver's: what comes from it is finite and fits together, and is not looked
 * through again on the thread that draws.
 *
 * `positions` and `normals` hold three floats per vertex in model units, z up, normals pointing out of the pot;
 * `uvs` two per vertex (u along the profile, v / span round it); `indices` three per triangle, counter-clockwise
 * seen from outside; `groups` (first index, index count, part) triples. Meshes of the same grid share the same `indices`.
 */
export interface StageMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly groups: Uint32Array;
  readonly topology: string;
  readonly ware: StageWare;
  /** What the positions fill; null for an empty mesh. */
  readonly bounds: Bounds | null;
}

/**
 * What the glaze goes by, in a table of `rows` by `columns` for every part, evenly spaced in u and v: the curvature beyond
 * that of a cylinder, the distances to rim and foot, and the depth below the rim in radii of the mouth.
 */
export interface StageWare {
  readonly texels: Float32Array;
  readonly rows: number;
  readonly columns: number;
}

/** What a set of points fills. `radius` is the largest distance of a point from `centre`, the middle of the box. */
export interface Bounds {
  readonly min: Triple;
  readonly max: Triple;
  readonly centre: Triple;
  readonly radius: number;
}
