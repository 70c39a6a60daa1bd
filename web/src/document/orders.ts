/** The orders of the equation that a vase can be switched to. */

import { isFamily } from "./kinds";
import type { Kind, OrderKind } from "./types";

export const ORDER_KINDS: readonly OrderKind[] = ["second-order", "mixed-order", "fourth-order"];

/** Whether a shape can be switched as a whole. */
export function convertible(kind: Kind): boolean {
  return isFamily(kind);
}
