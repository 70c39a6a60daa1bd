/** What a ring is called: foot and rim where a pot says which end is which. */

import type { Curve } from "../../document/curves";
import type { Shape } from "../../document/types";
import { pull as words } from "../../words/english/pull";

export function curveName(shape: Shape, { index, end, u }: Curve): string {
  if (!end) return words.ring(index);
  if (shape.kind === "rings") return u === 0 ? words.foot : words.rim;
  return words.end(u === 0 ? 1 : 2);
}
