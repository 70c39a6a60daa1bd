/** Which parts are selected and which are hidden: that is the session's, not the document's. */

import type { PartId } from "./part-ids";
import type { Change, State } from "./store";

export function selectParts(...selection: readonly PartId[]): Change {
  return { undo: "none", session: { selection } };
}

/** The selected parts that are there, the one that panels are about last. */
export function selectedIds({ ids, part, session }: Pick<State, "ids" | "part" | "session">): readonly PartId[] {
  const there = session.selection.filter((id, at, all) => ids.includes(id) && all.lastIndexOf(id) === at);
  const only = ids[part];
  return there.length > 0 || only === undefined ? there : [only];
}

/** Selects a part besides the others, or takes it out of the selection; one stays selected. */
export function alsoSelect(state: State, id: PartId): Change {
  const now = selectedIds(state);
  const left = now.filter((each) => each !== id);
  if (now.includes(id)) return left.length > 0 ? selectParts(...left) : { undo: "none" };
  return selectParts(...now, id);
}

/** Hides a part, or shows it again. It stays in the design, in its measures and in its files. */
export function togglePart({ session }: State, id: PartId): Change {
  const { hidden } = session;
  return {
    undo: "none",
    session: { hidden: hidden.includes(id) ? hidden.filter((each) => each !== id) : [...hidden, id] },
  };
}

/** Shows the inside of the selected part in the place of its skin, or its skin again. */
export function toggleInside({ session, ids, part }: State): Change {
  const id = ids[part] ?? null;
  return { undo: "none", session: { inside: session.inside === id ? null : id } };
}

/** The part whose inside is to be seen, as long as it is a blend of this design. */
export function insidePart({ session, ids, design }: Pick<State, "session" | "ids" | "design">): PartId | null {
  const { inside } = session;
  const place = inside === null ? -1 : ids.indexOf(inside);
  return design.parts[place]?.shape.kind === "blend" ? inside : null;
}

/** How many parts of the design are hidden. */
export function hiddenParts({ ids, session }: Pick<State, "ids" | "session">): number {
  return ids.filter((id) => session.hidden.includes(id)).length;
}
