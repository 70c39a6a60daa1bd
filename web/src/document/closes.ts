/** Shapes that go round a body, which is a solid without a wall. */

import { isClosed } from "./network/network";
import type { Blend, Shape } from "./types";

/** Whether there is no edge for a wall to end at. */
export function closes(shape: Shape): boolean {
  return shape.kind === "octant" || (shape.kind === "vertex-frame" && isClosed(shape));
}

/** Whether it is a solid while it has no wall. */
export function isSolid(shape: Shape): boolean {
  return shape.kind === "blend" || closes(shape);
}

/** Whether a blend flows between two closed sections. */
export function isRound({ start, end }: Pick<Blend, "start" | "end">): boolean {
  return [start, end].every(({ form }) => form === "disc" || form === "outline");
}
