/** What the page and the solver's worker say to each other. Everything here survives structured cloning. */

import type { Body } from "../document/body";
import type { Points } from "../document/mixing";
import type { Conversion, Design, Handles, OrderKind, Placement, Shape } from "../document/types";
import type { GridSize } from "../document/waves";
import type { PartId } from "../state/part-ids";
import type * as worker from "../worker/port";
import type { Bounds } from "./bounds";
import type { Moved } from "./moved";
import type { Ware } from "./ware";
import type { Written } from "./written";

/** What depends on the grid alone. Meshes of the same topology share these very arrays. */
export interface Lattice {
  readonly uvs: Float32Array;
  readonly indices: Uint32Array;
}

/** What is different in every mesh. */
export interface Surface {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly topology: string;
  readonly ware: Ware;
}

/** The mesh of one part, before placement: a grid of rows by columns, with what its picture needs besides. */
export interface PartMesh extends Surface, Lattice {
  /** What was written over in its arrays. */
  readonly writes?: Written;
}

/** A mesh on its way: the page has the lattice already, or it comes along. */
export interface SentMesh extends Surface {
  readonly lattice: Lattice | null;
  /** By what the worker knows it again, where what comes after it may be sent as a change of it. */
  readonly serial?: number;
}

/** What of a mesh that the page has is another: pairs of the first vertex and how many there are from it on, and what these have, one range after the other. */
export interface MeshChange {
  readonly ranges: Uint32Array;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly serial: number;
}

/** A mesh that may be given back, as far as that goes. */
export type Used = Pick<Surface, "positions" | "normals" | "ware">;

/** Arrays of an earlier mesh, to be written over. */
export interface Spare {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texels: Float32Array;
}

/** What is known of a part from its mesh. */
export interface PartFacts {
  /** The points (xyz, before placement) that tell how far it reaches. */
  readonly reach: Float32Array;
  /** What it fills before placement. */
  readonly bounds: Bounds | null;
  /** What there is to say of it, scaled and turned as it was asked for. */
  readonly body: Body | null;
  readonly closed: boolean;
}

/** Curves on a part, xyz triples before placement. */
export interface PartLines {
  readonly iso_u: readonly Float32Array[];
  readonly iso_v: readonly Float32Array[];
  /** At `u = 0` and at `u = 1`. */
  readonly ends: readonly [Float32Array, Float32Array];
  readonly tangents: { readonly at: Float64Array; readonly along: Float64Array };
}

/** Curves on a part where it stands, xyz triples. */
export interface LineArrays {
  readonly iso_u: Float32Array[];
  readonly iso_v: Float32Array[];
  readonly rim: Float32Array;
  readonly foot: Float32Array;
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

/** How a mesh is wanted. */
export interface MeshWanted extends GridSize {
  /** The grid of what the glaze goes by. */
  readonly ware: GridSize;
  /** Whether the overlay lines are wanted. */
  readonly lines: boolean;
  /** Whether its size is told of every vertex: under the hand fewer will do. */
  readonly exact: boolean;
  /** The serial of the mesh of this part that the page has, if it may be changed. */
  readonly has?: number;
}

/** What is asked of one part: of its shape alone, wherever it stands. */
export interface PartAsk {
  readonly id: PartId;
  /** Its number in the design, by which refusals name it. */
  readonly place: number;
  readonly shape: Shape;
  /** Whether it is a solid of which a wall leaves the flank alone. */
  readonly hollow: boolean;
  /** How it is scaled and turned, for what is told of it and for how its glaze runs. */
  readonly turn: Placement | undefined;
  /** Null where its mesh is there. */
  readonly mesh: MeshWanted | null;
  readonly section: boolean;
}

/** A whole design, whose gesture is over. */
export interface WholeAsk extends GridSize {
  readonly design: Design;
}

/** What is known of a whole design. */
export interface Whole {
  /** The largest distance of the triangles from the true surface. */
  readonly bound: number | null;
  readonly fingerprint: string;
  readonly link: string;
}

/** Times of the worker, in milliseconds on the clock of the page's `performance.timeOrigin + performance.now()`. */
export interface Times {
  readonly begun: number;
  /** The meshes stood. */
  readonly meshed: number;
  /** The coarse meshes for the glaze stood: with the one before, what solving took and what sampling. */
  readonly glazed: number;
  /** Everything stood. */
  readonly done: number;
}

/** What was solved of one part. */
export interface SentPart {
  readonly id: PartId;
  readonly mesh: SentMesh | null;
  /** In its place, what of the mesh is another that the page has. */
  readonly change?: MeshChange;
  readonly told: PartFacts | null;
  readonly lines: PartLines | null;
  readonly section: Section | null;
}

export interface SentParts {
  readonly parts: readonly SentPart[];
  readonly whole: Whole | null;
  readonly times: Times;
}

export interface Parsed {
  readonly design: Design;
  readonly link: string;
}

/** The parts that are not there yet, and what is known of all together. */
export interface PartsAsk {
  readonly kind: "parts";
  readonly parts: readonly PartAsk[];
  readonly whole: WholeAsk | null;
}

export type Ask =
  | PartsAsk
  | { readonly kind: "parse"; readonly text: string }
  | { readonly kind: "read"; readonly shape: Shape; readonly at: Float64Array }
  | { readonly kind: "convert"; readonly shape: Shape; readonly order: OrderKind };

/** What is sent for each. */
export interface SentAnswers {
  readonly parts: SentParts;
  readonly parse: Parsed;
  readonly read: Points;
  readonly convert: Conversion;
}

/** A part as it travels. */
export type SentPartAsk = Omit<PartAsk, "shape"> & { readonly shape: Shape | Moved };

/** Parts as they travel; the whole design comes before them. */
export type SentPartsAsk = Omit<PartsAsk, "parts" | "whole"> & {
  readonly parts: readonly SentPartAsk[];
  readonly whole: SentWholeAsk | null;
};

/** A whole design as it travels: its large networks are such that the worker may know already. */
export interface SentWholeAsk extends GridSize {
  readonly design: Omit<Design, "parts"> & {
    readonly parts: readonly (Omit<Design["parts"][number], "shape"> & { readonly shape: Shape | Moved })[];
  };
}

export interface Request {
  readonly id: number;
  readonly ask: SentPartsAsk | Exclude<Ask, PartsAsk>;
  /** The topologies whose lattice the page has. */
  readonly known: readonly string[];
  /** One for each of the first parts that are asked for, where there are any of its size. */
  readonly spares: readonly (Spare | null)[];
}

export type Reply = worker.Reply<SentAnswers[Ask["kind"]]>;

export type SolverPort = worker.Port<Request, SentAnswers[Ask["kind"]]>;
