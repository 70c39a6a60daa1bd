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

/** To another document of the history. */
export interface Trip {
  readonly history: History;
  readonly now: Left;
}

export const EMPTY: History = { past: [], future: [], merging: null };

/** Documents are a few kilobytes and share structure: this many steps cost nothing that anyone would notice. */
const MAX_STEPS = 500;

/** The history after `before` was replaced. What could be redone is there until a gesture has ended: it may not have been meant. */
export function record(
  history: History,
  before: Left,
  change: { readonly undo: "step" | "merge" | "none"; readonly key?: string },
): History {
  if (change.undo === "none") return history;
  const key = change.undo === "merge" ? (change.key ?? "") : null;
  if (key !== null && key === history.merging) return history;
  const future = key === null || history.merging !== null ? [] : history.future;
  return { past: [...history.past, before].slice(-MAX_STEPS), future, merging: key };
}

export function endMerge(history: History): History {
  return history.merging === null ? history : { ...history, future: [], merging: null };
}

/** Takes back the gesture under way, as if it had never begun. */
export function cancelMerge(history: History): Trip | null {
  return history.merging === null ? null : back(history, history.future);
}

/**
 * Steps of before a reload, put behind those that were made since. What could be redone then can still be, unless something was done meanwhile.
 */
export function recall(history: History, { past, future }: Pick<History, "past" | "future">): History {
  const still = history.past.length + history.future.length === 0;
  return { ...history, past: [...past, ...history.past].slice(-MAX_STEPS), future: still ? future : history.future };
}

export function canUndo(history: History): boolean {
  return history.past.length > 0;
}

export function canRedo({ future, merging }: History): boolean {
  return merging === null && future.length > 0;
}

export function undo(history: History, from: Left): Trip | null {
  return back(history, [from, ...endMerge(history).future]);
}

export function redo(history: History, from: Left): Trip | null {
  const [now, ...future] = endMerge(history).future;
  return now ? { now, history: { past: [...history.past, from], future, merging: null } } : null;
}

function back({ past }: History, future: readonly Left[]): Trip | null {
  const now = past.at(-1);
  return now ? { now, history: { past: past.slice(0, -1), future, merging: null } } : null;
}
