/** How finely a design has to be sampled to look round: its highest frequency. */

import { filled } from "./kinds";
import type { Design, Shape } from "./types";

/** Vertices along the profile and round the pot. */
export interface GridSize {
  readonly rows: number;
  readonly columns: number;
}

/** The highest frequency of all parts, at least 1. */
export function wavesOf(design: Design): number {
  return Math.max(1, ...design.parts.map((part) => highestFrequency(part.shape)));
}

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
