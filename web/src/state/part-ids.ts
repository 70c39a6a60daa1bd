/** Who a part is while the page is open. The document knows parts by their place alone, which changes when one before them goes. */

import type { Design } from "../document/types";

/** A part keeps it through every change of its numbers, its name and its place in the design, and finds it again by undo. */
export type PartId = number;

/** A design with the identities of its parts, in their order. */
export interface Identified {
  readonly design: Design;
  readonly ids: readonly PartId[];
}

/** So many identities that nobody had before. */
export function freshIds(count: number, fresh: PartId): readonly PartId[] {
  return Array.from({ length: count }, (_, index) => fresh + index);
}

/** The place of the part that panels are about: the one selected last of those that are there, or the first. */
export function placeOf(selection: readonly PartId[], ids: readonly PartId[]): number {
  const last = selection.findLast((id) => ids.includes(id));
  return last === undefined ? 0 : ids.indexOf(last);
}
