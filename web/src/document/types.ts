/** The design document as the format defines it: plain frozen data, one `kind` per shape. */

export type Unit = "mm" | "cm" | "in";
export type GlazeName = "celadon" | "tenmoku" | "cobalt" | "tin-white" | "shino" | "copper-red" | "clear" | "bare";
export type ClayName = "stoneware" | "porcelain" | "terracotta" | "black";

export type Pair = readonly [number, number];
export type Triple = readonly [number, number, number];
export type Quad = readonly [number, number, number, number];

/** ZY01 equations 1 to 8: positions at rim and foot. */
export interface SecondOrder {
  readonly kind: "second-order";
  readonly r: Quad;
  readonly n?: Pair;
  readonly height?: number;
  readonly s?: Pair;
  readonly t?: Pair;
  readonly force?: Pair;
}

/** ZY01 equations 9 to 12: as second order, with the rise of the wall at the rim. */
export interface MixedOrder extends Omit<SecondOrder, "kind"> {
  readonly kind: "mixed-order";
  readonly rise: number;
}

/** ZY01 equations 13 to 17: positions and slopes at both ends; the foot is at `u = 0`. */
export interface FourthOrder {
  readonly kind: "fourth-order";
  readonly r0: number;
  readonly r1: number;
  readonly rm: number;
  readonly h1: number;
  readonly eta: Pair;
  readonly dz: Pair;
  readonly s: Pair;
  readonly t: Pair;
  readonly w: Pair;
}

/** IA equations 15 to 18: the dint vase. */
export interface BloorWilson {
  readonly kind: "bloor-wilson";
  readonly a: number;
  readonly r: Quad;
  readonly R: Quad;
  readonly h: Pair;
  readonly H: Pair;
  readonly n1: number;
}

/** Boundary values and force of one harmonic; what is left out is 0. */
export interface Datum {
  readonly start?: number;
  readonly end?: number;
  readonly start_u?: number;
  readonly end_u?: number;
  readonly force?: readonly number[];
}

export interface Mode {
  readonly n: number;
  readonly cos?: Datum;
  readonly sin?: Datum;
}

export interface Component {
  readonly order: 2 | 4;
  readonly s: number;
  readonly t: number;
  readonly w?: number;
  readonly modes: readonly Mode[];
}

/** Fourier boundary data written out, component by component. */
export interface BoundaryValue {
  readonly kind: "boundary-value";
  readonly span: number | "2pi";
  readonly x: Component;
  readonly y: Component;
  readonly z: Component;
}

export type Shape = SecondOrder | MixedOrder | FourthOrder | BloorWilson | BoundaryValue;
export type Kind = Shape["kind"];

export interface Placement {
  readonly scale?: Triple;
  readonly axis?: Triple;
  readonly angle?: number;
  readonly shift?: Triple;
}

export interface Look {
  readonly glaze?: GlazeName;
  readonly clay?: ClayName;
}

export interface Part {
  readonly name?: string;
  readonly object?: number;
  readonly shape: Shape;
  readonly place?: Placement;
  readonly wall?: { readonly thickness: number; readonly base: number };
  readonly look?: Look;
}

export interface Design {
  readonly pasu: 1;
  readonly title?: string;
  readonly unit?: Unit;
  readonly parts: readonly Part[];
}

/** What the solver says when it refuses a design: a stable word, where in the design, and a sentence. */
export interface Refusal {
  readonly code: string;
  readonly path: string;
  readonly message: string;
}
