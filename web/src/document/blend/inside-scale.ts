/** The colours of what is seen within a blend, and what they stand for. */

import { DIVERGING, type Scale, scaleOf } from "../maps";
import type { InsideMap } from "./looking";

/** Residuals begin at 0, where the equation holds; of a Jacobian that changes its sign, 0 is in the middle. */
export function scaleOfInside(
  map: InsideMap,
  { low, high, holds }: { readonly low: number; readonly high: number; readonly holds: boolean },
): Scale {
  const from = map === "residual" ? 0 : low;
  // Where it holds everywhere all is of the colour of 0.
  return scaleOf({ ramp: DIVERGING, diverging: true }, from, holds ? 1 : high);
}
