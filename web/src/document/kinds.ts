/** What the documents of each kind of shape may leave out. */

import type { FamilyKind } from "./field";
import { SHAPES } from "./tables.gen";
import type { Kind, Shape } from "./types";

/** Whether a shape of this kind is so many numbers; the others are lists of modes or rings. */
export function isFamily(kind: Kind): kind is FamilyKind {
  return kind in SHAPES;
}

/** The shape with everything written out that its document may leave out. */
export function filled<S extends Shape>(shape: S): S {
  return isFamily(shape.kind) ? { ...SHAPES[shape.kind].defaults, ...shape } : shape;
}
