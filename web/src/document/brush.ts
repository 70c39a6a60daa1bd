/** How a hand pulls: which way, how wide, and at how many places round the axis. */

import type { Shape } from "./types";

/** Away from the axis, up and down, round the axis, or as the hand goes in the plane of the axis. */
export type Way = "out" | "up" | "round" | "free";
export const WAYS: readonly Way[] = ["out", "up", "round", "free"];

/** All round alike, at one side, or at several places. */
export type Spread = "all" | "side" | "petals";
export const SPREADS: readonly Spread[] = ["all", "side", "petals"];

export interface Brush {
  readonly way: Way;
  readonly spread: Spread;
  /** The angle between the two places where a pull at one side is half as strong, in degrees. */
  readonly width: number;
  readonly petals: number;
}

export const NEW_BRUSH: Brush = { way: "out", spread: "side", width: 60, petals: 5 };

/** What a slider offers. Narrower ones than the solver takes are none of them. */
export const WIDTHS = { least: 18, most: 180 } as const;
export const PETALS = { least: 2, most: 12 } as const;

/** By how much a step of the wheel or a key widens it. */
const WIDER = 1.12;

const RADIAN = Math.PI / 180;

/** The same brush, so many steps wider; only what is pulled at one side has a width. */
export function widened(brush: Brush, steps: number): Brush {
  const width = within(brush.width * WIDER ** steps, WIDTHS.least, WIDTHS.most);
  return { ...brush, width: Math.round(10 * width) / 10 };
}

/** The same brush between two fingers: what pulls at one side pulls at both. */
export function squeezing(brush: Brush): Brush {
  return brush.spread === "side" ? { ...brush, spread: "petals", petals: 2 } : brush;
}

export function within(value: number, least: number, most: number): number {
  return Math.min(Math.max(value, least), most);
}

/** What the solver is told of it: petals share the turn among themselves, each half as wide as its place. */
export function spreadOf({ spread, width, petals }: Brush): { readonly width?: number; readonly petals?: number } {
  switch (spread) {
    case "all":
      return {};
    case "side":
      return { width: width * RADIAN };
    case "petals":
      return { width: Math.PI / petals, petals };
  }
}

/** How strong a pull is round the axis: `cos^(2 degree)(petals angle / 2)`, as the solver forms it. */
export interface Bump {
  readonly degree: number;
  readonly petals: number;
}

export function bumpOf(brush: Brush): Bump {
  const { width, petals = 1 } = spreadOf(brush);
  const half = width === undefined ? Infinity : 0.25 * width * petals;
  const degree = half < Math.PI / 2 ? Math.round(Math.LN2 / (2 * Math.abs(Math.log(Math.cos(half))))) : 0;
  return { degree, petals };
}

/** Whether there is a ring under the hand, or one is put there: the numbers of a named family move all of its wall. */
export function takesRings({ kind }: Shape): boolean {
  return kind === "rings" || kind === "boundary-value";
}
