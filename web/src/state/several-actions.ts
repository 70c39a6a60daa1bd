/** What is done with several parts at once that is the session's: selected through the list, locked, hidden. Fetched with what does it. */

import type { PartId } from "./part-ids";
import { selectedIds, selectParts } from "./seen-actions";
import type { Change, State } from "./store";

/** Those of the selected ones that a hand may move. */
export function looseIds(state: Pick<State, "ids" | "part" | "session">): readonly PartId[] {
  return selectedIds(state).filter((id) => !state.session.locked.includes(id));
}

/** Selects all from the part that panels are about to another one, in the order of the list. */
export function selectThrough(state: State, id: PartId): Change {
  const { ids, part } = state;
  const to = ids.indexOf(id);
  const run = ids.slice(Math.min(part, to), Math.max(part, to) + 1);
  const others = selectedIds(state).filter((each) => !run.includes(each));
  return selectParts(...others, ...run.filter((each) => each !== id), id);
}

/** Lets no hand move some parts, or any again. What is locked is the session's: in links and files everything is loose. */
export function lockParts({ session }: State, ids: readonly PartId[], lock: boolean): Change {
  const others = session.locked.filter((each) => !ids.includes(each));
  return { undo: "none", session: { locked: lock ? [...others, ...ids] : others } };
}

/** Hides parts, or shows them again. */
export function hideParts({ session }: State, ids: readonly PartId[], hide: boolean): Change {
  const others = session.hidden.filter((id) => !ids.includes(id));
  return { undo: "none", session: { hidden: hide ? [...others, ...ids] : others } };
}
