// Generated from the structures of the Rust crate `pasu`. Do not edit.

import type { Design, FaceKind, PasuErrorArgs, Point, Product, Unit, Wall } from "./pasu.js";

/** A value with a bound on its error, both in the same unit. The error is an estimate on the safe side: what the last refinement changed, and the rounding of the sums. It covers the quadrature and the search, not the clay. */
export interface Quantity {
  /** The value. */
  readonly value: number;
  /** How far it may be off; never negative. */
  readonly error: number;
}

/** A value and where it is. */
export interface Located {
  /** The value. */
  readonly value: number;
  /** How far it may be off; never negative. */
  readonly error: number;
  /** Where, in model units after placement. */
  readonly at: Point;
}

/** The measures of a design and of its parts. `docs/measures.md` defines every one. Lengths are in the unit of the design, areas and volumes in its square and cube, angles in degrees, masses in grams; `z` of the world is up. */
export interface Measures extends BodyMeasures {
  /** The unit of length. */
  readonly unit: Unit;
  /** What was measured. */
  readonly product: Product;
  /** Of each part. */
  readonly parts: readonly PartMeasures[];
}

/** What can be said of one part and of several together. */
export interface BodyMeasures {
  /** From the lowest to the highest point. */
  readonly height: Quantity;
  /** The lowest `z`. */
  readonly bottom: number;
  /** The highest `z`. */
  readonly top: number;
  /** Caliper widths of the silhouette from above. */
  readonly width: Width;
  /** Area of the design surface, one side. */
  readonly area: Quantity;
  /** The clay; null without a wall. */
  readonly clay: ClayMeasures | null;
  /** What it holds; null where it holds nothing. */
  readonly capacity: Capacity | null;
  /** Centre of mass of the clay, and of clay and water to the brim. */
  readonly centre: { readonly empty: Centre | null; readonly full: Centre | null };
  /** What it stands on; null without a wall. */
  readonly footprint: Footprint | null;
  /** How far it can be tilted. Water is taken as it lies upright. */
  readonly tipping: { readonly empty: Tipping | null; readonly full: Tipping | null };
}

/** The least and the greatest distance of two parallel upright boards on either side of a pot. */
export interface Width {
  /** The least. */
  readonly least: Quantity;
  /** The greatest. */
  readonly greatest: Quantity;
  /** The direction across the boards of the least width, in degrees anticlockwise from `x`, 0 to 180. */
  readonly leastDirection: number;
  /** The same of the greatest width. */
  readonly greatestDirection: number;
}

/** The clay of a pot. */
export interface ClayMeasures {
  /** Of its whole boundary. */
  readonly area: Quantity;
  /** Its volume. */
  readonly volume: Quantity;
  /** Its mass in grams. */
  readonly mass: Quantity;
}

/** What a pot holds. */
export interface Capacity {
  /** To the brim, in the position in which it is placed. */
  readonly brim: Quantity;
  /** Where water first runs out. */
  readonly spill: Spill;
  /** The `z` of the lowest point inside. */
  readonly floor: number;
  /** Up to the level that was asked for. */
  readonly fill: Fill | null;
  /** Whether there is a drain hole, which is taken as stopped. */
  readonly stopped: boolean;
}

/** Where water first runs out of a pot. */
export interface Spill {
  /** The `z` of the water then. */
  readonly level: Quantity;
  /** The point. */
  readonly at: Point;
}

/** A pot that is filled to a level. */
export interface Fill {
  /** The `z` of the water. */
  readonly level: number;
  /** Of the water, in the unit of the design cubed. */
  readonly volume: Quantity;
}

/** A centre of mass. */
export interface Centre {
  /** Where it is. */
  readonly at: Point;
  /** How far each coordinate may be off. */
  readonly error: number;
}

/** What a pot stands on. */
export interface Footprint {
  /** The `z` of the table. */
  readonly level: number;
  /** The area that touches the table: 0 where the pot stands on points or edges. */
  readonly area: Quantity;
  /** The area of the convex hull of what touches. */
  readonly hullArea: Quantity;
  /** The hull, anticlockwise: all its corners, or a polygon of up to 128 where it is round. */
  readonly hull: readonly (readonly [x: number, y: number])[];
}

/** How far a pot can be tilted. */
export interface Tipping {
  /** The smallest tilt, in degrees, at which the centre of mass is above an edge of the footprint's hull; 0 where it never was above the hull. */
  readonly degrees: number;
  /** How far that may be off. */
  readonly error: number;
  /** The direction in which it then falls, in degrees anticlockwise from `x`. */
  readonly toward: number;
}

/** The measures of one part. */
export interface PartMeasures extends BodyMeasures {
  /** Its number. */
  readonly part: number;
  /** Its name. */
  readonly name: string | null;
  /** Whether it has a wall, and can have it. What runs through itself is no pot; of a body for which its surface asks more than 50,000 triangles that is left to `check`. */
  readonly isPot: boolean;
  /** Why it is no pot, in words; null where it is one. */
  readonly reason: string | null;
  /** Why it holds nothing, in words; null where it holds something. */
  readonly capacityReason: string | null;
  /** Why it is no pot, for whoever says it in another language: what would be refused; null where it is one. */
  readonly cause: Cause | null;
  /** The same of why it holds nothing. Besides the codes of refusals it is `solid`, `no-foot`, `no-bottom` of a tube, `dry` where no water stays in this position, or `too-long` where nobody would wait for it. */
  readonly capacityCause: Cause | null;
  /** The thickness of the wall along the normal. */
  readonly thickness: ThicknessRange | null;
  /** The largest overhang of the outside. */
  readonly overhang: Overhang | null;
  /** The largest overhang of the lining. */
  readonly overhangInside: Overhang | null;
  /** Curvature of the design surface. */
  readonly curvature: Curvature;
}

/** Why there is something not, without the sentence. */
export interface Cause {
  /** A stable kebab-case word. */
  readonly code: string;
  /** What of the design it is about, such as `parts[0].wall.foot`; null where that is no single field. */
  readonly path: string | null;
  /** What the sentence names, as `Error::args` has it. */
  readonly args: PasuErrorArgs;
}

/** How thick a wall is. */
export interface ThicknessRange {
  /** The thickness asked for. */
  readonly asked: number;
  /** The least. */
  readonly least: LeastThickness;
  /** The greatest. */
  readonly greatest: Quantity;
  /** The share of the wall, 0 to 1, that is thinner than asked for. */
  readonly thinned: Quantity;
}

/** The least thickness of a wall. */
export interface LeastThickness {
  /** The value. */
  readonly value: number;
  /** How far it may be off; never negative. */
  readonly error: number;
  /** Where, if it is less than asked for. */
  readonly at: Point | null;
}

/** How far a wall leans over what is below. */
export interface Overhang {
  /** The angle against the vertical, in degrees: 0 is a vertical wall, 90 a level ceiling, less than 0 a wall that faces up. */
  readonly degrees: number;
  /** How far that may be off. */
  readonly error: number;
  /** Where. */
  readonly at: Point;
  /** What overhangs. */
  readonly face: FaceKind;
}

/** Ranges of mean and Gaussian curvature. */
export interface Curvature {
  /** Half the sum of the principal curvatures, positive where the surface bends like a ball seen from outside. */
  readonly mean: CurvatureRange;
  /** The product of the principal curvatures. */
  readonly gaussian: CurvatureRange;
}

/** The range of a curvature; a bound is null where the curvature grows without one. */
export interface CurvatureRange {
  /** The least. */
  readonly least: Located | null;
  /** The greatest. */
  readonly greatest: Located | null;
}

/** The verdict on a design: can it be made, and what was found. */
export interface Report {
  /** Whether nothing was found that keeps the design from being made. */
  readonly ok: boolean;
  /** What was to be made. */
  readonly product: Product;
  /** The number of triangles of all parts. */
  readonly triangles: number;
  /** The number of vertices of all parts. */
  readonly vertices: number;
  /** What was found, errors first. */
  readonly findings: readonly Finding[];
  /** One entry per part that could be meshed. */
  readonly meshes: readonly MeshReport[];
  /** One entry per object whose parts were to be joined and could be. */
  readonly unions: readonly UnionReport[];
}

/** One thing that a check found. */
export interface Finding {
  /** A stable kebab-case word: `fitted-foot` and `fitted-drain` where a ring or a drain is not the one that was asked for, `thinned`, `too-thin`, `thin-base`, `overhang`, `ceiling`, `overlap`, `same-place`, `folded` and `few-terms` of the inside of a blend, `tolerance-too-fine` where the mesh does not keep the tolerance that was asked for, or the code of the error that refuses the part. */
  readonly code: string;
  /** How much it matters. */
  readonly severity: "error" | "warning" | "note";
  /** The part that it is about. */
  readonly part: number;
  /** What of the design it is about, such as `parts[0].wall.foot`, or `tolerance` of the making; null where that is no single field. */
  readonly path: string | null;
  /** One sentence in a potter's words. */
  readonly message: string;
  /** What the sentence names, as `Error::args` has it: with the code it takes no more to say it in another language. Lengths are in the unit of the design; those whose names end in `Mm` are in millimetres of what is made, angles in degrees. */
  readonly args: PasuErrorArgs;
  /** Where, in model units after placement. */
  readonly at: Point | null;
  /** Of a part that is refused the nearest change of the wall that was found to help, and of a ring or drain that was fitted the wall that is made; null where there is none. */
  readonly remedy: Remedy | null;
}

/** The nearest wall that was found to make a pot of a part that is refused. */
export interface Remedy {
  /** Where it belongs in the design, such as `parts[0].wall`. */
  readonly path: string;
  /** The whole wall, to be put there. */
  readonly wall: Wall;
  /** What is different of it, in words. */
  readonly message: string;
}

/** What the checks counted on the mesh of one part, on the coordinates that a file holds. */
export interface MeshReport {
  /** The part. */
  readonly part: number;
  /** Number of vertices. */
  readonly vertices: number;
  /** Number of triangles. */
  readonly triangles: number;
  /** Whether every edge is shared by two triangles that pass it in opposite directions, and the triangles at each vertex are one fan. */
  readonly closed: boolean;
  /** Number of handles: 0 for a cup, 1 for a tube or a pot with a drain. It is null where the mesh is not closed. */
  readonly genus: number | null;
  /** Number of triangles without area. */
  readonly degenerate: number;
  /** Number of pairs of triangles that cross or touch where they should not. */
  readonly crossings: number;
  /** The largest distance between the triangles and the true faces, in model units: a bound for the surface of the design, an estimate for the other faces. */
  readonly bound: number;
  /** The share of the wall that is thinner than asked for, from 0 to 1. */
  readonly thinned: number;
  /** The thinnest the wall is, in model units; null for a solid. */
  readonly thinnest: number | null;
}

/** What the checks counted on the one solid that the parts of an object are, where they were to be joined (`Making::union`). */
export interface UnionReport {
  /** The parts that it is of, in the order in which a file has them. */
  readonly parts: readonly number[];
  /** Number of vertices. */
  readonly vertices: number;
  /** Number of triangles. In a file with colours, a part whose glaze ends at a line has a few more. */
  readonly triangles: number;
  /** How many bodies it is: more than 1 where parts do not touch. */
  readonly bodies: number;
  /** Number of handles of all its bodies. */
  readonly genus: number;
  /** The largest distance between its triangles and the true faces of its parts, in model units: the largest `bound` of these, and how far they are moved where their surfaces cannot be told apart otherwise. */
  readonly bound: number;
}

/** A design whose part was pulled. */
export interface Pulled {
  /** The design. */
  readonly design: Design;
  /** The point that was to arrive: where the hand took hold, but of a pot of rings that is pulled round the axis with another `v`. */
  readonly at: readonly [x: number, y: number];
  /** The distance between the point and where it was pulled: 0 but for rounding where the shape can follow. */
  readonly behind: number;
}

/** A design of rings that says what something else said. */
export interface Ringed {
  /** The design. */
  readonly design: Design;
  /** How far it is from what it stands for, at most. Of a drawn line a bound, both ways; of a part the largest distance that was found, where it stands: an estimate, since it is looked for at samples. */
  readonly distance: number;
}

/** A pot of rings through a scan. */
export interface Scanned {
  /** The design, where the scan stands. */
  readonly design: Design;
  /** How far the scan is from it at most. An estimate: it is looked for at some ten thousand points of the outside. */
  readonly distance: number;
  /** The root of the mean of the squares of these distances. */
  readonly rms: number;
  /** The same where what stands out at one side like a handle is left out of account, which no ring goes round; null where nothing does. */
  readonly withoutHandle: Apart | null;
}

/** How far a scan is from a pot. */
export interface Apart {
  /** At most. */
  readonly distance: number;
  /** The root of the mean of the squares. */
  readonly rms: number;
}

/** How a scene differs from another. Every part of the first is kept, moved, changed or gone, every part of the second kept, moved, changed or added. Titles and names are not compared, but what differs is looked for under its name first. */
export interface Difference {
  /** Whether both are one scene: the same parts in the same places, glued in the same way, in the same unit. */
  readonly isSame: boolean;
  /** Parts that are the same in both. */
  readonly kept: readonly Counterpart[];
  /** Parts that stand elsewhere, or are of another size by their placement. */
  readonly moved: readonly Counterpart[];
  /** Parts of one name, or of one kind in one place, whose shape, wall or look is another. */
  readonly changed: readonly Counterpart[];
  /** Numbers of the parts that only the first scene has. */
  readonly gone: readonly number[];
  /** Numbers of the parts that only the second scene has. */
  readonly added: readonly number[];
  /** Of the parts that both have, those that are glued to others of them than before. */
  readonly reglued: readonly Counterpart[];
}

/** A part that is in both scenes, by its number in each. */
export interface Counterpart {
  /** In the first scene. */
  readonly before: number;
  /** In the second scene. */
  readonly after: number;
}

/** A place where a ray meets a part, or the place of the surface of a part that is nearest to a point in it. */
export interface Hit {
  /** The number of the part. */
  readonly part: number;
  /** How far it is from the origin of the ray, or how deep the point is beneath the surface. */
  readonly distance: number;
  /** The place, after placement. */
  readonly point: Point;
  /** The unit vector out of the part there; of a surface without an inside, out of the pot. */
  readonly normal: Point;
  /** Of a part with a wall what it is of that; null where the part has none. */
  readonly face: FaceKind | null;
  /** Of a part without a wall the number of the patch, of which a surface between two curves has one; null where it has a wall. */
  readonly patch: number | null;
  /** Along the patch, as in `evaluate`; null of a part with a wall, and of an octant. */
  readonly u: number | null;
  /** Across the patch, as in `evaluate`; null where `u` is. */
  readonly v: number | null;
}

/** Which parts of a design are glued to which, and to which discrete object each belongs; parts by their number in the document. */
export interface Connectivity {
  /** The discrete object of each part; objects are numbered 0, 1, 2 as they first appear. */
  readonly objects: readonly number[];
  /** Row by row, for each pair of parts whether both are glued into one object. Symmetric; each part is glued to itself. */
  readonly glued: readonly (readonly boolean[])[];
}

/** Whether a scene keeps its constraints. */
export interface Constraints {
  /** Whether all three are kept: nothing is broken, and nothing undecided. */
  readonly isKept: boolean;
  /** The slack within which parts touch, in the unit of the design. */
  readonly slack: number;
  /** What breaks a constraint, what could not be decided, and which discrete objects touch. */
  readonly breaches: readonly Breach[];
  /** How many more there are than are told. */
  readonly leftOut: number;
}

/** What two parts are to each other, where that is to be known. */
export interface Breach {
  /** A stable kebab-case word: `interference` of parts of different objects, `not-connected` of parts that touch none of the others of their object, `within` of a part wholly inside another, `same-place` of one body twice; `contact` of objects that touch; `undecided-interference`, `undecided-connection` and `undecided-within` where the limit of work was not enough. */
  readonly code: string;
  /** An error breaks a constraint, a warning is undecided, a note is a contact. */
  readonly severity: "error" | "warning" | "note";
  /** The part that it is about. */
  readonly part: number;
  /** The other part. */
  readonly other: number;
  /** All parts that it is about, in the order of the document: of `not-connected` and `undecided-connection` those that hang together with `part`, of all else `part` alone. */
  readonly group: readonly number[];
  /** One sentence. */
  readonly message: string;
  /** What the sentence names, as `Error::args` has it: the names of both parts, and of a group of several how many they are. */
  readonly args: PasuErrorArgs;
  /** A witness: of interference a place of one part in the other, of contact where they touch, of what is not connected a place of `part` towards the other, in model units after placement. */
  readonly at: Point | null;
  /** How deep the witness is beneath the surface at least of that one of the two parts within which it lies (it may be on the surface of the other), or how far what is not connected is away at least. */
  readonly distance: number | null;
  /** Whether it rests on proved bounds alone. Bounds of the faces of walls are measured. */
  readonly isProved: boolean;
}
