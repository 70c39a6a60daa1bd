/** Where a hand takes hold of the two sections of a blend on the stage, and what of a section moves with it. */

import type { Blend, Pair, Section, Triple } from "../types";
import { closedFigure, ENDS, type End, radiusOf, refigured, withNumber } from "./section";

export type GripName = "height" | "width" | "depth" | "turn" | "tangent";

export interface Grip {
  readonly end: End;
  readonly name: GripName;
  readonly at: Triple;
  /** Where it moves to when each of its numbers grows by 1. */
  readonly along: readonly Triple[];
  /** What it stands at the end of: the point from which a tangent starts. */
  readonly from: Triple | null;
}

/** A tangent is drawn so much shorter than it is. */
const DRAWN = 1 / 4;
/** What turns a section stands so far outside of it. */
const OUTSIDE = 1.3;
const DEGREE = Math.PI / 180;
/** Digits of what a hand does. */
const DIGITS = 4;

export function gripsOf(blend: Blend): readonly Grip[] {
  return ENDS.flatMap((end) => gripsAt(blend[end], end));
}

function gripsAt(section: Section, end: End): readonly Grip[] {
  const { z, taper, dz } = section;
  const [rx, ry] = radiusOf(section);
  const figure = closedFigure(section);
  const [mx, my] = figure?.middle ?? [0, 0];
  const turn = (figure?.turn ?? 0) * DEGREE;
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const way = ([x, y]: Pair): Pair => [x * c - y * s, x * s + y * c];
  const on = (point: Pair): Triple => {
    const [x, y] = way(point);
    return [mx + x, my + y, z];
  };
  const level = (direction: Pair): Triple => [...way(direction), 0];
  const base = on([-rx, 0]);
  const grip = (name: GripName, at: Triple, along: readonly Triple[], from: Triple | null = null): Grip => ({
    end,
    name,
    at,
    along,
    from,
  });
  const out = OUTSIDE * Math.SQRT1_2;
  const [ox, oy] = way([-out * rx, out * ry]);
  return [
    grip("height", [mx, my, z], [[0, 0, 1]]),
    grip("width", on([rx, 0]), [level([1, 0])]),
    grip("depth", on([0, ry]), [level([0, 1])]),
    ...(figure ? [grip("turn", [mx + ox, my + oy, z], [[-oy * DEGREE, ox * DEGREE, 0]])] : []),
    grip(
      "tangent",
      [base[0] * (1 + DRAWN * taper), base[1] * (1 + DRAWN * taper), z + DRAWN * dz],
      [
        [DRAWN * base[0], DRAWN * base[1], 0],
        [0, 0, DRAWN],
      ],
      base,
    ),
  ];
}

/** The section after its numbers under a grip have grown by so much. Sizes stay above nothing. */
export function gripped(section: Section, name: GripName, [first = 0, second = 0]: readonly number[]): Section {
  switch (name) {
    case "height":
      return withNumber(section, "z", neat(section.z + first));
    case "width":
    case "depth": {
      const index = name === "width" ? 0 : 1;
      const before = radiusOf(section)[index];
      return withNumber(section, index === 0 ? "radius-0" : "radius-1", neat(Math.max(before + first, before / 100)));
    }
    case "turn": {
      const before = closedFigure(section)?.turn ?? 0;
      return first === 0 ? section : refigured(section, { turn: Math.round(10 * (before + first)) / 10 });
    }
    case "tangent":
      return withNumber(withNumber(section, "taper", neat(section.taper + first)), "dz", neat(section.dz + second));
  }
}

/** What a grip says that it is at. */
export function gripNumbers(section: Section, name: GripName): readonly number[] {
  switch (name) {
    case "height":
      return [section.z];
    case "width":
      return [radiusOf(section)[0]];
    case "depth":
      return [radiusOf(section)[1]];
    case "turn":
      return [closedFigure(section)?.turn ?? 0];
    case "tangent":
      return [section.taper, section.dz];
  }
}

function neat(value: number): number {
  return Math.abs(value) < 1e-6 ? 0 : Number(value.toPrecision(DIGITS));
}
