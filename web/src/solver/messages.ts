/** What the page and the solver's worker say to each other. Everything here survives structured cloning. */

import type { Facts } from "../document/facts";
import type { Conversion, Design, Handles, OrderKind, Shape } from "../document/types";
import type { GridSize } from "../document/waves";
import type * as worker from "../worker/port";
import type { Bounds } from "./bounds";
import type { Ware } from "./ware";

/** What depends on the grid alone. Meshes of the same topology share these very arrays. */
export interface Lattice {
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly groups: Uint32Array;
}

/** What is different in every mesh. */
export interface Surface {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly topology: string;
  readonly ware: Ware;
  readonly bounds: Bounds | null;
}

/** A mesh as the package documents it, a grid of rows by columns for every part, with what its picture needs besides. */
export interface MeshArrays extends Surface, Lattice {}

/** A mesh on its way: the page has the lattice already, or it comes along. */
export interface SentMesh extends Surface {
  readonly lattice: Lattice | null;
}

/** Arrays of an earlier mesh, to be written over. */
export interface Spare {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texels: Float32Array;
  readonly topology: string;
}

/** Curves on the placed surface, xyz triples. */
export interface LineArrays {
  readonly iso_u: Float32Array[];
  readonly iso_v: Float32Array[];
  readonly rim: Float32Array | null;
  readonly foot: Float32Array | null;
  readonly tangents: { readonly at: Float32Array; readonly along: Float32Array }[];
}

/** The section of one part through its axis, before placement. */
export interface Section {
  /** `x, z` pairs along `u` at `v = 0`. */
  readonly right: Float64Array;
  /** `x, z` pairs along `u` at `v = span / 2`. */
  readonly left: Float64Array;
  /** `X_u` at `v = 0`, as `x, z` at `u = 0` and then at `u = 1`. */
  readonly slopes: Float64Array;
  /** What of it a hand can drag; good for a whole drag. */
  readonly handles: Handles;
}

export interface SolveOptions extends GridSize {
  /** Whether the overlay lines are wanted. */
  readonly lines: boolean;
  /** The part whose section is wanted, if any. */
  readonly section: number | null;
  /** Whether the gesture is over: link and fingerprint are computed then. */
  readonly settle: boolean;
}

/** Times of the worker, in milliseconds on the clock of the page's `performance.timeOrigin + performance.now()`. */
export interface Times {
  readonly begun: number;
  /** The mesh stood. */
  readonly meshed: number;
  /** The coarse mesh for the glaze stood: with the one before, what solving took and what sampling. */
  readonly glazed: number;
  /** Everything stood. */
  readonly done: number;
}

export interface Solved<Mesh = MeshArrays> {
  readonly mesh: Mesh;
  readonly lines: LineArrays | null;
  readonly section: Section | null;
  readonly facts: Facts | null;
  /** The largest distance of the triangles from the true surface; known once the gesture is over. */
  readonly bound: number | null;
  readonly fingerprint: string;
  readonly link: string;
  readonly times: Times;
}

export interface Parsed {
  readonly design: Design;
  readonly link: string;
}

export type Ask =
  | { readonly kind: "solve"; readonly design: Design; readonly options: SolveOptions }
  | ({ readonly kind: "mesh"; readonly design: Design } & GridSize)
  | { readonly kind: "parse"; readonly text: string }
  | { readonly kind: "convert"; readonly shape: Shape; readonly order: OrderKind };

export interface Answers {
  readonly solve: Solved;
  readonly mesh: MeshArrays;
  readonly parse: Parsed;
  readonly convert: Conversion;
}

/** What is sent in the place of {@link Answers}. */
export interface SentAnswers {
  readonly solve: Solved<SentMesh>;
  readonly mesh: SentMesh;
  readonly parse: Parsed;
  readonly convert: Conversion;
}

export interface Request {
  readonly id: number;
  readonly ask: Ask;
  /** The topologies whose lattice the page has. */
  readonly known: readonly string[];
  readonly spare: Spare | null;
}

export type Reply = worker.Reply<SentAnswers[Ask["kind"]]>;

export type SolverPort = worker.Port<Request, SentAnswers[Ask["kind"]]>;
