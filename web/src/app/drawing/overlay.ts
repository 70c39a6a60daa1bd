/** The rings that were found for a sheet, where they are on it. */

import type { Spot } from "../../document/drawn/knot";
import { type Sheet, scaleOf } from "../../document/drawn/sheet";
import type { Drawn, Place } from "../../work/drawn";
import type { Overlay } from "./drawing-board";

export function overlayOf({ right, left, rings }: Drawn, sheet: Sheet): Overlay | null {
  const scale = scaleOf(sheet);
  if (!scale) return null;
  const spot = ([across, up]: Place): Spot => ({
    x: sheet.axis + across / scale.unit,
    y: scale.foot - up / scale.unit,
  });
  return { lines: [right.map(spot), left.map(spot)], rings: rings.map(([a, b]) => [spot(a), spot(b)]) };
}
