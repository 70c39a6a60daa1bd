/** What is drawn of a pot: a line for each side, where its axis is, and how high it is to be. */

import { curveThrough } from "./curve";
import type { Knot, Spot } from "./knot";
import { mirrored } from "./sides";
import { awayFrom } from "./stroke";

/** The side of the sheet, in its own units. */
export const SHEET = 480;

/** A line that is put there keeps off the edge. */
export const MARGIN = 40;

export type Side = "right" | "left";

export interface Sheet {
  /** From the foot to the rim; empty before anything is drawn. */
  readonly right: readonly Knot[];
  /** Null where both sides are alike. */
  readonly left: readonly Knot[] | null;
  /** Where the axis is, across. */
  readonly axis: number;
  /** How high the pot is, in the unit of the design. */
  readonly height: number;
  /** How much of a photograph belonged to the pot when it was traced last. */
  readonly sensitivity?: number;
}

/** Radius and height in pairs, for each side that is its own. */
export interface DrawnProfile {
  readonly right: readonly number[];
  readonly left?: readonly number[];
}

/** Digits of a profile that is fitted: more are of no use. */
const DIGITS = 7;

/** Lines that are lower than this have no height that could be said. */
const LEAST = 2;

/** The sides that are drawn, the left one where it has a line of its own. */
export function sidesDrawn({ left }: Sheet): readonly Side[] {
  return left === null ? ["right"] : ["right", "left"];
}

export function knotsOn(sheet: Sheet, side: Side): readonly Knot[] {
  return side === "right" ? sheet.right : (sheet.left ?? []);
}

/** The line of a side; nowhere on the other side of the axis. */
export function lineOn(sheet: Sheet, side: Side): readonly Spot[] {
  const { axis } = sheet;
  const within = (x: number) => (side === "right" ? Math.max(axis, x) : Math.min(axis, x));
  return curveThrough(knotsOn(sheet, side)).map(({ x, y }) => ({ x: within(x), y }));
}

/** How many units of the design a unit of the sheet is, and where the foot stands on it; null before anything is drawn. */
export function scaleOf(sheet: Sheet): { readonly unit: number; readonly foot: number } | null {
  const ys = sidesDrawn(sheet).flatMap((side) => lineOn(sheet, side).map(({ y }) => y));
  if (ys.length === 0) return null;
  const [top, foot] = [ys.reduce((a, b) => Math.min(a, b)), ys.reduce((a, b) => Math.max(a, b))];
  return foot - top < LEAST ? null : { unit: sheet.height / (foot - top), foot };
}

/** What rings are to be fitted to; null before there is a line. */
export function profileOf(sheet: Sheet): DrawnProfile | null {
  const scale = scaleOf(sheet);
  if (!scale) return null;
  const { unit, foot } = scale;
  const short = (value: number) => Number((value === 0 ? 0 : value).toPrecision(DIGITS));
  const numbers = (side: Side) =>
    lineOn(sheet, side).flatMap(({ x, y }) => [short(unit * Math.abs(x - sheet.axis)), short(unit * (foot - y))]);
  return { right: numbers("right"), ...(sheet.left !== null && { left: numbers("left") }) };
}

/** A knot as radius and height. */
export function measured(sheet: Sheet, { x, y }: Spot): { readonly radius: number; readonly height: number } {
  const { unit, foot } = scaleOf(sheet) ?? { unit: 1, foot: y };
  return { radius: unit * Math.abs(x - sheet.axis), height: unit * (foot - y) };
}

/** Where a radius and a height are on a side. */
export function placed(sheet: Sheet, side: Side, radius: number, height: number): Spot {
  const { unit, foot } = scaleOf(sheet) ?? { unit: 1, foot: 0 };
  const out = Math.max(0, radius) / unit;
  return { x: side === "right" ? sheet.axis + out : sheet.axis - out, y: foot - height / unit };
}

/** Both sides anew; the pot is as high as before. */
export function withSides(
  sheet: Sheet,
  right: readonly Knot[],
  left: readonly Knot[] | null,
  axis = sheet.axis,
): Sheet {
  return { ...sheet, right, left, axis };
}

/** One side anew. */
export function withSide(sheet: Sheet, side: Side, knots: readonly Knot[]): Sheet {
  return side === "right" ? { ...sheet, right: knots } : { ...sheet, left: knots };
}

/** Both sides alike, as the right one is; or each for itself. */
export function withSymmetry(sheet: Sheet, alike: boolean): Sheet {
  if (alike === (sheet.left === null)) return sheet;
  return { ...sheet, left: alike ? null : mirrored(sheet.right, sheet.axis) };
}

/** Changes knots of a side; the scale stays, so the pot may be higher or lower after that. */
function changed(sheet: Sheet, side: Side, knots: readonly Knot[]): Sheet {
  const next = withSide(sheet, side, knots);
  const before = scaleOf(sheet);
  const after = scaleOf({ ...next, height: 1 });
  return before && after ? { ...next, height: Number((before.unit / after.unit).toPrecision(DIGITS)) } : next;
}

export function moveKnot(sheet: Sheet, side: Side, index: number, { x, y }: Spot): Sheet {
  const across = side === "right" ? Math.max(sheet.axis, x) : Math.min(sheet.axis, x);
  const knots = knotsOn(sheet, side).map((knot, i) => (i === index ? { ...knot, x: across, y } : knot));
  return changed(sheet, side, knots);
}

/** Moves the axis; what is drawn stays where it is, as far as it is on its side. */
export function moveAxis(sheet: Sheet, x: number): Sheet {
  const within = (side: Side, knots: readonly Knot[]) =>
    knots.map((knot) => ({ ...knot, x: side === "right" ? Math.max(x, knot.x) : Math.min(x, knot.x) }));
  return { ...sheet, axis: x, right: within("right", sheet.right), left: sheet.left && within("left", sheet.left) };
}

/** One more knot on the line, halfway from one to the next. */
export function addKnot(sheet: Sheet, side: Side, index: number): Sheet {
  const knots = knotsOn(sheet, side);
  const [a, b] = [knots[index], knots[index + 1]];
  if (!a || !b) return sheet;
  const piece = curveThrough(knots).slice();
  const from = piece.findIndex(({ x, y }) => x === a.x && y === a.y);
  const to = piece.findIndex(({ x, y }, i) => i > from && x === b.x && y === b.y);
  const middle = to - from > 1 ? piece[Math.round((from + to) / 2)] : { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  if (!middle) return sheet;
  return withSide(sheet, side, [...knots.slice(0, index + 1), { ...middle, sharp: false }, ...knots.slice(index + 1)]);
}

/** Takes a knot away; two stay. */
export function removeKnot(sheet: Sheet, side: Side, index: number): Sheet {
  const knots = knotsOn(sheet, side);
  return knots.length <= 2
    ? sheet
    : changed(
        sheet,
        side,
        knots.filter((_, i) => i !== index),
      );
}

export function sharpenKnot(sheet: Sheet, side: Side, index: number, sharp: boolean): Sheet {
  return withSide(
    sheet,
    side,
    knotsOn(sheet, side).map((knot, i) => (i === index ? { ...knot, sharp } : knot)),
  );
}

/** Between which two knots of a side a place on its line is, by the first of them; null where it is on none. */
export function gapAt(sheet: Sheet, side: Side, place: Spot, within: number): number | null {
  const knots = knotsOn(sheet, side);
  let [nearest, found] = [within, null as number | null];
  for (let i = 0; i + 1 < knots.length; i += 1) {
    const away = awayFrom(place, knots[i] as Knot, knots[i + 1] as Knot);
    if (away <= nearest) [nearest, found] = [away, i];
  }
  return found;
}

/** A plain line to begin with: three knots, as high as the sheet allows. */
export function plainLine(axis: number, top: number, foot: number): readonly Knot[] {
  const high = foot - top;
  const knot = (out: number, up: number): Knot => ({ x: axis + out * high, y: foot - up * high, sharp: false });
  return [knot(0.22, 0), knot(0.32, 0.5), knot(0.2, 1)];
}
