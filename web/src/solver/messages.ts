/** What the page and the solver's worker say to each other. Everything here survives structured cloning. */

import type { Facts } from "../document/describe";
import type { Design, Refusal } from "../document/types";

/** The arrays of a mesh, as the package documents them: a grid of rows by columns for every part. */
export interface MeshArrays {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
  readonly groups: Uint32Array;
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
}

export interface SolveOptions {
  readonly rows: number;
  readonly columns: number;
  /** Whether the overlay lines are wanted. */
  readonly lines: boolean;
  /** The part whose section is wanted. */
  readonly part: number;
  /** Whether the gesture is over: link and fingerprint are computed then. */
  readonly settle: boolean;
}

export interface Solved {
  readonly mesh: MeshArrays;
  readonly lines: LineArrays | null;
  readonly section: Section | null;
  readonly facts: Facts | null;
  readonly fingerprint: string;
  readonly link: string;
}

export interface Parsed {
  readonly design: Design;
  readonly link: string;
}

export type Ask =
  | { readonly kind: "solve"; readonly design: Design; readonly options: SolveOptions }
  | { readonly kind: "mesh"; readonly design: Design; readonly rows: number; readonly columns: number }
  | { readonly kind: "parse"; readonly text: string };

export interface Answers {
  readonly solve: Solved;
  readonly mesh: MeshArrays;
  readonly parse: Parsed;
}

export interface Request {
  readonly id: number;
  readonly ask: Ask;
}

export type Reply =
  | { readonly id: number; readonly ok: true; readonly answer: Answers[Ask["kind"]] }
  | { readonly id: number; readonly ok: false; readonly refusal: Refusal; readonly broken: boolean };
