// The interface of the package. The types of the design document are in design.d.ts.

import type { Design } from "./design.js";

export type * from "./design.js";

/** A design to read: a plain object, JSON text, a link (with or without `#`) or an address with one. */
export type DesignSource = object | string;

/** Why something was refused; stable words to match on. */
export type PasuErrorCode =
  | "not-json"
  | "unknown-field"
  | "missing-field"
  | "duplicate"
  | "wrong-type"
  | "not-finite"
  | "out-of-range"
  | "unknown-name"
  | "unknown-version"
  | "unsupported-shape"
  | "too-large"
  | "damaged-link"
  | "resonant-problem"
  | "overflow"
  | "tolerance-too-fine"
  | "no-such-point"
  | "no-wall"
  | "open-surface"
  | "pinched-surface"
  | "crosses-itself"
  | "no-opening"
  | "no-room"
  /** A function was called before `init()` had finished. */
  | "not-ready"
  /** A mistake of Pasu's own. The next call works on a fresh instance. */
  | "bug";

/** What every function throws when it refuses. */
export declare class PasuError extends Error {
  constructor(code: PasuErrorCode, path: string, message: string, options?: ErrorOptions);
  override readonly name: "PasuError";
  readonly code: PasuErrorCode;
  /** Where in the design, such as `parts[2].shape.s[0]`; empty for the design as a whole. */
  readonly path: string;
}

/** Triangles, counter-clockwise from outside. The arrays are yours. */
export interface Mesh {
  /** xyz triples, in the unit of the design, z up. */
  positions: Float32Array;
  /** Unit normals, one for each position, outward. */
  normals: Float32Array;
  /** (u, v / span) pairs, one for each position. */
  uvs: Float32Array;
  /** Three indices of vertices for each triangle. */
  indices: Uint32Array;
  /** (first index, count of indices, part) triples, one for each part. */
  groups: Uint32Array;
  /** Names the grids of the parts and their windings: meshes of equal topology have equal `uvs`, `indices` and `groups`. */
  topology: string;
  /**
   * The largest distance between the triangles and the surface, in the unit of the design; rounding is in it. Left out where both `rows` and `columns`
   * were given without a tolerance: {@link bound} finds it then.
   */
  bound?: number;
}

/**
 * How fine a mesh is. Without any of them it is good for a screen. What is not given is chosen so that as few vertices as possible hold the tolerance; rows that are chosen
 * are also placed, closer where the surface bends more, and rows that are given are even.
 */
export interface MeshOptions {
  /** The largest distance between the triangles and the surface, in the unit of the design: a promise, or the mesh is refused. */
  tolerance?: number | undefined;
  /** Vertices along `u`, from rim to foot. */
  rows?: number | undefined;
  /** Vertices along `v`, around; the last repeats the first on a closed surface. */
  columns?: number | undefined;
}

/** What is left to write when an earlier mesh is written over: the rest has not changed where it is missing. */
export type Remesh = Pick<Mesh, "positions" | "normals" | "topology"> & Partial<Mesh>;

/** First derivatives, xyz triples. */
export interface Derivatives {
  du: Float64Array;
  dv: Float64Array;
}

/**
 * Loads the WebAssembly module; wait for it before calling anything else. Calling it again does nothing.
 * @param source Where the module is, if not beside this file: an address, a response, its bytes, or a compiled module.
 */
export default function init(
  source?: string | URL | Request | Response | BufferSource | WebAssembly.Module | Promise<Response | BufferSource>,
): Promise<void>;

/** The design in canonical form: checked, defaults dropped, numbers of twelve significant digits. */
export function parse(source: DesignSource): Design;

/** The link of a design, without the leading `#`. Equal designs have equal links. */
export function link(source: DesignSource): string;

/** The surface as triangles, placed. */
export function mesh(source: DesignSource, options?: MeshOptions & { into?: undefined }): Mesh;

/**
 * The surface as triangles, placed, in the arrays of an earlier mesh: those of the right length are filled and handed back, so that a drag allocates nothing.
 *
 * Where `into.topology` is that of the new mesh too, `uvs`, `indices` and `groups` are as they were: they are not written, and are left out of the
 * result if `into` is without them.
 */
export function mesh(source: DesignSource, options: MeshOptions & { into: Partial<Mesh> }): Remesh;

/**
 * The largest distance between the surface and the triangles that {@link mesh} makes with these options, in the unit of the design. It is found from second derivatives and does
 * not fall short: what can be measured is somewhat less.
 */
export function bound(source: DesignSource, options?: MeshOptions): number;

/**
 * Exact positions of a part before placement, xyz triples.
 * @param at (u, v) pairs: `u` from 0 to 1, `v` from 0 to the span of the surface.
 */
export function evaluate(source: DesignSource, part: number, at: Float64Array | readonly number[]): Float64Array;

/** Exact first derivatives of a part before placement, at the same points as {@link evaluate}. */
export function derivatives(source: DesignSource, part: number, at: Float64Array | readonly number[]): Derivatives;

/** A short hash of the design's mesh: the same design has the same on every machine. */
export function fingerprint(source: DesignSource): string;
