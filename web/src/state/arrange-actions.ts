/** What a person can do to where several parts stand together: pure functions of the document and of what each part fills, as the solver told it. */

import type { Box } from "../document/box";
import { boxAround, roundTo, tableUnder } from "../document/boxes";
import { type Axis, mirrored, moved, scaledBy, turned, unit } from "../document/moving";
import type { Triple } from "../document/types";
import type { PartId } from "./part-ids";
import { placeParts, standingOf } from "./place-actions";
import { copyParts } from "./scene-actions";
import { selectedIds } from "./seen-actions";
import { looseIds } from "./several-actions";
import type { Change, State } from "./store";

export type Boxes = ReadonlyMap<PartId, Box>;
export type Side = "low" | "middle" | "high";

const NOTHING: Change = { undo: "none" };
/** The digits of a mesh, as a share of the part: the rest is rounding. */
const TOLD = 1e-6;

/** Aligns a side of the selected parts, or their middle, with that of the part that was selected last, which stays. */
export function alignParts(state: State, boxes: Boxes, axis: Axis, side: Side): Change {
  const lead = boxes.get(selectedIds(state).at(-1) ?? -1);
  if (!lead) return NOTHING;
  return shiftEach(state, boxes, axis, (box) => of(lead, axis, side) - of(box, axis, side));
}

/** Brings the middles of the selected parts over that of the part that was selected last: onto one upright axis. */
export function alignOnAxis(state: State, middles: ReadonlyMap<PartId, Triple>): Change {
  const points = new Map([...middles].map(([id, point]) => [id, { min: point, max: point }] as const));
  const first = alignParts(state, points, 0, "middle");
  const between = first.design ? { ...state, design: first.design } : state;
  const second = alignParts(between, points, 1, "middle");
  return second.design ? second : first;
}

/** The lowest point of each selected part comes to the table: that is under all others, and at 0 or below. */
export function putOnTable(state: State, boxes: Boxes): Change {
  const loose = looseIds(state);
  const others = [...boxes].flatMap(([id, box]) => (loose.includes(id) ? [] : [box]));
  const table = tableUnder(others);
  return shiftEach(state, boxes, 2, ({ min }) => table - min[2]);
}

/** Leaves the same gap between the selected parts along an axis; the outermost stay. Fewer than three are as far apart as they are. */
export function distributeParts(state: State, boxes: Boxes, axis: Axis): Change {
  const chosen = selectedIds(state).flatMap((id) => {
    const box = boxes.get(id);
    return box ? [{ id, box }] : [];
  });
  const [first, ...rest] = chosen.sort((a, b) => of(a.box, axis, "middle") - of(b.box, axis, "middle"));
  const last = rest.at(-1);
  if (!first || !last || rest.length < 2) return NOTHING;
  const long = ({ min, max }: Box) => max[axis] - min[axis];
  const within = rest.slice(0, -1);
  const taken = within.reduce((sum, { box }) => sum + long(box), 0);
  const gap = (last.box.min[axis] - first.box.max[axis] - taken) / rest.length;
  const to = new Map<PartId, number>();
  let from = first.box.max[axis];
  for (const { id, box } of within) {
    to.set(id, from + gap - box.min[axis]);
    from += gap + long(box);
  }
  return shiftEach(state, boxes, axis, (_, id) => to.get(id) ?? 0);
}

/** Turns the selected parts into their mirror image: left and right, front and back, or top and bottom change places. */
export function mirrorParts(state: State, boxes: Boxes, axis: Axis): Change {
  const loose = looseIds(state);
  const box = boxAround(loose.flatMap((id) => boxes.get(id) ?? []));
  if (!box) return NOTHING;
  const at = roundTo(of(box, axis, "middle"), lastDigit(box));
  return placeParts(state, new Map(loose.map((id) => [id, mirrored(standingOf(state, id), axis, at)])));
}

/** So many of the selected parts in a row, each a step further than the one before. */
export function rowOfParts(state: State, count: number, step: Triple): Change {
  const where = Array.from({ length: count - 1 }, (_, k) => scaledBy(k + 1, step));
  return copyParts(
    state,
    inOrder(state),
    where.map((by) => (place) => moved(place, by)),
    true,
  );
}

/**
 * So many of the selected parts round an upright axis, over `angle` (radians): all round they stand at equal angles, over less the first and the last stand at its ends. Each turns with its place, or
 * looks the same way as the first.
 */
export function ringOfParts(
  state: State,
  count: number,
  angle: number,
  [x, y]: readonly [number, number],
  turning: boolean,
): Change {
  const round = Math.abs(Math.abs(angle) - 2 * Math.PI) < 1e-9;
  const step = angle / (round ? count : Math.max(1, count - 1));
  const about: Triple = [x, y, 0];
  const where = Array.from({ length: count - 1 }, (_, k) => {
    const by = (k + 1) * step;
    return (place: ReturnType<typeof standingOf>) => {
      const went = turned(place, unit(2), by, about);
      return turning ? went : { ...place, shift: went.shift };
    };
  });
  return copyParts(state, inOrder(state), where, true);
}

function inOrder(state: State): readonly PartId[] {
  const chosen = selectedIds(state);
  return state.ids.filter((id) => chosen.includes(id));
}

function of({ min, max }: Box, axis: Axis, side: Side): number {
  return side === "low" ? min[axis] : side === "high" ? max[axis] : (min[axis] + max[axis]) / 2;
}

/** Moves each of the selected parts that may be moved along an axis. */
function shiftEach(state: State, boxes: Boxes, axis: Axis, by: (box: Box, id: PartId) => number): Change {
  const places = looseIds(state).flatMap((id) => {
    const box = boxes.get(id);
    if (!box) return [];
    const far = roundTo(by(box, id), lastDigit(box));
    return far === 0 ? [] : [[id, moved(standingOf(state, id), scaledBy(far, unit(axis)))] as const];
  });
  return placeParts(state, new Map(places));
}

function lastDigit({ min, max }: Box): number {
  const size = Math.max(...max.map((high, i) => high - (min[i] as number)), ...max.map(Math.abs), ...min.map(Math.abs));
  return size > 0 ? 10 ** Math.floor(Math.log10(TOLD * size)) : 1;
}
