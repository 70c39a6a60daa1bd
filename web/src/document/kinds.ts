/** What each kind of shape is called, and what its documents may leave out. */

import { SHAPES } from "./tables.gen";
import type { Kind, Shape } from "./types";

export const KIND_NAMES: Readonly<Record<Kind, string>> = {
  "second-order": "Second order",
  "mixed-order": "Mixed order",
  "fourth-order": "Fourth order",
  "bloor-wilson": "Bloor–Wilson",
  "boundary-value": "Free boundary data",
};

/** The shape with everything written out that its document may leave out. */
export function filled<S extends Shape>(shape: S): S {
  return shape.kind === "boundary-value" ? shape : { ...SHAPES[shape.kind].defaults, ...shape };
}
