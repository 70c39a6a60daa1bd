/** What a ring is called: foot and rim where a pot says which end is which. */

import { takesRings } from "../../document/brush";
import type { Curve } from "../../document/curves";
import type { End, Shape } from "../../document/types";
import { pull as words } from "../../words/english/pull";

/** `rim` is which end is the rim of a family of numbers, as far as that is known. */
export function curveName(shape: Shape, { index, end, u }: Curve, rim: End | null = null): string {
  if (!takesRings(shape)) {
    if (!end) return words.middle;
    if (rim) return (u === 0) === (rim === "start") ? words.rim : words.foot;
    return words.end(u === 0 ? 1 : 2);
  }
  if (!end) return words.ring(index);
  if (shape.kind === "rings") return u === 0 ? words.foot : words.rim;
  return words.end(u === 0 ? 1 : 2);
}
