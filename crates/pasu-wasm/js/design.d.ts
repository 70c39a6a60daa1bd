// The design document, format version 1. Lengths are in the unit of the design, angles in radians. A field that may be
// left out has the default that its comment names; parse() leaves it out when it has that value.

/** A design: one pot or several, as a person has chosen them. */
export interface Design {
  /** The version of the format. */
  pasu: 1;
  /** Plain text, at most 200 characters. */
  title?: string;
  /** What 1 means; "cm". */
  unit?: "mm" | "cm" | "in";
  /** 1 to 500 parts. */
  parts: Part[];
}

/** One surface of a design. */
export interface Part {
  /** A name that no other part has. */
  name?: string;
  /** The discrete object that the part is glued into; 0. */
  object?: number;
  shape: Shape;
  place?: Placement;
  wall?: Wall;
  look?: Look;
}

/** A surface, by `kind`: four families, and the problem that all of them are shorthand for. */
export type Shape = SecondOrder | MixedOrder | FourthOrder | BloorWilson | BoundaryValue;

/** The petalled vase of the second order equation (ZY01 eqs 1 to 8). `u = 0` is the rim. */
export interface SecondOrder {
  kind: "second-order";
  /** Rim radius and petals, foot radius and petals. */
  r: [number, number, number, number];
  /** Harmonics round the pot: of the body and of the petals; [1, 8]. */
  n?: [number, number];
  /** 3.6. */
  height?: number;
  /** Shape control parameters of the second derivative along the profile, for x and for y; [1, 1]. */
  s?: [number, number];
  /** Shape control parameters of the second derivative round the pot, for x and for y; [0.5, 0.5]. */
  t?: [number, number];
  /** The sculpting force and how it grows along the profile; [0, 0]. */
  force?: [number, number];
}

/** As {@link SecondOrder}, with a fourth order height (ZY01 eqs 9 to 12). */
export interface MixedOrder extends Omit<SecondOrder, "kind"> {
  kind: "mixed-order";
  /** The slope of the height at the rim. */
  rise: number;
}

/** The round vase with a waist or a belly (ZY01 eqs 13 to 17). `u = 0` is the foot. */
export interface FourthOrder {
  kind: "fourth-order";
  /** The radius of the foot. */
  r0: number;
  /** The radius of the rim. */
  r1: number;
  /** The radius at mid-height towards which the wall is bent. */
  rm: number;
  /** The height of the rim above the foot. */
  h1: number;
  /** How strongly the wall leaves the foot and meets the rim. */
  eta: [number, number];
  /** The slope of the height at the foot and at the rim. */
  dz: [number, number];
  /** Shape control parameters of the fourth derivative along the profile, for x and for y; never 0. */
  s: [number, number];
  /** Shape control parameters of the mixed derivative, for x and for y. */
  t: [number, number];
  /** Shape control parameters of the fourth derivative round the pot, for x and for y. */
  w: [number, number];
}

/** The dint vase (IA eqs 15 to 18). */
export interface BloorWilson {
  kind: "bloor-wilson";
  /** The smoothing parameter. */
  a: number;
  /** Radii: of rim and foot, and of their dents. */
  r: [number, number, number, number];
  /** The slopes that belong to `r`. */
  R: [number, number, number, number];
  /** Heights of the rim and the foot. */
  h: [number, number];
  /** The slopes that belong to `h`. */
  H: [number, number];
  /** How many dents. */
  n1: number;
}

/** A boundary-value problem: for each coordinate an equation and Fourier data at both ends. */
export interface BoundaryValue {
  kind: "boundary-value";
  /** The length of `v` once round; "2pi" is exact. */
  span: number | "2pi";
  x: Component;
  y: Component;
  z: Component;
}

/** `s q'' - t k^2 q = f` or `s q'''' - t k^2 q'' + w k^4 q = f` for every mode. */
export type Component =
  | { order: 2; s: number; t: number; modes: Mode<SecondOrderDatum>[] }
  | { order: 4; s: number; t: number; w: number; modes: Mode<FourthOrderDatum>[] };

/** The data of one harmonic, `k = 2 pi n / span`. */
export interface Mode<Datum> {
  n: number;
  cos?: Datum;
  sin?: Datum;
}

/** Values at both ends, and the force in ascending powers of `u`. What is left out is 0. */
export interface SecondOrderDatum {
  start?: number;
  end?: number;
  force?: number[];
}

/** Values and slopes at both ends, and the force in ascending powers of `u`. What is left out is 0. */
export interface FourthOrderDatum extends SecondOrderDatum {
  start_u?: number;
  end_u?: number;
}

/** Scale, then rotation about an axis through the origin, then shift; in its unique form after parse(). */
export interface Placement {
  /** Never 0; [1, 1, 1]. */
  scale?: [number, number, number];
  /** [0, 0, 1]. */
  axis?: [number, number, number];
  /** Anti-clockwise seen from the tip of the axis; 0. */
  angle?: number;
  /** [0, 0, 0]. */
  shift?: [number, number, number];
}

/** Makes an open surface a pot. */
export interface Wall {
  /** More than 0. */
  thickness: number;
  /** The thickness of the bottom; 0 for none. */
  base: number;
}

/** What the pot looks like. */
export interface Look {
  /** "celadon". */
  glaze?: "celadon" | "tenmoku" | "cobalt" | "tin-white" | "shino" | "copper-red" | "clear" | "bare";
  /** "stoneware". */
  clay?: "stoneware" | "porcelain" | "terracotta" | "black";
}
