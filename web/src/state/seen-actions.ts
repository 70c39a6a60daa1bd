/** Which parts are selected and which are hidden: that is the session's, not the document's. */

import type { PartId } from "./part-ids";
import type { Change, State } from "./store";

export function selectParts(...selection: readonly PartId[]): Change {
  return { undo: "none", session: { selection } };
}

/** Hides a part, or shows it again. It stays in the design, in its measures and in its files. */
export function togglePart({ session }: State, id: PartId): Change {
  const { hidden } = session;
  return {
    undo: "none",
    session: { hidden: hidden.includes(id) ? hidden.filter((each) => each !== id) : [...hidden, id] },
  };
}

/** How many parts of the design are hidden. */
export function hiddenParts({ ids, session }: Pick<State, "ids" | "session">): number {
  return ids.filter((id) => session.hidden.includes(id)).length;
}
