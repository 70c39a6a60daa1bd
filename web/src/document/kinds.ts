/** What the documents of each kind of shape may leave out. */

import { SHAPES } from "./tables.gen";
import type { Shape } from "./types";

/** The shape with everything written out that its document may leave out. */
export function filled<S extends Shape>(shape: S): S {
  return shape.kind === "boundary-value" ? shape : { ...SHAPES[shape.kind].defaults, ...shape };
}
