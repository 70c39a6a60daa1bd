// Generated from the field tables of the Rust crate `pasu`. Do not edit.

/** A design: what a person has chosen. */
export interface Design {
  /** The version of the format. */
  readonly pasu: 1;
  /** At most 200 characters of plain text. */
  readonly title?: string;
  /** What 1 means; centimetres when left out. */
  readonly unit?: Unit;
  /** 1 to 500 parts. */
  readonly parts: readonly Part[];
}

/** One placed surface of a design. */
export interface Part {
  /** A name that no other part has. */
  readonly name?: string;
  /** The discrete object that it is glued into; 0 when left out. */
  readonly object?: number;
  /** Its surface, before placement. */
  readonly shape: Shape;
  /** Where it stands. */
  readonly place?: Placement;
  /** The wall that makes its surface a pot. */
  readonly wall?: Wall;
  /** Its clay and glaze. */
  readonly look?: Look;
  /** By which numbers of its placement it can be moved. */
  readonly joints?: Joints;
}

/** The unit of length. */
export type Unit = "cm" | "mm" | "in";

/** A surface. */
export type Shape =
  | SecondOrder
  | MixedOrder
  | FourthOrder
  | BloorWilson
  | BoundaryValue
  | Rings
  | VertexFrame
  | Blend
  | Octant;

/** The vase of ZY01 equations 1 to 8. */
export interface SecondOrder {
  readonly kind: "second-order";
  /** Radius and petals of the rim, radius and petals of the foot: r1, r2, r3, r4. */
  readonly r: readonly [number, number, number, number];
  /** How often the outline and its petals go round: n1, n2. The surface closes when both are whole. */
  readonly n?: readonly [number, number];
  /** The height of the rim above the foot. */
  readonly height?: number;
  /** Shape control parameters of the second derivative along the profile, for x and for y. Not 0. */
  readonly s?: readonly [number, number];
  /** Shape control parameters of the second derivative round the pot, for x and for y. */
  readonly t?: readonly [number, number];
  /** Sculpting force on the outline: p0 + p1 u. */
  readonly force?: readonly [number, number];
}

/** The vase of ZY01 equations 9 to 12. */
export interface MixedOrder {
  readonly kind: "mixed-order";
  /** Radius and petals of the rim, radius and petals of the foot: r1, r2, r3, r4. */
  readonly r: readonly [number, number, number, number];
  /** How often the outline and its petals go round: n1, n2. The surface closes when both are whole. */
  readonly n?: readonly [number, number];
  /** The height of the rim above the foot. */
  readonly height?: number;
  /** Shape control parameters of the second derivative along the profile, for x and for y. Not 0. */
  readonly s?: readonly [number, number];
  /** Shape control parameters of the second derivative round the pot, for x and for y. */
  readonly t?: readonly [number, number];
  /** Sculpting force on the outline: p0 + p1 u. */
  readonly force?: readonly [number, number];
  /** The slope of the height at the rim: h0'. */
  readonly rise: number;
}

/** The vase of ZY01 equations 13 to 17. */
export interface FourthOrder {
  readonly kind: "fourth-order";
  /** The radius of the foot. */
  readonly r0: number;
  /** The radius of the rim. */
  readonly r1: number;
  /** The radius at mid-height towards which the wall is bent. */
  readonly rm: number;
  /** The height of the rim above the foot. */
  readonly h1: number;
  /** How strongly the wall leaves the foot and meets the rim: eta1, eta2. */
  readonly eta: readonly [number, number];
  /** The slope of the height at the foot and at the rim: h0', h1'. */
  readonly dz: readonly [number, number];
  /** Shape control parameters of the fourth derivative along the profile, for x and for y. Not 0. */
  readonly s: readonly [number, number];
  /** Shape control parameters of the mixed derivative, for x and for y. */
  readonly t: readonly [number, number];
  /** Shape control parameters of the fourth derivative round the pot, for x and for y. */
  readonly w: readonly [number, number];
}

/** The vase of IA equations 15 to 18. */
export interface BloorWilson {
  readonly kind: "bloor-wilson";
  /** The smoothing parameter: how strongly the wall is drawn towards a round tube. */
  readonly a: number;
  /** Radius of the rim, the two parts of its skew, radius of the foot: r1, r2, r3, r4. */
  readonly r: readonly [number, number, number, number];
  /** The slopes that go with r: R1, R2, R3, R4. */
  readonly R: readonly [number, number, number, number];
  /** The height of the rim and how far its waves rise and fall: h0, h1. */
  readonly h: readonly [number, number];
  /** The slopes that go with h: H0, H1. */
  readonly H: readonly [number, number];
  /** The number of waves of the rim. The surface closes when it is whole. */
  readonly n1: number;
}

/** Fourier boundary data written out, component by component. */
export interface BoundaryValue {
  /** Any Fourier boundary data. */
  readonly kind: "boundary-value";
  /** The length of the interval of v round the axis. */
  readonly span: number | "2pi";
  /** Curves between the two ends that it passes through, in ascending u inside (0, 1), at most 64. */
  readonly rings?: readonly Ring[];
  /** The equation and the data of x. */
  readonly x: Component;
  /** The equation and the data of y. */
  readonly y: Component;
  /** The equation and the data of z, the axis of a pot. */
  readonly z: Component;
}

/** A curve of constant u between the two ends that the surface passes through. */
export interface Ring {
  /** Where it is, inside (0, 1). */
  readonly u: number;
  /** Whether the profile has a corner there; false when left out. A component of order 2 has one at every ring. */
  readonly sharp?: boolean;
}

/** The equation and the boundary data of one component. */
export type Component = SecondOrderComponent | FourthOrderComponent;

/** A component of order 2. */
export interface SecondOrderComponent {
  /** The order of the equation s X_uu + t X_vv = p. */
  readonly order: 2;
  /** Shape control parameter of the highest u derivative; not 0. */
  readonly s: number;
  /** Shape control parameter of the v derivative. */
  readonly t: number;
  /** The Fourier sum of boundary data and force. */
  readonly modes: readonly Mode<SecondOrderDatum>[];
}

/** A component of order 4. */
export interface FourthOrderComponent {
  /** The order of the equation s X_uuuu + t X_uuvv + w X_vvvv = p. */
  readonly order: 4;
  /** Shape control parameter of the highest u derivative; not 0. */
  readonly s: number;
  /** Shape control parameter of the mixed derivative. */
  readonly t: number;
  /** Shape control parameter of the fourth v derivative. */
  readonly w: number;
  /** Ends whose slopes are not given: the second derivative in u is 0 there instead. No end when left out. */
  readonly free?: "start" | "end" | "both";
  /** The Fourier sum of boundary data and force. */
  readonly modes: readonly Mode<FourthOrderDatum>[];
}

/** One harmonic; data left out are 0. */
export interface Mode<Datum> {
  /** How often it goes round; the surface closes when it is whole. */
  readonly n: number;
  /** The data of cos(2 pi n v / span). */
  readonly cos?: Datum;
  /** The data of sin(2 pi n v / span). */
  readonly sin?: Datum;
}

/** What a harmonic of order 2 is given; what is left out is 0. */
export interface SecondOrderDatum {
  /** Value at u = 0. */
  readonly start?: number;
  /** Value at u = 1. */
  readonly end?: number;
  /** Values at the rings, one for each; 0 at all of them when left out. */
  readonly rings?: readonly number[];
  /** Sculpting force in ascending powers of u, at most 512 coefficients. */
  readonly force?: readonly number[];
}

/** What a harmonic of order 4 is given; what is left out is 0. */
export interface FourthOrderDatum {
  /** Value at u = 0. */
  readonly start?: number;
  /** Value at u = 1. */
  readonly end?: number;
  /** Slope in u at u = 0. */
  readonly start_u?: number;
  /** Slope in u at u = 1. */
  readonly end_u?: number;
  /** Values at the rings, one for each; 0 at all of them when left out. */
  readonly rings?: readonly number[];
  /** Sculpting force in ascending powers of u, at most 512 coefficients. */
  readonly force?: readonly number[];
}

/** A pot through any number of rings, each a radius and a height. */
export interface Rings {
  /** A pot by the radius and the height of its rings. */
  readonly kind: "rings";
  /** The smoothing parameter: how strongly the wall is drawn towards a round tube; 1 when left out. */
  readonly a?: number;
  /** 2 to 66 rings from the foot, at u = 0, to the rim, at u = 1. */
  readonly rings: readonly Hoop[];
  /** The slopes at the foot; without them it is free. */
  readonly foot?: Slopes;
  /** The slopes at the rim; without them it is free. */
  readonly rim?: Slopes;
}

/** One ring of a pot. */
export interface Hoop {
  /** Where it is along the profile, beyond the one before it. */
  readonly u: number;
  /** Its radius. */
  readonly r: Series;
  /** Its height. */
  readonly z: Series;
  /** Whether the profile has a corner there; false when left out. */
  readonly sharp?: boolean;
}

/** Derivatives in u of radius and height at an end. */
export interface Slopes {
  /** Of the radius. */
  readonly r: Series;
  /** Of the height. */
  readonly z: Series;
}

/** A mean with waves round the axis. */
export interface Series {
  /** The mean round the axis. */
  readonly mean: number;
  /** What goes up and down about it. */
  readonly waves?: readonly Wave[];
}

/** One harmonic of a series. */
export interface Wave {
  /** How often it goes up and down round the axis: whole, and 1 or more. */
  readonly n: number;
  /** How far as cos(n v); 0 when left out. */
  readonly cos?: number;
  /** How far as sin(n v); 0 when left out. */
  readonly sin?: number;
}

/** Four-sided patches through a network of points. */
export interface VertexFrame {
  /** Four-sided patches through a network of points. */
  readonly kind: "vertex-frame";
  /** The points, at most 800,000. */
  readonly vertices: readonly (readonly [number, number, number])[];
  /** 1 to 100,000 patches. */
  readonly patches: readonly FramePatch[];
  /** How the cubic terms of the edges are decided: by all patches of a strip, or by the first from a patch on; global when left out. */
  readonly rule?: "global" | { readonly seed: number };
  /** How smoothly patches meet; C0 when left out. */
  readonly continuity?: "C0";
  /** Edges at which the surface turns by less than this angle are drawn as if it were smooth, in radians; 0.5 when left out. Not less than 0. */
  readonly crease?: number;
}

/** One patch of a network. */
export interface FramePatch {
  /** The numbers of eight vertices: corners and middles of the edges in turn, from (u, v) = (0, 0) by way of (1, 0). */
  readonly frame: readonly [number, number, number, number, number, number, number, number];
  /** Shape control parameters of X_uu; 1 when left out. */
  readonly a1?: readonly [number, number, number];
  /** Shape control parameters of X_vv; 1 when left out. */
  readonly a2?: readonly [number, number, number];
  /** Sculpting forces, which add up; at most 64. */
  readonly forces?: readonly Force[];
}

/** A sculpting force on a patch. */
export interface Force {
  /** How strong it is. */
  readonly f0: readonly [number, number, number];
  /** From where to where along u, ascending; 0 to 1 when left out. */
  readonly u?: readonly [number, number];
  /** From where to where along v, ascending; 0 to 1 when left out. */
  readonly v?: readonly [number, number];
  /** How it falls off towards the rim of that rectangle; sine when left out. */
  readonly falloff?: Falloff;
}

/** How a force falls off. */
export type Falloff = "sine" | "smooth";

/** A solid that flows from one section into another (ZY04). */
export interface Blend {
  /** A solid that flows from one section into another. */
  readonly kind: "blend";
  /** The section at w = 0. */
  readonly start: Section;
  /** The section at w = 1. */
  readonly end: Section;
  /** How it is solved; exact between two closed sections when left out, and modal between others. */
  readonly method?: Method;
  /** How many terms along u, v and w: at most 256, 256 and 64; 4, 4, 3 when left out. */
  readonly terms?: readonly [number, number, number];
  /** The weights of the three directions, above 0; 1 when left out. */
  readonly weights?: readonly [number, number, number];
}

/** A plane section with its tangents. */
export type Section = FormedSection | OutlineSection;

/** A section of one of the forms of ZY04. */
export interface FormedSection {
  /** What it is bounded by, and how u and v run over it. */
  readonly form: "rectangle" | "rectangle-reversed" | "disc" | "disc-in-square";
  /** Half its width and half its depth, above 0. */
  readonly radius: readonly [number, number];
  /** Its height. */
  readonly z: number;
  /** Its tangents in x and y, in parts of the position. */
  readonly taper: number;
  /** Its tangents in z. */
  readonly dz: number;
}

/** A section within a closed curve. */
export interface OutlineSection {
  /** A closed curve, which u draws together towards its mean. */
  readonly form: "outline";
  /** The Fourier series of x. */
  readonly x: readonly Harmonic[];
  /** The Fourier series of y. */
  readonly y: readonly Harmonic[];
  /** Its height. */
  readonly z: number;
  /** Its tangents in x and y, in parts of the position. */
  readonly taper: number;
  /** Its tangents in z. */
  readonly dz: number;
}

/** One harmonic of a closed curve. */
export interface Harmonic {
  /** How often it goes up and down round the curve: whole, 0 for the mean. */
  readonly n: number;
  /** How far as cos(2 pi n v); 0 when left out. */
  readonly cos?: number;
  /** How far as sin(2 pi n v); 0 when left out. */
  readonly sin?: number;
}

/** How the equation of a blend is solved. */
export type Method = "exact" | "modal" | "collocation";

/** The octant x^a + y^b + z^c <= 1 of a supersphere. */
export interface Octant {
  /** The octant x^a + y^b + z^c <= 1 of a supersphere, where no coordinate is negative. */
  readonly kind: "octant";
  /** a, b and c. 0.05 to 50. */
  readonly exponents: readonly [number, number, number];
}

/** Scaled, then turned, then moved. */
export interface Placement {
  /** Factors along x, y and z, before turning. Not 0. */
  readonly scale?: readonly [number, number, number];
  /** The direction of the axis of rotation. */
  readonly axis?: readonly [number, number, number];
  /** The angle in radians, anti-clockwise seen from where the axis points to. */
  readonly angle?: number;
  /** The movement along x, y and z, after turning. */
  readonly shift?: readonly [number, number, number];
}

/** A lining of its own: a surface like the outside with fewer waves round it, so far inside that the wall is nowhere thinner than its thickness. */
export interface Lining {
  /** The most waves round it that the inside keeps of those of the outside; 0, for a round one, when left out. A whole number from 0 to 128. */
  readonly waves?: number;
}

/** The clay between the surface and the lining, in model units after placement. */
export interface Wall {
  /** The thickness of the wall along the normal. Greater than 0. */
  readonly thickness: number;
  /** The thickness of the base; 0 for a pot without one. Not less than 0. */
  readonly base: number;
  /** Which way the clay goes from the surface; inside when left out. */
  readonly side?: Side;
  /** How the wall ends at an opening; flat when left out. */
  readonly rim?: RimForm;
  /** Width and height of a ring under the base; none when left out. Greater than 0. */
  readonly foot?: readonly [number, number];
  /** The diameter of a round hole through the base; 0 when left out. Not less than 0. */
  readonly drain?: number;
  /** An inside that does not follow the outside; where it is left out, it does. */
  readonly lining?: Lining;
}

/** Where the clay of a wall goes: inwards, or outwards. */
export type Side = "inside" | "outside";

/** How a wall ends at an opening: cut square, or half a circle. */
export type RimForm = "flat" | "rounded";

/** What a part is made of and covered with. */
export interface Look {
  /** What covers the part; celadon when left out. */
  readonly glaze?: GlazeName | Colour;
  /** What covers it inside; as outside when left out. */
  readonly inside?: GlazeName | Colour;
  /** Where the glaze of the outside ends, as a share of its height: below it the clay is bare. 0 to 1; 0 when left out. */
  readonly line?: number;
  /** What the part is made of; stoneware when left out. */
  readonly clay?: ClayName | Colour;
}

/** A glaze. */
export type GlazeName = "celadon" | "tenmoku" | "cobalt" | "tin-white" | "shino" | "copper-red" | "clear" | "bare";

/** A clay body. */
export type ClayName = "stoneware" | "porcelain" | "terracotta" | "black";

/** By which numbers of its placement a part can be moved. */
export interface Joints {
  /** Of the shift along x. */
  readonly x?: Joint;
  /** Of the shift along y. */
  readonly y?: Joint;
  /** Of the shift along z. */
  readonly z?: Joint;
  /** Of the turn about an axis of the scene through where the origin of the shape stands. */
  readonly turn?: Joint;
}

/** How far one number of a placement goes. */
export interface Joint {
  /** What it is called: at most 200 characters of plain text. */
  readonly label?: string;
  /** From where to where it goes: coordinates of the shift, or radians, of which no more than a whole turn either way. The placement may have a number outside them. */
  readonly limits: readonly [number, number];
  /** The axis that a turn is about, in the coordinates of the scene; upright when left out. Only a turn has one. */
  readonly axis?: readonly [number, number, number];
  /** Whether all that is glued to the part goes along; false when left out. */
  readonly glued?: boolean;
}

/** A scene as a tree of its unions. */
export interface Tree {
  /** The version of the format. */
  readonly pasu: 1;
  /** At most 200 characters of plain text. */
  readonly title?: string;
  /** What 1 means; centimetres when left out. */
  readonly unit?: Unit;
  /** 1 to 500 leaves; unions nest at most 24 deep. */
  readonly tree: TreeNode;
}

/** A solid or a union of solids. */
export type TreeNode = TreeLeaf | ConnectedUnion | UnconnectedUnion;

/** A solid: a part without its place. */
export interface TreeLeaf {
  /** A name that no other leaf has. */
  readonly name?: string;
  /** Its surface, before placement. */
  readonly shape: Shape;
  /** Factors along x, y and z, before turning. Not 0. Only leaves scale. */
  readonly scale?: readonly [number, number, number];
  /** The wall that makes its surface a pot. */
  readonly wall?: Wall;
  /** Its clay and glaze. */
  readonly look?: Look;
  /** By which numbers of its placement it can be moved, in the coordinates of the scene. */
  readonly joints?: Joints;
  /** Where it stands, seen from the first member of the union that it is in; of the root, where the whole stands. */
  readonly place?: Motion;
}

/** Leaves and connected unions, glued into one object. */
export interface ConnectedUnion {
  /** 2 or more, of which the first is not moved. */
  readonly connected: readonly (TreeLeaf | ConnectedUnion)[];
  /** Where it stands, seen from the first member of the union that it is in; of the root, where the whole stands. */
  readonly place?: Motion;
}

/** Objects, apart from each other. */
export interface UnconnectedUnion {
  /** 2 or more, of which the first is not moved. */
  readonly unconnected: readonly TreeNode[];
  /** Where it stands, seen from the first member of the union that it is in; of the root, where the whole stands. */
  readonly place?: Motion;
}

/** Turned, then moved. */
export interface Motion {
  /** The direction of the axis of rotation. */
  readonly axis?: readonly [number, number, number];
  /** The angle in radians, anti-clockwise seen from where the axis points to. */
  readonly angle?: number;
  /** The movement along x, y and z, after turning. */
  readonly shift?: readonly [number, number, number];
}

/** A colour of one's own, `#rrggbb`: of sRGB. */
export type Colour = `#${string}`;

/** An order of the equation for which Zhang and You (2001) have a vase. */
export type VaseOrder = "second-order" | "mixed-order" | "fourth-order";

/** A shape in another order. */
export interface Conversion {
  /** It has the same rim, foot and height. */
  readonly shape: Shape;
  /** What it had to leave behind. */
  readonly lost: readonly Loss[];
}

/** What a vase has to leave behind in another order. */
export type Loss = "dints" | "skew" | "petals" | "push" | "turns" | "rise" | "slopes";

/** What of a shape a hand can drag: the rim and the foot of its profile at `v = 0`, and the slopes of the wall there. All before placement. What is prescribed is linear in the numbers of every kind, so that one answer is good for a whole drag: moving one handle leaves its own steps as they are, and the data of all others. */
export interface Handles {
  /** Which end of `u` is the rim, that is the higher one. */
  readonly rim: End;
  /** All four, from the rim to the foot; none of a shape that has no profile. */
  readonly list: readonly Handle[];
}

/** An end of the profile: u = 0, or u = 1. */
export type End = "start" | "end";

/** One handle. */
export interface Handle {
  /** Which. */
  readonly id: HandleId;
  /** What moves it away from the axis by 1, a slope `X_u` as a point; empty where it cannot be moved so. */
  readonly radial: readonly Step[];
  /** What moves it upwards by 1; empty where it cannot be moved so. */
  readonly axial: readonly Step[];
  /** Why it cannot be moved one way or at all. */
  readonly restraints: readonly Restraint[];
}

/** A point of the profile that can be dragged. */
export type HandleId = "rim" | "rim-slope" | "foot-slope" | "foot";

/** Why a handle does not move, or moves one way only. */
export type Restraint =
  | "foot-height"
  | "second-order-slope"
  | "mixed-order-lean"
  | "mixed-order-foot"
  | "no-swell"
  | "level-foot"
  | "no-radius"
  | "lean-order"
  | "rise-order"
  | "free-end";

/** A number of the document that moves with a handle. */
export interface Step {
  /** Where it stands within the shape, such as `r[0]` or `x.modes[2].cos.start`. What is left out counts as its default; a mode behind the last is a new one. */
  readonly path: string;
  /** By how much it changes for 1; 0 of a number that has to be written and does not change. */
  readonly by: number;
}
