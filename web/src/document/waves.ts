/** How finely a design has to be sampled to look round: its highest frequency. */

import { filled } from "./kinds";
import { numberAt } from "./path";
import { SHAPES } from "./tables.gen";
import type { Design, Series, Shape } from "./types";

/** Vertices along the profile and round the pot. */
export interface GridSize {
  readonly rows: number;
  readonly columns: number;
}

/** The highest frequency of all parts, at least 1. */
export function wavesOf(design: Design): number {
  return Math.max(1, ...design.parts.map((part) => highestFrequency(part.shape)));
}

/** The highest frequency of a shape. */
export function highestFrequency(shape: Shape): number {
  if (shape.kind === "boundary-value") {
    return Math.max(0, ...[shape.x, shape.y, shape.z].flatMap(({ modes }) => modes.map((mode) => Math.abs(mode.n))));
  }
  if (shape.kind === "rings") {
    const { rings, foot, rim } = shape;
    const curves = [...rings, ...(foot ? [foot] : []), ...(rim ? [rim] : [])];
    const highest = ({ waves = [] }: Series) => Math.max(0, ...waves.map(({ n }) => n));
    // What a radius does as it goes round is one wave more in x and in y.
    return Math.max(1, ...curves.flatMap(({ r, z }) => [1 + highest(r), highest(z)]));
  }
  if (shape.kind === "vertex-frame" || shape.kind === "octant") return 0;
  if (shape.kind === "blend") {
    const waves = [shape.start, shape.end].flatMap((section) =>
      section.form === "outline" ? [...section.x, ...section.y] : [],
    );
    return Math.max(1, ...waves.map(({ n }) => n));
  }
  const whole = filled(shape);
  return Math.max(0, ...SHAPES[shape.kind].waves.map((path) => Math.abs(numberAt(whole, path, 0))));
}
