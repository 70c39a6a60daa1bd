/** Where water can stand in a pot. */

import type { Capacity, Measures } from "./types";

/** The heights between which it can; null where it cannot. */
export function waterRange({ capacity }: Measures): { readonly low: number; readonly high: number } | null {
  if (!capacity) return null;
  const [low, high] = [capacity.floor, levelOf(capacity)];
  return high > low ? { low, high } : null;
}

/** As high as water can stand, without a doubt: its error is taken off. */
function levelOf({ spill, floor }: Capacity): number {
  const { value, error } = spill.level;
  return Math.max(floor, value - error);
}
