/** How finely a design is sampled for the screen: coarse under the hand, fine at rest. */

import { filled } from "../document/kinds";
import type { Design, Shape } from "../document/types";

export interface GridSize {
  readonly rows: number;
  readonly columns: number;
}

const COARSE: GridSize = { rows: 96, columns: 161 };
const FINE: GridSize = { rows: 192, columns: 321 };
/** Columns that one wave needs to look round. */
const COLUMNS_PER_WAVE = 16;
const MAX_COLUMNS = 1025;
/** All parts together; a phone turns this many over without stutter. */
const MAX_VERTICES = 1_500_000;

export function gridFor(design: Design, inGesture: boolean): GridSize {
  const { rows, columns } = inGesture ? COARSE : FINE;
  const waves = Math.max(1, ...design.parts.map((part) => highestFrequency(part.shape)));
  const wanted = Math.min(MAX_COLUMNS, Math.max(columns, Math.ceil(COLUMNS_PER_WAVE * waves) + 1));
  const share = Math.min(1, Math.sqrt(MAX_VERTICES / (rows * wanted * design.parts.length)));
  return { rows: Math.max(16, Math.floor(rows * share)), columns: Math.max(33, Math.floor(wanted * share)) };
}

/** Thumbnails are small. */
export const THUMBNAIL_GRID: GridSize = { rows: 64, columns: 161 };

function highestFrequency(shape: Shape): number {
  switch (shape.kind) {
    case "second-order":
      return Math.max(...(filled(shape).n ?? [1]).map(Math.abs));
    case "mixed-order":
      return Math.max(...(filled(shape).n ?? [1]).map(Math.abs));
    case "fourth-order":
      return 1;
    case "bloor-wilson":
      return Math.abs(shape.n1);
    case "boundary-value":
      return Math.max(0, ...[shape.x, shape.y, shape.z].flatMap(({ modes }) => modes.map((mode) => Math.abs(mode.n))));
  }
}
