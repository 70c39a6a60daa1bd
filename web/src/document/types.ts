/**
 * The design document: the package's own types, generated from the Rust code, as the page holds them: frozen. Types are
 * all that is imported here; the solver itself is `solver/`'s alone.
 */

import type * as pasu from "pasu";

/** Read-only all the way down. */
export type Frozen<T> = T extends object ? { readonly [K in keyof T]: Frozen<T[K]> } : T;

export type SecondOrder = Frozen<pasu.SecondOrder>;
export type MixedOrder = Frozen<pasu.MixedOrder>;
export type FourthOrder = Frozen<pasu.FourthOrder>;
export type BloorWilson = Frozen<pasu.BloorWilson>;

export type Rings = Frozen<pasu.Rings>;
export type Series = Frozen<pasu.Series>;
export type Hoop = Frozen<pasu.Hoop>;
export type Wave = Frozen<pasu.Wave>;

/** The data of one harmonic while it is being edited: order 2 has no use for the slopes. */
export type Datum = Frozen<pasu.FourthOrderDatum>;
export type Mode = Frozen<pasu.Mode<pasu.FourthOrderDatum>>;

/** One coordinate while it is being edited: `w` belongs to order 4. The solver holds it to its order. */
export interface Component {
  readonly order: 2 | 4;
  readonly s: number;
  readonly t: number;
  readonly w?: number;
  readonly free?: "start" | "end" | "both";
  readonly modes: readonly Mode[];
}

export interface BoundaryValue extends Omit<Frozen<pasu.BoundaryValue>, "x" | "y" | "z"> {
  readonly x: Component;
  readonly y: Component;
  readonly z: Component;
}

/** A surface between two ends. */
export type TwoSided = SecondOrder | MixedOrder | FourthOrder | BloorWilson | BoundaryValue | Rings;
/** Patches through a network of points. */
export type VertexFrame = Frozen<pasu.VertexFrame>;
/** A solid between two sections. */
export type Blend = Frozen<pasu.Blend>;
export type Section = Frozen<pasu.Section>;
/** An octant of a supersphere. */
export type Octant = Frozen<pasu.Octant>;
export type Shape = TwoSided | VertexFrame | Blend | Octant;
export type Kind = Shape["kind"];

/** The outside of a scan, level by level. */
export type Levels = pasu.Levels;

/** What makes a surface a pot. */
export type Wall = Frozen<pasu.Wall>;

export type Placement = Frozen<pasu.Placement>;
/** By which numbers of its placement a part can be moved. */
export type Joints = Frozen<pasu.Joints>;
export type Joint = Frozen<pasu.Joint>;
export type Look = Frozen<pasu.Look>;
export type Colour = `#${string}`;
/** A name or a colour of one's own. */
export type GlazeChoice = NonNullable<pasu.Look["glaze"]>;
export type ClayChoice = NonNullable<pasu.Look["clay"]>;
export type GlazeName = Exclude<GlazeChoice, Colour>;
export type ClayName = Exclude<ClayChoice, Colour>;
export type Unit = NonNullable<pasu.Design["unit"]>;

export interface Part extends Omit<Frozen<pasu.Part>, "shape"> {
  readonly shape: Shape;
}

export interface Design extends Omit<Frozen<pasu.Design>, "parts"> {
  readonly parts: readonly Part[];
}

/** The same as the package takes it: a component has the data of its order. The package holds a design to that; while it is being edited, the page does not. */
export type Sent = pasu.Design;
export type SentShape = pasu.Shape;

/** An order that a vase can be switched to. */
export type OrderKind = pasu.VaseOrder;
export type Loss = pasu.Loss;
/** A vase in another order, and what it had to leave behind. */
export interface Conversion extends Omit<Frozen<pasu.Conversion>, "shape"> {
  readonly shape: Shape;
}

/** What of a shape a hand can drag. */
export type Handles = Frozen<pasu.Handles>;
export type Handle = Frozen<pasu.Handle>;
export type HandleId = pasu.HandleId;
export type Restraint = pasu.Restraint;
/** An end of the profile: `u = 0`, or `u = 1`. */
export type End = pasu.End;

export type Making = Frozen<pasu.Making>;
/** What a file that Pasu made says of itself. */
export type Provenance = Frozen<pasu.Provenance>;
export type Product = pasu.Product;
export type Format = pasu.Format;
export type MapName = pasu.MapName;
/** A number and how far it may be off. */
export type Quantity = Frozen<pasu.Quantity>;
/** What was measured; `docs/measures.md` says what each means. */
export type Difference = Frozen<pasu.Difference>;
export type Measures = Frozen<pasu.Measures>;
export type PartMeasures = Frozen<pasu.PartMeasures>;
/** Whether a scene keeps its constraints; `docs/scenes.md` says what they are. */
export type Constraints = Frozen<pasu.Constraints>;
/** Where a ray meets a part. */
export type Hit = Frozen<pasu.Hit>;
export type Breach = Frozen<pasu.Breach>;
/** Why there is something not. */
export type Cause = Frozen<pasu.Cause>;
export type Curvature = PartMeasures["curvature"]["mean"];
export type Capacity = Frozen<pasu.Capacity>;
/** What the checks found of the very triangles that a file holds. */
export type Report = Frozen<pasu.Report>;
export type Finding = Frozen<pasu.Finding>;

export type Pair = readonly [number, number];
export type Triple = readonly [number, number, number];

/** What the solver says when it refuses a design: a stable word, where in the design, what it names, and a sentence for where nobody has a better one. */
export interface Refusal {
  readonly code: string;
  readonly path: string;
  readonly message: string;
  readonly args?: Readonly<Record<string, number | string | readonly string[]>>;
}
