/** One number of a shape: what the generated tables have of it, and what it is called. */

import type { FAMILIES, GROUPS } from "./families.gen";
import type { Path } from "./path";

/** What of a pot a number is about. */
export type Group = (typeof GROUPS)[number];

export type FamilyKind = keyof typeof FAMILIES;

/** What the fields of a family are told apart by. */
export type FieldKey<K extends FamilyKind> = (typeof FAMILIES)[K]["fields"][number]["key"];

/** What a field is called. */
export interface FieldWords {
  /** Where a person sees another number than that of the table, what it is in the papers' symbols. */
  readonly symbol?: string;
  readonly name: string;
  readonly help: string;
}

/** One number of a shape, as the tables have it. Two with the same `pair` are the `x` and `y` of one vector-valued parameter. */
export interface Entry {
  readonly key: string;
  /** Where the number is, inside the shape. */
  readonly path: Path;
  /** The papers' symbol; `_` lowers what follows, `'` is a prime. */
  readonly symbol: string;
  readonly group: Group;
  /** What it measures: a length in the design's unit, waves round the axis, or nothing. */
  readonly dimension: "length" | "waves" | "one";
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly pair?: string;
}

/** The same with what it is called. */
export interface Field extends Entry, Omit<FieldWords, "symbol"> {}
