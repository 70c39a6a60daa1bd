/** Undo and redo over whole frozen documents, which share all that did not change, with the identities of their parts. */

import type { Identified, PartId } from "./part-ids";

/** A document with what was selected when it was left; of before a reload that is not known. */
export interface Left extends Identified {
  readonly selection?: readonly PartId[];
}

export interface History {
  readonly past: readonly Left[];
  readonly future: readonly Left[];
  /** The key of the gesture whose changes join one step; null between gestures. */
  readonly merging: string | null;
}

export const EMPTY: History = { past: [], future: [], merging: null };

/** Documents are a few kilobytes and share structure: this many steps cost nothing that anyone would notice. */
const MAX_STEPS = 500;

/** The history after `before` was replaced. */
export function record(
  history: History,
  before: Left,
  change: { readonly undo: "step" | "merge" | "none"; readonly key?: string },
): History {
  if (change.undo === "none") return history;
  const key = change.undo === "merge" ? (change.key ?? "") : null;
  if (key !== null && key === history.merging) return { ...history, future: [] };
  return { past: [...history.past, before].slice(-MAX_STEPS), future: [], merging: key };
}

export function endMerge(history: History): History {
  return history.merging === null ? history : { ...history, merging: null };
}

/** Takes back the gesture under way, as if it had never begun. */
export function cancelMerge(history: History): { history: History; now: Left } | null {
  const now = history.merging === null ? undefined : history.past.at(-1);
  return now ? { now, history: { past: history.past.slice(0, -1), future: [], merging: null } } : null;
}

/**
 * Steps of before a reload, put behind those that were made since. What could be redone then can still be, unless something was done meanwhile.
 */
export function recall(history: History, { past, future }: Pick<History, "past" | "future">): History {
  const still = history.past.length === 0 && history.future.length === 0 && history.merging === null;
  return { ...history, past: [...past, ...history.past].slice(-MAX_STEPS), future: still ? future : history.future };
}

export function canUndo(history: History): boolean {
  return history.past.length > 0;
}

export function canRedo(history: History): boolean {
  return history.future.length > 0;
}

export function undo(history: History, from: Left): { history: History; now: Left } | null {
  const now = history.past.at(-1);
  if (!now) return null;
  return { now, history: { past: history.past.slice(0, -1), future: [from, ...history.future], merging: null } };
}

export function redo(history: History, from: Left): { history: History; now: Left } | null {
  const [now, ...future] = history.future;
  if (!now) return null;
  return { now, history: { past: [...history.past, from], future, merging: null } };
}
