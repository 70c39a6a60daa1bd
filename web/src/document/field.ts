/** One number of a shape, as the generated tables have it. */

import type { FAMILIES, GROUPS } from "./families.gen";
import type { Path } from "./path";

/** What of a pot a number is about. */
export type Group = (typeof GROUPS)[number];

export type FamilyKind = keyof typeof FAMILIES;

/** What the fields of a family are told apart by. */
export type FieldKey<K extends FamilyKind> = (typeof FAMILIES)[K]["fields"][number]["key"];

/** Two with the same `pair` are the `x` and `y` of one vector-valued parameter. */
export interface Field {
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
