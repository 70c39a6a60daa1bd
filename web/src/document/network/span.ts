/** How far `v` goes round a two-sided surface. */

import { isFamily } from "../kinds";
import { SHAPES } from "../tables.gen";
import type { Shape } from "../types";

export function spanOf(shape: Shape): number {
  const span = isFamily(shape.kind) ? SHAPES[shape.kind].span : shape.kind === "boundary-value" ? shape.span : "2pi";
  return span === "2pi" ? 2 * Math.PI : span;
}
