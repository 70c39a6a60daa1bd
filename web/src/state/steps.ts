/** What could be undone and redone, as text: kept for as long as a tab is open, so that it survives a reload. What is read may have been written by anybody. */

import type { PartId } from "./part-ids";
import { isRecord } from "./record";

/** A document as JSON text with who its parts were. */
export interface Step {
  readonly text: string;
  readonly ids: readonly PartId[];
}

export interface Steps {
  /** The link of the design between what can be undone and what can be redone, and who its parts were. */
  readonly link: string;
  readonly ids: readonly PartId[];
  /** The nearest last. */
  readonly past: readonly Step[];
  /** The nearest first. */
  readonly future: readonly Step[];
}

/** So many steps each way come back, and so many characters of documents in all: a tab may keep some megabytes. */
const MOST_STEPS = 50;
const MOST_CHARACTERS = 250_000;

/** As many of the nearest steps as may be kept; those that can be undone come first. */
export function bounded(steps: Steps): Steps {
  let left = MOST_CHARACTERS;
  const nearest = (all: readonly Step[]): readonly Step[] => {
    const kept: Step[] = [];
    for (const step of all.slice(0, MOST_STEPS)) {
      left -= step.text.length;
      if (left < 0) break;
      kept.push(step);
    }
    return kept;
  };
  const past = [...nearest([...steps.past].reverse())].reverse();
  return { ...steps, past, future: nearest(steps.future) };
}

/** Null for what is nothing of the kind. */
export function stepsFrom(text: string | null): Steps | null {
  try {
    const kept: unknown = JSON.parse(text ?? "null");
    if (!isRecord(kept)) return null;
    const { link, ids, past, future } = kept;
    if (typeof link !== "string" || !areIds(ids) || !areSteps(past) || !areSteps(future)) return null;
    return bounded({ link, ids, past, future });
  } catch {
    return null;
  }
}

function areSteps(value: unknown): value is readonly Step[] {
  return (
    Array.isArray(value) && value.every((each) => isRecord(each) && typeof each.text === "string" && areIds(each.ids))
  );
}

function areIds(value: unknown): value is readonly PartId[] {
  return Array.isArray(value) && new Set(value).size === value.length && value.every((id) => Number.isSafeInteger(id));
}
