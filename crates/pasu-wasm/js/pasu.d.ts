// The interface of the package. The types of the design document are in design.d.ts, those of measures and reports in answers.d.ts.

import type {
  Connectivity,
  Constraints,
  Difference,
  Hit,
  Measures,
  Pulled,
  Report,
  Ringed,
  Scanned,
} from "./answers.js";
import type { Conversion, Design, Handles, Shape, Tree, VaseOrder } from "./design.js";

export type * from "./answers.js";
export type * from "./design.js";

/** A design to read: a plain object, or as text its JSON, a link (with or without `#`) or an address with one. */
export type DesignSource = Design | string;

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
  /** A call that its `progress` ended by returning `false`. */
  | "cancelled"
  /** A function was called by a getter or a proxy in the arguments of another call, or by its `progress`. */
  | "busy"
  /** A mistake of Pasu's own. The next call works on a fresh instance. */
  | "bug";

/**
 * What the message of a refusal names, as far as it names anything: `found`, what was refused; `least` and `greatest`, the range that was expected, `above` and
 * `below`, the same without its end, `not`, a number that was not expected; `words`, one of which was expected; and what the Rust documentation of `Error::args` lists.
 */
export type PasuErrorArgs = Readonly<Record<string, number | string | readonly string[]>>;

/** What every function throws when it refuses. */
export declare class PasuError extends Error {
  constructor(
    code: PasuErrorCode,
    path: string,
    message: string,
    options?: ErrorOptions & { args?: PasuErrorArgs; place?: Point | null | undefined },
  );
  override readonly name: "PasuError";
  readonly code: PasuErrorCode;
  /** Where in the design, such as `parts[2].shape.s[0]`; empty for the design as a whole. */
  readonly path: string;
  /** What the message names: with the code, what it takes to say it in another language. */
  readonly args: PasuErrorArgs;
  /** Where in space, if it went wrong at a point of a pot, or null. */
  readonly place: Point | null;
}

/** Triangles, counter-clockwise from outside. The arrays are yours. */
export interface Mesh {
  /**
   * xyz triples, in the unit of the design, z up. With a `tolerance` the exact solution, rounded once; without one also sums in single precision, estimated (at 2.5 standard deviations)
   * to be off by no more than 5e-7 of the largest coordinate.
   */
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
   * The largest distance between the triangles and the surface, in the unit of the design; rounding is in it. Null where both `rows` and `columns`
   * were given without a tolerance: {@link bound} finds it then.
   */
  bound: number | null;
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

/** A point of the world, after placement, in the unit of the design; z is up. */
export type Point = [x: number, y: number, z: number];

/** What is made of each part: a hollow pot with the part's wall, or the surface with its ends closed for the vase mode of a slicer. */
export type Product = "pot" | "solid";

/** The size of the finished pot in the unit of the design; a capacity in its cube. Everything is scaled alike, the wall included. */
export type Size =
  | { height: number; width?: undefined; capacity?: undefined }
  | { width: number; height?: undefined; capacity?: undefined }
  | { capacity: number; height?: undefined; width?: undefined };

/**
 * Among the options of a call that may take long. At a fine tolerance and for many parts that is more than a second, so such calls belong in a worker; it learns only through a `SharedArrayBuffer`, or by a
 * request that waits, that it is to end one.
 */
export interface Watch {
  /**
   * Is told how far the call is, a number that grows from 0 to 1: at its beginning, at its end and about every twentieth of a second in between. It is an estimate. Where this returns `false` the call ends
   * with the code `cancelled`, and leaves nothing behind. What this throws the call throws. It cannot call Pasu itself, which is `busy`.
   */
  progress?: ((done: number) => unknown) | null | undefined;
}

/** What is made of a design, and how large. */
export interface Making {
  /** `"pot"` when left out. */
  product?: Product | undefined;
  /** As designed when left out. */
  size?: Size | undefined;
  /** By how many percent the clay shrinks in drying and firing, from 0 (when left out) to less than 50. What is made is larger by 1 / (1 - shrinkage / 100), so that `size` is that of the finished pot. */
  shrinkage?: number | undefined;
  /** The largest distance between triangles and the true faces, in the unit of the design, before scaling; one two-thousandth of each part's size when left out. */
  tolerance?: number | undefined;
  /**
   * By what craft it is made, which says how thin a wall may be and how far it may lean: printed, of at least 0.4 mm and better 0.8, leaning by no more than 45 degrees; or of clay, of at least
   * 1 mm and better 2. `"print"` when left out, and then nothing that is found of it is an error.
   */
  craft?: "print" | "clay" | undefined;
  /**
   * Whether a file of triangles has the parts of each object as one closed solid; apart when left out. Only {@link write} joins them. What cannot be joined is refused with `crosses-itself` at `union`, formats without triangles with
   * `out-of-range`.
   */
  union?: boolean | undefined;
}

/** What a file was made of, and how. */
export interface Provenance {
  /** The link of the design, without `#`. */
  link: string;
  /**
   * What is not in it was left out. Null where the file does not tell it (files of versions that did not, an STL without room), and where any value of it is not understood or out of its
   * range, because what is left would be another body.
   */
  making: Making | null;
}

/** What to measure. */
export interface MeasureOptions {
  /** A level, the z of the world in the unit of the design, to which the pot is filled besides the brim. */
  fill?: number | undefined;
  /** `"pot"` when left out; a solid holds nothing. */
  product?: Product | undefined;
  /** Of the clay, in g/cm3; by the clay of each part's look when left out. */
  density?: number | undefined;
}

/**
 * A kind of file, named by the ending of its files: meshes for slicers and programs, in millimetres but for `"glb"` (metres); solids for CAD; a template at true scale.
 *
 * `"obj"` names the materials of {@link objMaterials}, which are with it in the package `"obj.zip"`. `"a4.svg"` and `"letter.svg"` are the template on sheets of paper, one below the other.
 */
export type Format = "stl" | "3mf" | "glb" | "obj" | "obj.zip" | "ply" | "step" | "svg" | "a4.svg" | "letter.svg";

/** What a piece of the boundary of a pot is to a potter. */
export type FaceKind = "outer" | "lining" | "rim" | "underside" | "foot-ring" | "recess" | "floor" | "drain" | "lid";

/** What is made of a design, to be drawn. The arrays are yours. */
export interface Solid {
  /** xyz triples in the unit of the design, before `scale`. */
  positions: Float32Array;
  /** Unit vectors out of the clay, one for each position; vertices are split where faces meet. */
  normals: Float32Array;
  /** Three indices of vertices for each triangle, counter-clockwise from outside the clay. */
  indices: Uint32Array;
  /** In the order of `indices`, which they cover. */
  faces: { kind: FaceKind; part: number; first: number; count: number }[];
  /** From the design to the finished pot, from that to the raw one, and from the unit of the design to the millimetres of a file, both included. */
  scale: { size: number; shrinkage: number; millimetres: number };
}

/** What {@link sketch} is asked for. */
export interface SketchOptions {
  /** How far triangles may be from the true faces, in the unit of the design; one two-thousandth of each part's size when left out. It is aimed at, not proved. */
  tolerance?: number | undefined;
  /** How full the pot is, as a share of the depth from its lowest point to where water runs out, from 0 to 1; no water when left out. */
  fill?: number | undefined;
}

/** The faces of pots that the mesh of the design does not show. The arrays are views of the beginnings of longer ones, which are yours. */
export interface Sketch extends Omit<Solid, "scale"> {
  /** The water that was asked for; null without a fill, and where nothing holds any. */
  water: {
    /** Its height, the `z` of the world. */
    level: number;
    /** The level of the lowest point inside, and that at which water runs out. */
    range: [number, number];
    /** xyz triples of its surface. */
    positions: Float32Array;
    /** Three indices for each triangle, counter-clockwise from above. */
    indices: Uint32Array;
  } | null;
}

/** What can be painted on a surface. Curvatures are in 1 / length and 1 / area, the thickness in the unit of the design, the overhang in degrees: 0 on a vertical wall, 90 on a level ceiling. */
export type MapName = "mean-curvature" | "gaussian-curvature" | "thickness" | "overhang";

/** One number for each vertex. */
export interface Painted {
  values: Float32Array;
  least: number;
  greatest: number;
}

/** Water standing in a design. */
export interface Water {
  /** In the unit of the design cubed. */
  volume: number;
  /** How far the volume may be off. */
  error: number;
  /** Of its surface. */
  area: number;
  /** xyz triples of its surface, in the unit of the design. */
  positions: Float32Array;
  /** Three indices for each triangle, counter-clockwise from above. */
  indices: Uint32Array;
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

/** The link of a design, without the leading `#`. Equal designs have equal links. One of more than 1 MiB as JSON has none and is refused as `too-large`. */
export function link(source: DesignSource): string;

/**
 * The surface as triangles, placed.
 *
 * Where the grid is that of the mesh before, `uvs`, `indices` and `groups` are copied for you when you first read them.
 */
export function mesh(source: DesignSource, options?: MeshOptions & Watch & { into?: undefined }): Mesh;

/**
 * The surface as triangles, placed, in the arrays of an earlier mesh, so that a drag allocates nothing: each array of `into` that is long enough is written over and handed
 * back, as a view of its beginning where it is longer. For one that is too short or missing there is a new one. No two of them may share memory: one would be written over the other.
 *
 * Where `into.topology` is that of the new mesh too, `uvs`, `indices` and `groups` are as they were: they are not written, and are left out of the
 * result if `into` is without them.
 */
export function mesh(source: DesignSource, options: MeshOptions & Watch & { into: Partial<Mesh> }): Remesh;

/** What of a mesh is another than before. */
export interface Moved {
  /** Pairs of the first vertex and how many there are from it on, ascending. */
  ranges: Uint32Array;
  /** Of these vertices, one range after the other, xyz triples. */
  positions: Float32Array;
  normals: Float32Array;
}

/** A mesh of a network of patches, and what follows it while points are moved. */
export interface Followed {
  mesh: Mesh;
  /**
   * What of the mesh is another once points of the network are elsewhere: four numbers for each, which it is (from 0) and x, y, z. The next call begins from there. Whatever is on no strip of a point that moved is neither
   * solved nor sampled nor copied; every number is that of {@link mesh}. `undefined` where designs that were asked about meanwhile have taken the place of this one: then begin anew.
   */
  moved(moves: Float64Array | readonly number[]): Moved | undefined;
}

/** As {@link mesh} of a design of one part, which is a network of patches, for whoever goes on moving its points. Of `pasu/drawing` only once it is widened. */
export function follow(
  source: DesignSource,
  options: { rows: number; columns: number; into?: Partial<Mesh> },
): Followed;

/**
 * The largest distance between the surface and the triangles that {@link mesh} makes with these options, in the unit of the design. It is found from second derivatives and does
 * not fall short: what can be measured is somewhat less.
 */
export function bound(source: DesignSource, options?: MeshOptions): number;

/**
 * Exact positions of a part before placement, xyz triples.
 * @param at (u, v) pairs: `u` from 0 to 1, `v` from 0 to the span of the surface. Of a network of patches and of an octant (patch, u, v) triples, of a blend (u, v, w) triples within it, each from 0 to 1.
 */
export function evaluate(source: DesignSource, part: number, at: Float64Array | readonly number[]): Float64Array;

/** Exact first derivatives of a part before placement, at the same points as {@link evaluate}. */
export function derivatives(source: DesignSource, part: number, at: Float64Array | readonly number[]): Derivatives;

/** A short hash of the design's mesh: the same design has the same on every machine. */
export function fingerprint(source: DesignSource): string;

/**
 * A vase in another order, with what that order can hold of it: rim, foot and height always, and of the slopes at both ends what can be prescribed; from second to mixed order, which prescribes one
 * of the two, `z` leaves the rim so that it bends least on the way to a level foot. A wall of second order is the same wall in fourth order, and the way back leads to the vase that one came from. Refused is free boundary data, which has no order as a whole.
 */
export function convert(shape: Shape, order: VaseOrder): Conversion;

/**
 * What of a shape a hand can drag, and which of its numbers move then by how much. They move in proportion, so that one answer is good for a whole drag. Paths are those of the
 * shape as it is given here, which may be one that is not canonical.
 */
export function handles(shape: Shape): Handles;

/** A hand that takes hold of a point of a part and pulls it somewhere. */
export interface Hand {
  /** The point: (u, v), as {@link evaluate} takes it. */
  at: Float64Array | readonly number[];
  /** Where it is pulled, before placement. */
  to: Float64Array | readonly number[];
  /** The angle, in radians, between the two places beside the point where the pull is half as strong; all round the axis without it. */
  width?: number | undefined;
  /** At how many places round the axis the same is done; one without it. */
  petals?: number | undefined;
  /** What stays as it is: `r1` or `eta[0]` of a named family; `r`, `z` or `v` of a pot of rings; `x`, `y` or `z` of boundary data that are written out. */
  keep?: readonly string[] | undefined;
}

/**
 * The design with the least change of a part that brings a point of it to where a hand pulls it, or as near as the part can follow.
 *
 * Of `rings` and `boundary-value` the ring under the hand changes, and one is put there first where none is near: a bump as wide as is asked for is added to its radius and height, or to its `x`, `y`
 * and `z`. Of a pot of `rings`, what the hand moves round the axis moves the bump, and the point that arrives is that of the ring which is beneath `to` ({@link Pulled.at}).
 *
 * Of a named family the numbers change that are not kept, least in the sum of squares, lengths measured in the size of the vase and other numbers in what they were; the waves round the axis
 * stay, and what is equal for `x` and `y`.
 */
export function pull(source: DesignSource, part: number, hand: Hand): Design;

/** As {@link pull}, with how far the point stayed behind. */
export function pulled(source: DesignSource, part: number, hand: Hand): Pulled;

/** How near something has to come to what it stands for. */
export interface FitOptions {
  /** The largest distance, in the unit of the design or of what is drawn. */
  tolerance: number;
}

/**
 * The design with a part as a pot of `rings`, no further from what it was than a tolerance where it stands, as far as can be seen on a grid. Radius and height are read off by the angle round the axis: sections have to go
 * round it once without turning back. Wall, placement and look stay; a pot of rings stays as it is.
 */
export function free(source: DesignSource, part: number, options: FitOptions): Ringed;

/** A drawn profile: points as radius and height, in pairs, from one end to the other. */
export interface Profile {
  /** The right side: `[r, z, r, z, ..]`. */
  right: Float64Array | readonly number[];
  /** The left side, its radii positive as well; as the right one without it. */
  left?: Float64Array | readonly number[] | undefined;
}

/**
 * A pot of `rings` with a drawn profile, no place of either further from the other than a tolerance: fitted by least squares, with as few rings as were found to be enough for the tolerance, sharp where the line turns by more than 35 degrees. The lower end of the line is the foot. With a
 * left side of its own each ring has one wave of radius and height.
 */
export function fit(profile: Profile, options: FitOptions): Ringed;

/** Triangles of a pot that stands upright, as {@link Mesh} and {@link Solid} have them. */
export interface Scan {
  /** `[x, y, z, x, y, z, ..]`: points, or the corners of one triangle after the other. */
  positions: Float32Array | Float64Array;
  /** The numbers of three points for each triangle; without them every three points are one. */
  indices?: Uint32Array | undefined;
}

/**
 * A pot of `rings` through the outside of a scan, where the scan stands: with as few rings, and waves of them, as keep all of it within the tolerance, or those that come nearest; `distance` says how near. The inside is not looked at,
 * and where the scan is not closed all round the pot ends.
 */
export function fit(scan: Scan, options: FitOptions): Scanned;

/** As of a scan, of levels that were read before: another tolerance, or another size, needs no triangles. */
export function fit(levels: Levels, options: FitOptions): FittedLevels;

/** A scan of a pot that stands upright, level by level: how far its outside is from the axis in every direction. */
export interface Levels {
  /** Where the axis is, in the scan. */
  readonly axis: readonly [x: number, y: number];
  /** The lowest point of the scan, and how high it is with what is not closed all round. */
  readonly bottom: number;
  readonly height: number;
  /** Above the bottom, from the foot to the rim. */
  readonly heights: Float64Array;
  /** For each of them the distance from the axis in 180 directions, one every two degrees from that of x. */
  readonly radii: readonly Float64Array[];
  /** The share of all these places where the scan has a hole, and the wall goes on as it does to either side. To be fitted to, levels need not say it. */
  readonly holes?: number;
}

/** The outside of a scan, level by level, to which rings are fitted. Levels that are not closed all round at foot and rim are left out, holes in the wall between are bridged. */
export function levels(scan: Scan): Levels;

/** A pot of rings through the levels of a scan. */
export interface FittedLevels extends Scanned {
  /**
   * How far the outside is from the pot, level by level from the foot, in directions of equal angles from that of x: above 0 where it is outside of the pot, below 0 inside. What stands out like a
   * handle is looked at too.
   */
  readonly away: Float32Array;
}

/** What can be measured on a design, by quadrature on the closed form. */
export function measure(source: DesignSource, options?: MeasureOptions & Watch): Measures;

/** Whether a design can be made, and what differs from what was asked for, such as a ring that was fitted. What cannot be made is in the findings; only what is no design is thrown. */
export function check(source: DesignSource, making?: Making & Watch): Report;

/**
 * The bytes of a file: the same for the same design and making, on every machine and every day. It holds the link of the design, its fingerprint, the version
 * of Pasu and the verdict of the checks, as far as the format can.
 */
export function write(source: DesignSource, format: Format, making?: Making & Watch): Uint8Array<ArrayBuffer>;

/** The file of materials that OBJ files name, every glaze on every clay, to be saved as `pasu.mtl` in their folder: the same for all designs. */
export function objMaterials(): string;

/** What is made of a design, to be drawn: the triangles of the files of {@link write}, in the unit of the design, with normals. */
export function solid(source: DesignSource, making?: Making & Watch): Solid;

/**
 * The pots of a design as {@link solid} shows them, in a fraction of the time: for a screen, while a hand changes the design. Parts without a wall are passed over, and the face that is the surface
 * of the design is left out, because {@link mesh} shows it. That no faces cross is checked on a coarse mesh, so `solid` may refuse what this shows, or make it with a ring that was fitted.
 *
 * The arrays of `into` are taken as by {@link mesh}. New ones are views of the beginnings of longer ones, so that the next sketch has room in them.
 */
export function sketch(
  source: DesignSource,
  options?: SketchOptions & { into?: Partial<Pick<Sketch, "positions" | "normals" | "indices">> | undefined },
): Sketch;

/** One number for each vertex of {@link mesh} with the same options, in the same order. */
export function paint(source: DesignSource, map: MapName, options?: MeshOptions & Watch): Painted;

/** Whether two designs are one scene, whatever the order of their parts, and otherwise what became of each part. */
export function compare(before: DesignSource, after: DesignSource): Difference;

/** A ray from a point in a direction, which need not have length 1. */
export interface Ray {
  origin: Point;
  direction: Point;
}

/**
 * Where a ray meets the parts of a design, the nearest first: every place where it goes through the surface of one, to 1e-9 of the size of the part. A part with a wall is met as the clay that is made of it, outside, lining,
 * rim and all.
 *
 * Of hundreds of parts it takes longer to see that a design is the one of the call before than to answer. A text is that at once, and so is an object that is frozen through and through: whoever asks often had better pass one of them.
 */
export function pick(source: DesignSource, ray: Ray): Hit[];

/**
 * The parts of a design that hold a point, the one whose surface is nearest first: `distance` says how deep beneath it the point is, `point` where it is nearest. Octants, blends and closed networks hold what is in them, and what
 * has a wall what is in its clay; a surface without a wall holds nothing. A text or what is frozen is known again as by {@link pick}.
 */
export function at(source: DesignSource, point: Point): Hit[];

/** The one tree of a scene: its objects apart from each other, and in each its parts, glued. Numbers that are computed have all their digits. */
export function tree(source: DesignSource): Tree;

/** The design of a tree, of an object or its JSON: its leaves in their order, each where the unions above it put it. What is refused names its place in the tree. */
export function flat(tree: Tree | string): Design;

/** Which parts are glued into which object, and the symmetric matrix of which are glued to which. */
export function connectivity(source: DesignSource): Connectivity;

/** How near parts have to come to touch. */
export interface ConstraintOptions {
  /** A length in the unit of the design; the power of two below a millionth of the size of the scene without it. */
  slack?: number | undefined;
}

/**
 * Whether a scene keeps its constraints: no two discrete objects share points, the parts of one object hang together, no part is wholly inside another. Two parts interfere where a place of one is more than the slack beneath the
 * surface of the other, are in contact where they come as near as the slack and a plane is between them, and are apart otherwise. What cannot be decided within a limit of work is said to be undecided.
 */
export function constraints(source: DesignSource, options?: ConstraintOptions & Watch): Constraints;

/** The water in a design that is filled up to a level, the z of the world in the unit of the design. */
export function water(source: DesignSource, level: number): Water;

/** How finely the inside of a solid is cut. */
export interface CellsOptions {
  /** How many cells along u, v and w: 4, 16 and 16 when left out. Of a round solid those along u lie round a block in the middle, and those along v are rounded up to a multiple of 4. */
  counts?: readonly [number, number, number] | undefined;
  /** What they are; hexahedra when left out. */
  shape?: CellShape | undefined;
}

export type CellShape = "hexahedron" | "tetrahedron";

/** The inside of a solid, in model units, after placement. */
export interface Cells {
  /** x, y, z per point. */
  positions: Float64Array;
  /** The numbers of the corners, cell by cell: of a hexahedron four of one layer and four of the next, as VTK has them. */
  corners: Uint32Array;
  /** The scaled Jacobian of each cell: 1 of a box or a regular tetrahedron; what is not above 0 is of no use to a finite element. */
  quality: Float64Array;
  shape: CellShape;
}

/** What samples say of the inside of a blend: estimates, and no bounds. Places are `[u, v, w]`. */
export interface Inside {
  /** The largest length of what the equation leaves. */
  residual: number;
  residualAt: [number, number, number];
  /** The root of its mean square. */
  residualRms: number;
  /** The least determinant of the first derivatives, positive where the inside is turned as most of it is. */
  jacobian: number;
  jacobianAt: [number, number, number];
  /** Its mean: the volume. */
  jacobianMean: number;
  /** Whether the inside is turned over somewhere. */
  isFolded: boolean;
}

/** The inside of a blend without a wall as hexahedra or tetrahedra. */
export function cells(source: DesignSource, part: number, options?: CellsOptions): Cells;

/** The same as the text of a file in millimetres: VTK, Gmsh or Abaqus. */
export function cellsFile(
  source: DesignSource,
  part: number,
  format: "vtu" | "msh" | "inp",
  options?: CellsOptions,
): Uint8Array;

/** How well the inside of a blend solves its equation, and whether it is folded. */
export function inside(source: DesignSource, part: number): Inside;

/** One number for each of some points (u, v, w) inside a blend: the length of what the equation leaves, or the determinant of the first derivatives. */
export function insideValues(
  source: DesignSource,
  part: number,
  map: "residual" | "jacobian",
  at: Float64Array | readonly number[],
): Float64Array;

/** The link in a file that {@link write} wrote, without `#`; null for every other file. */
export function open(bytes: Uint8Array): string | null;

/**
 * The link in such a file, and what was made of it and how large: {@link write} makes the same file of both. Null for every other file. No bytes make it throw.
 */
export function provenance(bytes: Uint8Array): Provenance | null;
