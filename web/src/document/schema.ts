/** What a person may change in each family: the numbers of the generated tables, grouped as a potter thinks. */

import { FAMILIES, GROUPS } from "./families.gen";
import type { FamilyKind, Field, Group } from "./field";
import { filled, isFamily } from "./kinds";
import { numberAt, setPath } from "./path";
import { PETALS_SYMBOL, petalsAt, withPetals } from "./petals";
import type { Kind, Shape } from "./types";

export type { FamilyKind, Field, Group } from "./field";
export { GROUPS };

export interface Family {
  readonly kind: FamilyKind;
  readonly fields: readonly Field[];
  /** The complete shape that an empty readable link stands for: the pot of the paper. */
  readonly reset: Shape;
}

function family(kind: FamilyKind): Family {
  const { fields, reset }: { readonly fields: readonly Field[]; readonly reset: Shape } = FAMILIES[kind];
  const symbol = (field: Field) => (petalsAt(reset, field.path) === null ? field.symbol : PETALS_SYMBOL);
  return { kind, fields: fields.map((field) => ({ ...field, symbol: symbol(field) })), reset };
}

const BY_KIND: Readonly<Record<FamilyKind, Family>> = {
  "second-order": family("second-order"),
  "mixed-order": family("mixed-order"),
  "fourth-order": family("fourth-order"),
  "bloor-wilson": family("bloor-wilson"),
};

/** The family of a kind; a boundary-value shape has a table of modes instead, a pot of rings a list of these. */
export function familyOf(kind: Kind): Family | null {
  return isFamily(kind) ? BY_KIND[kind] : null;
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
      rows.push({ id: field.pair ?? field.key, fields: [field] });
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
    if (field.dimension === "length" && field.min >= 0) {
      most = Math.max(most, Math.abs(fieldValue(shape, field)) / field.max);
    }
  }
  if (!Number.isFinite(most) || most === 0) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const nice = NICE.find((step) => step * power >= most) ?? 10;
  const factor = Number((nice * power).toPrecision(1));
  return factor >= 0.2 && factor <= 1 ? 1 : factor;
}
