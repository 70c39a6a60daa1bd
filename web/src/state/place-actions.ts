/** What a person can do to where the selected part stands. */

import { setPath } from "../document/path";
import { UNMOVED, type WholePlacement } from "../document/placement";
import type { Change, State } from "./store";

/** Scales, turns or moves it. What a hand goes on changing is one step with `key`. What is as if it had never been placed has no placement. */
export function changePlace(state: State, edit: (place: WholePlacement) => WholePlacement, key?: string): Change {
  const part = state.design.parts[state.part];
  if (!part) return { undo: "none" };
  const before: WholePlacement = { ...UNMOVED, ...part.place };
  const after = edit(before);
  if (same(before, after)) return { undo: "none" };
  const place = same(after, UNMOVED) ? undefined : after;
  const design = setPath(state.design, ["parts", state.part, "place"], place);
  return key === undefined ? { design, undo: "step" } : { design, undo: "merge", key: `place:${key}` };
}

function same(one: WholePlacement, other: WholePlacement): boolean {
  const numbers = ({ scale, axis, angle, shift }: WholePlacement) => [...scale, ...axis, angle, ...shift];
  const others = numbers(other);
  return numbers(one).every((number, at) => number === others[at]);
}
