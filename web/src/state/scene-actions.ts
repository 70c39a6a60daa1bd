/** What a person can do to the parts of a design as a whole: pure functions from a state to the change that they ask for. */

import { setPath } from "../document/path";
import type { Part, Triple } from "../document/types";
import { freshIds, type PartId } from "./part-ids";
import type { Change, State } from "./store";

const NOTHING: Change = { undo: "none" };

/** Longer names than titles may be are of no use in a list. */
export const MAX_NAME = 60;

/** Whether another part has this name already: the document wants each to be called differently. */
export function isTaken({ design, ids }: State, id: PartId, name: string): boolean {
  return design.parts.some((part, place) => ids[place] !== id && part.name === name.trim());
}

/** Calls a part otherwise, or by its place where nothing is left of the name. The typing is one step. */
export function renamePart(state: State, id: PartId, name: string): Change {
  const place = state.ids.indexOf(id);
  const short = [...name.trim()].slice(0, MAX_NAME).join("");
  const part = state.design.parts[place];
  if (!part || isTaken(state, id, short) || (part.name ?? "") === short) return NOTHING;
  return {
    design: setPath(state.design, ["parts", place, "name"], short === "" ? undefined : short),
    undo: "merge",
    key: `name:${id}`,
  };
}

/** Moves a part up the list or down. */
export function movePart(state: State, id: PartId, by: 1 | -1): Change {
  const { design, ids } = state;
  const from = ids.indexOf(id);
  const to = from + by;
  const [part, other] = [design.parts[from], design.parts[to]];
  if (!part || !other) return NOTHING;
  const swapped = <T>(all: readonly T[], one: T, another: T) =>
    all.map((each, place) => (place === from ? another : place === to ? one : each));
  return {
    design: { ...design, parts: swapped(design.parts, part, other) },
    ids: swapped(ids, id, ids[to] ?? id),
    undo: "step",
  };
}

/** The number of the object that a part belongs to: parts of one object are glued. */
export function objectOf(part: Part): number {
  return part.object ?? 0;
}

/** Glues a part to the object of another one, or makes it an object of its own; either way it leaves the one that it was in. */
export function gluePart(state: State, id: PartId, other: PartId | null): Change {
  const { design, ids } = state;
  const place = ids.indexOf(id);
  const part = design.parts[place];
  if (!part) return NOTHING;
  const joined = other === null ? undefined : design.parts[ids.indexOf(other)];
  const isAlone = design.parts.every((each) => each === part || objectOf(each) !== objectOf(part));
  if (other === null ? isAlone : !joined || objectOf(joined) === objectOf(part)) return NOTHING;
  const object = joined ? objectOf(joined) : freeObject(design.parts);
  return {
    design: setPath(design, ["parts", place, "object"], object === 0 ? undefined : object),
    undo: "step",
  };
}

/** A copy of a part after it, so far to its right that it touches nothing: an object of its own, and selected. */
export function duplicatePart(state: State, id: PartId, aside: number): Change {
  const { design, ids, fresh } = state;
  const place = ids.indexOf(id);
  const part = design.parts[place];
  if (!part) return NOTHING;
  const { name, ...rest } = part;
  const [x, y, z] = part.place?.shift ?? [0, 0, 0];
  const copy: Part = {
    ...rest,
    ...(name !== undefined && { name: freeName(design.parts, name) }),
    object: freeObject(design.parts),
    place: { ...part.place, shift: [x + aside, y, z] },
  };
  return {
    design: { ...design, parts: design.parts.toSpliced(place + 1, 0, copy) },
    ids: ids.toSpliced(place + 1, 0, fresh),
    session: { selection: [fresh] },
    undo: "step",
  };
}

/** Adds parts after all others, moved by so much, as an object of their own. The first of them is selected. */
export function addParts(state: State, parts: readonly Part[], by: Triple): Change {
  const { design, ids, fresh } = state;
  if (parts.length === 0) return NOTHING;
  const object = 1 + Math.max(...design.parts.map(objectOf));
  const names = new Set(design.parts.map(({ name }) => name));
  const added = parts.map(({ name, place, ...rest }): Part => {
    const [x, y, z] = place?.shift ?? [0, 0, 0];
    const shift: Triple = [x + by[0], y + by[1], z + by[2]];
    const kept = name === undefined || names.has(name) ? {} : { name };
    return { ...rest, ...kept, object: object + objectOf(rest), place: { ...place, shift } };
  });
  const more = freshIds(parts.length, fresh);
  return {
    design: { ...design, parts: [...design.parts, ...added] },
    ids: [...ids, ...more],
    session: { selection: more.slice(0, 1) },
    undo: "step",
  };
}

/** Takes a part away and selects the one that follows it, or else the one before. A design has one part at least. */
export function deletePart(state: State, id: PartId): Change {
  const { design, ids } = state;
  const place = ids.indexOf(id);
  if (place < 0 || ids.length < 2) return NOTHING;
  const left = ids.toSpliced(place, 1);
  return {
    design: { ...design, parts: design.parts.toSpliced(place, 1) },
    ids: left,
    session: { selection: left.slice(Math.min(place, left.length - 1)).slice(0, 1) },
    undo: "step",
  };
}

/** The least number that no object has. */
function freeObject(parts: readonly Part[]): number {
  const taken = new Set(parts.map(objectOf));
  for (let number = 0; ; number += 1) if (!taken.has(number)) return number;
}

/** “Lid 2” for another “Lid”, and “Lid 3” after that. */
function freeName(parts: readonly Part[], name: string): string {
  const stem = name.replace(/ \d+$/, "");
  const taken = new Set(parts.map((part) => part.name));
  for (let number = 2; ; number += 1) {
    const next = `${stem} ${number}`;
    if (!taken.has(next)) return next;
  }
}
