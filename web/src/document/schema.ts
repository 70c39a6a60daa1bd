/** What a person may change in each family: symbol, plain name, range, step and help, grouped as a potter thinks. */

import { BLOOR_WILSON } from "./families/bloor-wilson";
import { FOURTH_ORDER } from "./families/fourth-order";
import { MIXED_ORDER } from "./families/mixed-order";
import { SECOND_ORDER } from "./families/second-order";
import { filled } from "./kinds";
import type { Path } from "./path";
import { numberAt, setPath } from "./path";
import { petalsAt, withPetals } from "./petals";
import type { Kind, Shape } from "./types";

export type Group = "Rim" | "Foot" | "Wall" | "Height" | "Equation" | "Force";
export const GROUPS: readonly Group[] = ["Rim", "Foot", "Height", "Wall", "Equation", "Force"];

export const GROUP_HELP: Readonly<Record<Group, string>> = {
  Rim: "The upper edge",
  Foot: "The lower edge",
  Wall: "What the clay does in between",
  Height: "From the foot to the rim",
  Equation: "The weights of its terms",
  Force: "A push along the whole wall",
};

/** One number of a shape. Two fields with the same `pair` are the `x` and `y` of one vector-valued parameter. */
export interface Field {
  /** Where the number is, inside the shape. */
  readonly path: Path;
  /** The papers' symbol; `_` lowers what follows, `'` is a prime. */
  readonly symbol: string;
  readonly name: string;
  readonly group: Group;
  /** Whether the number is a length in the design's unit. */
  readonly length: boolean;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly help: string;
  readonly pair?: string;
}

export interface Family {
  readonly kind: Exclude<Kind, "boundary-value">;
  readonly name: string;
  readonly source: string;
  readonly fields: readonly Field[];
  /** The complete shape that an empty readable link stands for: the pot of the paper. */
  readonly reset: Shape;
}

const FAMILIES: Readonly<Record<Family["kind"], Family>> = {
  "second-order": SECOND_ORDER,
  "mixed-order": MIXED_ORDER,
  "fourth-order": FOURTH_ORDER,
  "bloor-wilson": BLOOR_WILSON,
};

/** The family of a kind; a boundary-value shape has a table of modes instead. */
export function familyOf(kind: Kind): Family | null {
  return kind === "boundary-value" ? null : FAMILIES[kind];
}

export function fieldValue(shape: Shape, field: Field): number {
  return petalsAt(shape, field.path) ?? numberAt(filled(shape), field.path, Number.NaN);
}

/** The shape with one number changed; the same shape when it had that value already. */
export function withField<S extends Shape>(shape: S, field: Field, value: number): S {
  if (Object.is(fieldValue(shape, field), value)) return shape;
  return withPetals(shape, field.path, value) ?? setPath(filled(shape), field.path, value);
}

/** A row of the panel: one number, or the `x` and `y` of a vector-valued parameter. */
export interface Row {
  readonly id: string;
  readonly fields: readonly [Field] | readonly [Field, Field];
}

/** The rows of a group, vector-valued parameters joined. */
export function rowsOf(family: Family, group: Group): readonly Row[] {
  const rows: Row[] = [];
  for (const field of family.fields) {
    if (field.group !== group) continue;
    const before = rows.at(-1);
    const first = before?.fields[0];
    if (before && first && field.pair !== undefined && first.pair === field.pair) {
      rows[rows.length - 1] = { id: before.id, fields: [first, field] };
    } else {
      rows.push({ id: field.pair ?? field.path.join("-"), fields: [field] });
    }
  }
  return rows;
}

const NICE = [1, 2, 5];

/**
 * How much longer than the papers' pots this one is, as 1, 2 or 5 times a power of ten: the sliders of lengths are made
 * for that size, so that a vase of 20 cm is as easy to shape as one of 3.6.
 */
export function sizeFactor(family: Family, shape: Shape): number {
  let most = 0;
  for (const field of family.fields) {
    if (field.length && field.min >= 0) {
      most = Math.max(most, Math.abs(fieldValue(shape, field)) / field.max);
    }
  }
  if (!Number.isFinite(most) || most === 0) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const nice = NICE.find((step) => step * power >= most) ?? 10;
  const factor = Number((nice * power).toPrecision(1));
  return factor >= 0.2 && factor <= 1 ? 1 : factor;
}
