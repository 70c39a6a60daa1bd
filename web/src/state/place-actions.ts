/** What a person can do to where parts stand. */

import { carried } from "../document/joints";
import { setPath } from "../document/path";
import { UNMOVED, type WholePlacement } from "../document/placement";
import type { PartId } from "./part-ids";
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

/** Puts parts where they are told to stand, all as one change: the limits of their joints go along. What a hand goes on changing is one step with `key`. */
export function placeParts(state: State, places: ReadonlyMap<PartId, WholePlacement>, key?: string): Change {
  let { design } = state;
  for (const [id, after] of places) {
    const at = state.ids.indexOf(id);
    const part = design.parts[at];
    const before = { ...UNMOVED, ...part?.place };
    if (!part || same(before, after)) continue;
    design = setPath(design, ["parts", at, "place"], same(after, UNMOVED) ? undefined : after);
    if (part.joints) design = setPath(design, ["parts", at, "joints"], carried(part.joints, before, after));
  }
  if (design === state.design) return { undo: "none" };
  return key === undefined ? { design, undo: "step" } : { design, undo: "merge", key: `place:${key}` };
}

/** Where a part stands. */
export function standingOf({ design, ids }: Pick<State, "design" | "ids">, id: PartId): WholePlacement {
  return { ...UNMOVED, ...design.parts[ids.indexOf(id)]?.place };
}

function same(one: WholePlacement, other: WholePlacement): boolean {
  const numbers = ({ scale, axis, angle, shift }: WholePlacement) => [...scale, ...axis, angle, ...shift];
  const others = numbers(other);
  return numbers(one).every((number, at) => number === others[at]);
}
