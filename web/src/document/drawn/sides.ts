/** The sides of a pot in a line that shows one of them, or both. */

import { evenly, type Spot } from "./knot";

/** Each from the foot to the rim. */
export interface Sides {
  readonly right: readonly Spot[];
  /** Null where the line shows one side alone. */
  readonly left: readonly Spot[] | null;
  /** Where the axis is, as far as the line says so. */
  readonly axis: number | null;
}

/** A line whose ends are this part of its height apart goes from foot to rim. */
const UPRIGHT = 0.5;

/** A floor and a closed mouth are this part of the height thick. */
const LEVEL = 0.005;

/** Points that are looked at of a line. */
const POINTS = 400;

/** An end this near the outermost point, as part of the height, is on the axis, as turners draw it. */
const AT_AXIS = 0.01;

/** How far outside of a line the axis is where nothing says so, as part of the height. */
const BESIDE = 0.15;

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export function boxOf(line: readonly Spot[]): Box {
  let [left, right, top, bottom] = [
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  for (const { x, y } of line) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  return { left, right, top, bottom };
}

/**
 * The sides in a line. `axis` is where the axis is, if that is known; a line that goes from foot to rim and stays on the left of it is seen in the mirror. What is level at the foot or the rim of an
 * outline is a floor or a mouth, and no side.
 */
export function sidesOf(line: readonly Spot[], closed: boolean, axis: number | null): Sides | null {
  const box = boxOf(line);
  const height = box.bottom - box.top;
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || !(height > 0)) return null;
  if (!closed && Math.abs(first.y - last.y) > UPRIGHT * height) {
    const up = first.y > last.y ? line : [...line].reverse();
    return oneSide(up, box, axis);
  }
  return bothSides(line, closed, box, axis);
}

function oneSide(line: readonly Spot[], box: Box, given: number | null): Sides | null {
  const height = box.bottom - box.top;
  const ends = [line[0] as Spot, line.at(-1) as Spot];
  const touches = (x: number) => ends.some((end) => Math.abs(end.x - x) < AT_AXIS * height);
  const guessed = touches(box.left) && box.right - box.left > AT_AXIS * height;
  const axis = given ?? (guessed ? box.left : box.left - BESIDE * height);
  const mean = line.reduce((sum, { x }) => sum + x, 0) / line.length;
  const right = mean < axis ? mirrored(line, axis) : line;
  const open = opened(right, box, axis);
  return open.length < 2 ? null : { right: open, left: null, axis: given === null ? axis : null };
}

/** As seen in the mirror of the axis. */
export function mirrored<T extends Spot>(line: readonly T[], axis: number): readonly T[] {
  return line.map((spot) => ({ ...spot, x: 2 * axis - spot.x }));
}

function bothSides(line: readonly Spot[], closed: boolean, box: Box, given: number | null): Sides | null {
  const middle = given ?? 0.5 * (box.left + box.right);
  const round = closed ? evenly([...line, line[0] as Spot], lengthGap(line, box)) : line;
  const arcs = closed ? cut(round.slice(0, -1), middle) : cutOpen(round, middle);
  if (!arcs) return null;
  const sides = arcs.map((arc) => opened(arc, box, middle)).filter((arc) => arc.length > 1);
  const [one, other] = sides;
  if (!one || !other) return null;
  const mean = (arc: readonly Spot[]) => arc.reduce((sum, { x }) => sum + x, 0) / arc.length;
  const [left, right] = mean(one) < mean(other) ? [one, other] : [other, one];
  return { right, left, axis: given === null ? middle : null };
}

function lengthGap(line: readonly Spot[], box: Box): number {
  return Math.max(box.bottom - box.top, box.right - box.left, 1e-9) / Math.max(POINTS, line.length / 4);
}

/** A closed line in two, each from the lowest point at the axis to the highest. */
function cut(line: readonly Spot[], axis: number): readonly (readonly Spot[])[] | null {
  const crossings = line.flatMap((spot, i) => {
    const next = line[(i + 1) % line.length] as Spot;
    return spot.x <= axis !== next.x <= axis ? [{ i, y: 0.5 * (spot.y + next.y) }] : [];
  });
  const [low] = [...crossings].sort((a, b) => b.y - a.y);
  const [high] = [...crossings].sort((a, b) => a.y - b.y);
  if (!low || !high || low.i === high.i) return null;
  const from = (start: number, end: number) => {
    const count = (end - start + line.length) % line.length;
    return Array.from({ length: count }, (_, k) => line[(start + 1 + k) % line.length] as Spot);
  };
  return [from(low.i, high.i), from(high.i, low.i).reverse()];
}

/** An open line from rim to rim in two, at its lowest point by the axis. */
function cutOpen(line: readonly Spot[], axis: number): readonly (readonly Spot[])[] | null {
  const crossings = line.slice(1).flatMap((spot, i) => ((line[i] as Spot).x <= axis !== spot.x <= axis ? [i] : []));
  const [low] = crossings.sort((a, b) => (line[b] as Spot).y - (line[a] as Spot).y);
  if (low === undefined) return null;
  return [line.slice(0, low + 1).reverse(), line.slice(low + 1)];
}

/** Without the floor at its beginning and the mouth at its end. */
function opened(line: readonly Spot[], box: Box, axis: number): readonly Spot[] {
  const level = LEVEL * (box.bottom - box.top);
  const out = ({ x }: Spot) => Math.abs(x - axis);
  /** Whether the line goes outwards there, more than it goes up or down. */
  const flat = (inner: Spot, outer: Spot) => out(outer) - out(inner) >= Math.abs(outer.y - inner.y);
  let [from, to] = [0, line.length - 1];
  for (; from + 1 < to; from += 1) {
    const [here, next] = [line[from] as Spot, line[from + 1] as Spot];
    if (box.bottom - next.y > level || !flat(here, next)) break;
  }
  for (; to > from + 1; to -= 1) {
    const [here, next] = [line[to] as Spot, line[to - 1] as Spot];
    if (next.y - box.top > level || !flat(here, next)) break;
  }
  return line.slice(from, to + 1);
}
