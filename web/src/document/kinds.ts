/** What each kind of shape is called, and what its documents may leave out. */

import type { Kind, SecondOrder, Shape } from "./types";

export const KIND_NAMES: Readonly<Record<Kind, string>> = {
  "second-order": "Second order",
  "mixed-order": "Mixed order",
  "fourth-order": "Fourth order",
  "bloor-wilson": "Bloor–Wilson",
  "boundary-value": "Free boundary data",
};

/** The fields that a document of second or mixed order may leave out, with what then holds. */
const PLANAR: Omit<SecondOrder, "kind" | "r"> = {
  n: [1, 8],
  height: 3.6,
  s: [1, 1],
  t: [0.5, 0.5],
  force: [0, 0],
};

/** The shape with everything written out that its document may leave out. */
export function filled<S extends Shape>(shape: S): S {
  return shape.kind === "second-order" || shape.kind === "mixed-order" ? { ...PLANAR, ...shape } : shape;
}
