import type { Matrix } from "./gl/view";
import type { StageLook } from "./glaze";
import type { Triple } from "./triple";

/** What tells a part from others, as long as it is there. */
export type PartId = string | number;

/**
 * The mesh of one part, before placement. What comes from the solver is finite and fits together, and is not looked through again on the thread
 * that draws.
 *
 * `positions` and `normals` hold three floats per vertex in model units, z up, normals pointing out of the pot; `uvs` two per vertex (u along the
 * profile, v / span round it); `indices` three per triangle, counter-clockwise seen from outside. Meshes of the same grid share the very same `uvs`
 * and `indices`, which are then on the GPU once.
 */
export interface PartMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly ware: StageWare;
  /** What was written over in these very arrays; without it a mesh of another revision is another one. */
  readonly writes?: Writes;
}

/** What was written over in the arrays of a mesh, by the revisions that this made. */
export interface Writes {
  /** All since a revision, each as pairs of the first vertex and how many there are from it on; null where that is not known any more. */
  since(revision: number): readonly Uint32Array[] | null;
}

/** From which height to which. */
export type Span = readonly [low: number, high: number];

/** One part of what is shown. */
export interface StagePart {
  readonly id: PartId;
  /** Another number says that the mesh is another one: only then does anything travel to the GPU. */
  readonly revision: number;
  readonly mesh: PartMesh;
  /** Where it stands: from the mesh to the model. It has an inverse. */
  readonly matrix: Matrix;
  readonly look: StageLook;
  /** From which height to which it stands, in model units. */
  readonly span: Span;
  /** The middle of the object that it belongs to, where there are several: each is cut open through its own. */
  readonly middle?: Triple | undefined;
  /** What is hidden stays on the graphics card, and is neither drawn nor found at a point. */
  readonly hidden?: boolean;
  /** Whether it is hidden because its inside is shown in its place. */
  readonly inside?: boolean;
}

/** What is shown: parts in the order of the document, and what they fill where they stand; null when they are empty. */
export interface StageModel {
  readonly parts: readonly StagePart[];
  readonly bounds: Bounds | null;
}

/**
 * What the glaze goes by, in a table of `rows` by `columns`, evenly spaced in u and v: the curvature beyond that of a cylinder, the distances to rim
 * and foot, and the depth below the rim in radii of the mouth.
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
