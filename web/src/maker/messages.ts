/** What the page and the maker's worker say to each other. Everything here survives structured cloning. */

import type { FittedLevels } from "pasu";
import type { Look, SeenInside } from "../document/blend/looking";
import type { Method } from "../document/blend/solving";
import type { Brush } from "../document/brush";
import type { DrawnProfile } from "../document/drawn/sheet";
import type { Farthest } from "../document/extents";
import type { Lock } from "../document/locks";
import type {
  Constraints,
  Design,
  Difference,
  Format,
  Hit,
  Levels,
  Making,
  MapName,
  Measures,
  Pair,
  Product,
  Provenance,
  Report,
  Rings,
  Shape,
  Triple,
  Wall,
} from "../document/types";
import type { GridSize } from "../document/waves";
import type { Bounds } from "../solver/bounds";
import type * as worker from "../worker/port";
import type { CellsAsk, MadeCells } from "./cells";
import type { ApartAsk, Move as Clearance, TogetherAsk } from "./clearing";
import type { ReadFaces } from "./faces";
import type { PushAsk, Pushed } from "./pushing";
import type { WovenAsk, WovenShape } from "./woven";

/** The faces of a pot that its own surface does not show, ready to be drawn. The arrays may be longer than what `groups` use. */
export interface Solid {
  /** xyz triples in model units. */
  readonly positions: Float32Array;
  /** Out of the clay, split at edges. */
  readonly normals: Float32Array;
  /** Four numbers for each vertex, what the glaze goes by: 1 in the lining and 0 elsewhere, distance to rim and to foot, depth in radii of the mouth. */
  readonly wares: Float32Array;
  readonly indices: Uint32Array;
  /** (first index, count of indices, part) triples. */
  readonly groups: Uint32Array;
  /** What the pots fill, walls included; parts without one are not in it. */
  readonly bounds: Bounds | null;
  /** Their farthest points. */
  readonly farthest: Farthest;
  /** Where the clay is on the surface of each part that has a wall: within it, or around it. */
  readonly sides: readonly ("inside" | "outside" | null)[];
  /** From which height to which the outside of each part stands, where it is not its own surface. */
  readonly outsides: readonly (readonly [low: number, high: number] | null)[];
}

/** Arrays of an earlier solid, to be written over. */
export type Spare = Pick<Solid, "positions" | "normals" | "wares" | "indices">;

/** A pot that is made while a hand changes it. */
export interface Quick {
  readonly solid: Solid;
  /** The surface of the water, without its volume; null where there is none. */
  readonly water: Pick<Filled, "level" | "positions" | "indices"> | null;
  /** Milliseconds. */
  readonly took: number;
}

/** One value for each vertex of the mesh on the stage. */
export interface Painted {
  readonly values: Float32Array;
  readonly least: number;
  readonly greatest: number;
  /** The range that the colours stand for: what a few extreme places have beyond it is shown as its end. */
  readonly low: number;
  readonly high: number;
}

/** The same inside: one value for each vertex of a solid, NaN where there is none. */
export interface Lined {
  readonly values: Float32Array;
  /** Of those that there are; null where there are none. */
  readonly range: { readonly least: number; readonly greatest: number } | null;
}

/** The water in a pot: how much there is, and its surface. */
export interface Filled {
  /** Null while a hand changes the pot. */
  readonly volume: number | null;
  readonly error: number | null;
  /** Height of the surface in model units. */
  readonly level: number;
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

/** A file that is ready to be saved. */
export interface Written {
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** How far a hand has moved a point: away from the axis, up, and round the axis in radians, before placement. */
export interface Move {
  readonly out: number;
  readonly up: number;
  readonly round: number;
}

/** A hand that took hold of a shape at `at`, (u, v), and moved it. */
export interface PullAsk {
  readonly kind: "pull";
  readonly shape: Shape;
  readonly at: Pair;
  readonly by: Move;
  readonly brush: Brush;
  /** What stays as it is, by the names of the solver. */
  readonly keep: readonly string[];
  /** The wall within which the pot is to hold what it held, and what else is locked; left out where that is not asked. */
  readonly hold?: { readonly wall: Wall; readonly locked: readonly Lock[] };
}

/** The shape that followed, and how far its point stayed behind the hand. */
export interface PulledShape {
  readonly shape: Shape;
  /** The point that followed: a pull round the axis may move another one of the ring. */
  readonly at: Pair;
  readonly behind: number;
}

/** A shape of rings that says what something else said, and how far it is from that at most. */
export interface RingedShape {
  readonly shape: Rings;
  readonly distance: number;
}

/** A pot of rings before and after a hand changed it, alone in its design, and what may make up for what it holds: how high or how wide these rings are. */
export interface HoldAsk {
  readonly kind: "hold";
  readonly before: Design;
  readonly after: Design;
  readonly along: "r" | "z";
  readonly rings: readonly number[];
}

/** The pot that holds what it held before. */
export interface HeldShape {
  readonly shape: Rings;
}

/** The same blend by each method. */
export interface MethodsAsk {
  readonly kind: "methods";
  readonly design: Design;
  readonly part: number;
}

/** A blend as one method solves it. */
export interface Solved {
  readonly method: Method;
  /** Those that it uses. */
  readonly terms: readonly number[];
  readonly milliseconds: number;
  /** What it leaves of the equation inside, by samples: the largest, and the root of the mean square. */
  readonly residual: number;
  readonly mean: number;
  /** How far points inside are at most from those of the method that the blend has, and from a plain loft. */
  readonly apart: number;
  readonly fromLoft: number;
}

/** How one looks into a blend. */
export interface InsideAsk {
  readonly kind: "inside";
  readonly design: Design;
  readonly part: number;
  readonly look: Look;
}

export type Ask =
  | PullAsk
  | HoldAsk
  | CellsAsk
  | InsideAsk
  | MethodsAsk
  | WovenAsk
  | ApartAsk
  | TogetherAsk
  | PushAsk
  | {
      readonly kind: "solid";
      readonly design: Design;
      /** How far the picture may be from the faces, in model units. */
      readonly tolerance: number;
      /** Whether there is a coarser picture to look at until then. */
      readonly fine: boolean;
    }
  | {
      readonly kind: "quick";
      readonly design: Design;
      /** The parts whose walls are made; null for all. */
      readonly parts: readonly number[] | null;
      readonly tolerance: number;
      /** How full the pot is, as a share of its depth; null without water. */
      readonly fill: number | null;
      readonly spare: Spare | null;
    }
  | { readonly kind: "measure"; readonly design: Design; readonly product: Product; readonly fill: number | null }
  | { readonly kind: "check"; readonly design: Design; readonly making: Making }
  | ({ readonly kind: "paint"; readonly design: Design; readonly map: MapName } & GridSize)
  | ({
      readonly kind: "lining";
      readonly design: Design;
      readonly map: MapName;
      /** Where the vertices of the lining are (xyz); NaN for those that are none of it. */
      readonly points: Float32Array;
    } & GridSize)
  | { readonly kind: "water"; readonly design: Design; readonly level: number }
  | { readonly kind: "write"; readonly design: Design; readonly format: Format; readonly making: Making }
  | { readonly kind: "open"; readonly bytes: Uint8Array }
  /** The text of an OBJ file. */
  | { readonly kind: "faces"; readonly bytes: Uint8Array }
  | { readonly kind: "free"; readonly design: Design; readonly part: number; readonly tolerance: number }
  /** Whether no two objects run into each other, what is glued touches, and no part is inside another. */
  | { readonly kind: "constraints"; readonly design: Design }
  /** Where a ray meets the parts, the nearest first. */
  | {
      readonly kind: "pick";
      readonly design: Design;
      readonly ray: { readonly origin: Triple; readonly direction: Triple };
    }
  /** What became of the parts of one scene in another. */
  | { readonly kind: "compare"; readonly before: Design; readonly after: Design }
  | { readonly kind: "fit"; readonly profile: DrawnProfile; readonly tolerance: number }
  /** Triangles of a scan, nine numbers each. */
  | { readonly kind: "levels"; readonly positions: Float32Array }
  /** Rings through what was read of a scan. */
  | { readonly kind: "scanned"; readonly levels: Levels; readonly tolerance: number };

export interface Answers {
  readonly pull: PulledShape;
  /** Null where that cannot be had. */
  readonly hold: HeldShape | null;
  readonly cells: MadeCells;
  readonly inside: SeenInside;
  readonly methods: readonly Solved[];
  readonly woven: WovenShape;
  readonly solid: Solid;
  readonly quick: Quick;
  readonly measure: Measures;
  readonly check: Report;
  readonly paint: Painted;
  readonly lining: Lined;
  readonly water: Filled;
  readonly write: Written;
  /** The link in the file and how it was made, or null when it is not one of Pasu's. */
  readonly open: Provenance | null;
  readonly faces: ReadFaces;
  readonly free: RingedShape;
  readonly constraints: Constraints;
  readonly pick: readonly Hit[];
  /** Null where no such way is known. */
  readonly apart: Clearance | null;
  readonly together: Clearance | null;
  /** Null where nothing is met. */
  readonly push: Pushed | null;
  readonly compare: Difference;
  readonly fit: RingedShape;
  readonly levels: Levels;
  readonly scanned: ScannedShape;
}

/** Rings that stand on 0, and how far a scan is from them. */
export interface ScannedShape extends Omit<FittedLevels, "design"> {
  readonly shape: Rings;
}

export type Kind = Ask["kind"];

export interface Request {
  readonly id: number;
  readonly ask: Ask;
}

export type Reply = worker.Reply<Answers[Kind]>;

export type MakerPort = worker.Port<Request, Answers[Kind]>;
