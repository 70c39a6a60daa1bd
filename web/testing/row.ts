// Many pots in a row, for tests of what a change of one of them costs.

import type { Design, Part, Placement, Shape } from "../src/document/types";

const shape = (height: number): Shape => ({ kind: "second-order", r: [1, 0.1, 0.6, 0.06], height });

/** So many parts beside each other, each with a shape of its own. */
export function rowOf(count: number): Design {
  const parts = Array.from(
    { length: count },
    (_, index): Part => ({
      shape: shape(2 + index / 100),
      place: { shift: [3 * index, 0, 0] },
    }),
  );
  return { pasu: 1, parts };
}

/** The row with another part in the place of one. */
export function withPart(design: Design, place: number, change: (part: Part) => Part): Design {
  return { ...design, parts: design.parts.map((part, index) => (index === place ? change(part) : part)) };
}

export const taller =
  (height: number) =>
  (part: Part): Part => ({ ...part, shape: shape(height) });

export const moved =
  (place: Placement) =>
  (part: Part): Part => ({ ...part, place });
