/** Making a pot: what can be asked for, and what comes back. `docs/measures.md` says what each measure means. */

import type { Triple } from "./types";

export type Product = "pot" | "solid";

export type Size = { readonly height: number } | { readonly width: number } | { readonly capacity: number };

/** How a design becomes a thing. */
export interface Making {
  readonly product?: Product;
  /** The size of the finished pot in the unit of the design (its cube for a capacity); as designed without. */
  readonly size?: Size;
  /** How much the clay shrinks, in percent. */
  readonly shrinkage?: number;
  /** How far a file may be from the surface, in the unit of the design. */
  readonly tolerance?: number;
}

export type MapName = "mean-curvature" | "gaussian-curvature" | "thickness" | "overhang";

/** A number and how far it may be off. */
export interface Quantity {
  readonly value: number;
  readonly error: number;
}

/** A number and where it is reached. */
export interface Extreme {
  readonly value: number;
  readonly at: Triple;
}

export interface Capacity {
  readonly brim: Quantity;
  readonly spill: { readonly level: Quantity; readonly at: Triple };
  readonly floor: number;
  readonly fill: { readonly level: number; readonly volume: Quantity } | null;
  /** Whether a drain hole is taken as stopped. */
  readonly stopped: boolean;
}

export interface Clay {
  readonly area: Quantity;
  readonly volume: Quantity;
  /** In grams. */
  readonly mass: Quantity;
}

export interface Tipping {
  readonly degrees: number;
  readonly toward: number;
}

export interface Centre {
  readonly at: Triple;
  readonly error: number;
}

export interface Footprint {
  readonly level: number;
  readonly area: number;
  readonly hullArea: number;
  readonly hull: readonly (readonly [number, number])[];
}

/** What is known of the whole design and of each of its parts. */
export interface Sums {
  readonly height: Quantity;
  readonly bottom: number;
  readonly top: number;
  readonly width: {
    readonly least: Quantity;
    readonly greatest: Quantity;
    readonly leastDirection: number;
    readonly greatestDirection: number;
  };
  readonly area: Quantity;
  readonly clay: Clay | null;
  readonly capacity: Capacity | null;
  readonly centre: { readonly empty: Centre | null; readonly full: Centre | null };
  readonly footprint: Footprint | null;
  readonly tipping: { readonly empty: Tipping | null; readonly full: Tipping | null };
}

export interface Curvature {
  readonly least: Extreme | null;
  readonly greatest: Extreme | null;
}

export interface PartMeasures extends Sums {
  readonly part: number;
  readonly name: string | null;
  readonly isPot: boolean;
  /** Why it is no pot, in words. */
  readonly reason: string | null;
  readonly thickness: { readonly asked: number; readonly least: Extreme; readonly greatest: Extreme } | null;
  readonly overhang: { readonly degrees: number; readonly at: Triple; readonly face: string } | null;
  readonly overhangInside: { readonly degrees: number; readonly at: Triple; readonly face: string } | number | null;
  readonly curvature: { readonly mean: Curvature; readonly gaussian: Curvature };
}

export interface Measures extends Sums {
  readonly parts: readonly PartMeasures[];
}

export interface Finding {
  readonly code: string;
  readonly severity: "error" | "warning" | "note";
  readonly part: number | null;
  readonly message: string;
  readonly at?: Triple | null;
}

/** What the checks found of the very triangles that a file holds. */
export interface Report {
  readonly ok: boolean;
  readonly findings: readonly Finding[];
  readonly triangles: number;
  readonly meshes: readonly { readonly part: number; readonly triangles: number; readonly bound: number }[];
}
