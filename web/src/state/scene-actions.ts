/** What a person can do to the parts of a design as a whole: pure functions from a state to the change that they ask for. */

import { carried } from "../document/joints";
import { labelOf } from "../document/label";
import { sum } from "../document/moving";
import { setPath } from "../document/path";
import { UNMOVED, type WholePlacement } from "../document/placement";
import { LIMITS } from "../document/tables.gen";
import type { Part, Placement, Triple } from "../document/types";
import { freshIds, type PartId } from "./part-ids";
import { selectedIds } from "./seen-actions";
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
  const short = labelOf(name.trim(), MAX_NAME);
  const part = state.design.parts[place];
  if (!part || isTaken(state, id, short) || (part.name ?? "") === short) return NOTHING;
  return {
    design: setPath(state.design, ["parts", place, "name"], short === "" ? undefined : short),
    undo: "merge",
    key: `name:${id}`,
  };
}

/** Moves a part up the list or down. What was selected is so still: the first part too, which is as long as none was chosen. */
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
    session: { selection: selectedIds(state) },
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

/** Copies of parts after the last of them, so far to their right that they touch nothing, glued as those are, and selected. */
export function duplicateParts(state: State, ids: readonly PartId[], aside: number): Change {
  return copyParts(state, ids, [(place) => ({ ...place, shift: sum(place.shift, [aside, 0, 0]) })], false);
}

/**
 * Copies of parts after the last of them, once for each of `where`, which says where each of them goes. What is glued among them is glued in each copy, and to nothing else; with `also`, where
 * the parts are of one row with their copies, what is glued to others is so in each copy: feet of one bowl. A design of more parts than there may be comes of none. The last copy is selected,
 * or with `also` the parts themselves and all copies.
 */
export function copyParts(
  state: State,
  ids: readonly PartId[],
  where: readonly ((place: WholePlacement) => WholePlacement)[],
  also: boolean,
): Change {
  const { design, fresh } = state;
  const places = state.ids.flatMap((id, place) => (ids.includes(id) ? [place] : []));
  const after = 1 + (places.at(-1) ?? -1);
  const count = places.length * where.length;
  if (count === 0 || design.parts.length + count > LIMITS.parts) return NOTHING;
  const all = [...design.parts];
  const others = new Set(design.parts.flatMap((part, place) => (places.includes(place) ? [] : [objectOf(part)])));
  for (const to of where) {
    const objects = new Map<number, number>(also ? [...others].map((object) => [object, object]) : []);
    const taken = new Set(all.map(objectOf));
    const objectFor = (object: number): number => {
      const known = objects.get(object);
      if (known !== undefined) return known;
      let free = 0;
      while (taken.has(free)) free += 1;
      taken.add(free);
      objects.set(object, free);
      return free;
    };
    for (const place of places) {
      const { name, ...rest } = design.parts[place] as Part;
      const before = { ...UNMOVED, ...rest.place };
      const after = to(before);
      all.push({
        ...rest,
        ...(name !== undefined && { name: freeName(all, name) }),
        object: objectFor(objectOf(rest)),
        place: briefly(after, rest.place),
        ...(rest.joints && { joints: carried(rest.joints, before, after) }),
      });
    }
  }
  const copies = all.slice(design.parts.length);
  const more = freshIds(count, fresh);
  return {
    design: { ...design, parts: design.parts.toSpliced(after, 0, ...copies) },
    ids: state.ids.toSpliced(after, 0, ...more),
    session: { selection: also ? [...more, ...ids] : more.slice(-places.length) },
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
    const [before, after] = [
      { ...UNMOVED, ...place },
      { ...UNMOVED, ...place, shift },
    ];
    const joints = rest.joints && { joints: carried(rest.joints, before, after) };
    return { ...rest, ...kept, ...joints, object: object + objectOf(rest), place: { ...place, shift } };
  });
  const more = freshIds(parts.length, fresh);
  return {
    design: { ...design, parts: [...design.parts, ...added] },
    ids: [...ids, ...more],
    session: { selection: more.slice(0, 1) },
    undo: "step",
  };
}

/** A placement that says what it has to, and what that before said. */
function briefly(place: WholePlacement, before: Placement | undefined): Placement {
  const said = Object.entries(place).filter(
    ([key, value]) => (before && key in before) || String(value) !== String(UNMOVED[key as keyof Placement]),
  );
  return Object.fromEntries(said);
}

/** Takes parts away and selects what follows the last of them, or else what is before. A design has one part at least: of all none goes. */
export function deleteParts(state: State, gone: readonly PartId[]): Change {
  const { design, ids } = state;
  const left = ids.filter((id) => !gone.includes(id));
  const last = ids.findLastIndex((id) => gone.includes(id));
  if (last < 0 || left.length === 0) return NOTHING;
  const next = ids.slice(last).find((id) => left.includes(id)) ?? left.at(-1);
  return {
    design: { ...design, parts: design.parts.filter((_, place) => left.includes(ids[place] as PartId)) },
    ids: left,
    session: { selection: next === undefined ? [] : [next] },
    undo: "step",
  };
}

/** Glues parts together: into the object of the last of them, with all that was glued to any of them. */
export function glueTogether(state: State, ids: readonly PartId[]): Change {
  const { design } = state;
  const chosen = ids.map((id) => design.parts[state.ids.indexOf(id)]).filter((part) => part !== undefined);
  const into = chosen.at(-1);
  if (!into) return NOTHING;
  const joined = new Set(chosen.map(objectOf));
  return inObjects(state, (part) => (joined.has(objectOf(part)) ? objectOf(into) : objectOf(part)));
}

/** Makes some parts of one object an object of their own, glued as they are among themselves. */
export function splitOff(state: State, ids: readonly PartId[]): Change {
  const free = freeObject(state.design.parts);
  const left = new Set(
    state.ids.flatMap((id, place) => (ids.includes(id) ? [] : objectOf(state.design.parts[place] as Part))),
  );
  // What is an object of its own already stays as it is.
  return inObjects(state, (part, id) => (ids.includes(id) && left.has(objectOf(part)) ? free : objectOf(part)));
}

/** Makes each of some parts an object of its own. */
export function separateParts(state: State, ids: readonly PartId[]): Change {
  const { design } = state;
  const taken = new Set(design.parts.map(objectOf));
  const counts = new Map<number, number>();
  for (const part of design.parts) counts.set(objectOf(part), 1 + (counts.get(objectOf(part)) ?? 0));
  return inObjects(state, (part, id) => {
    const object = objectOf(part);
    const others = (counts.get(object) ?? 1) - 1;
    if (!ids.includes(id) || others === 0) return object;
    counts.set(object, others);
    let free = 0;
    while (taken.has(free)) free += 1;
    taken.add(free);
    return free;
  });
}

/** All parts that are glued to any of these, and these. */
export function gluedTo({ design, ids }: Pick<State, "design" | "ids">, some: readonly PartId[]): readonly PartId[] {
  const objects = new Set(some.flatMap((id) => design.parts[ids.indexOf(id)] ?? []).map(objectOf));
  return ids.filter((_, place) => objects.has(objectOf(design.parts[place] as Part)));
}

/** Puts every part into the object that it is told. */
function inObjects(state: State, of: (part: Part, id: PartId) => number): Change {
  const { design, ids } = state;
  let next = design;
  for (const [place, part] of design.parts.entries()) {
    const object = of(part, ids[place] as PartId);
    if (object !== objectOf(part)) next = setPath(next, ["parts", place, "object"], object === 0 ? undefined : object);
  }
  return next === design ? NOTHING : { design: next, undo: "step" };
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
