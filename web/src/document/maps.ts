/** The colour maps: what each shows and its colours, told apart with every kind of colour vision. */

import type { MapName } from "./types";

export type Rgb = readonly [number, number, number];

export interface ColourMap {
  readonly name: MapName;
  /** Colours from least to greatest, evenly spaced, of the screen (sRGB, 0 to 255). */
  readonly ramp: readonly Rgb[];
  /** Whether the middle of the colours stands for 0. */
  readonly diverging: boolean;
  readonly needsWall: boolean;
}

/** From blue by a light grey to vermilion: below and above 0. */
export const DIVERGING: readonly Rgb[] = [
  [20, 78, 140],
  [90, 160, 205],
  [236, 234, 228],
  [232, 146, 84],
  [166, 54, 15],
];

/** From dark to light in even steps (after viridis). */
const RISING: readonly Rgb[] = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];

export const MAPS: readonly ColourMap[] = [
  {
    name: "mean-curvature",
    ramp: DIVERGING,
    diverging: true,
    needsWall: false,
  },
  {
    name: "gaussian-curvature",
    ramp: DIVERGING,
    diverging: true,
    needsWall: false,
  },
  {
    name: "thickness",
    ramp: RISING,
    diverging: false,
    needsWall: true,
  },
  {
    name: "overhang",
    ramp: RISING,
    diverging: false,
    needsWall: false,
  },
];

export function mapOf(name: MapName): ColourMap {
  return MAPS.find((map) => map.name === name) ?? (MAPS[0] as ColourMap);
}

/** The colour of a share of the range, between those of the ramp; what is beyond it has the colour of its end. */
export function colourAt(ramp: readonly Rgb[], share: number): Rgb {
  const place = Math.min(1, Math.max(0, share)) * (ramp.length - 1);
  const before = Math.min(Math.floor(place), ramp.length - 2);
  const [one, other] = [ramp[before] as Rgb, ramp[before + 1] as Rgb];
  const mixed = (i: 0 | 1 | 2) => Math.round(one[i] + (place - before) * (other[i] - one[i]));
  return [mixed(0), mixed(1), mixed(2)];
}

/** How a map is drawn on one pot. */
export interface Scale {
  readonly ramp: readonly Rgb[];
  /** What the ends of the colours stand for. */
  readonly low: number;
  readonly high: number;
  /** Whether the colours of this map were taken, or, of one with a middle, those that rise. */
  readonly rises: boolean;
}

/**
 * The colours and what they stand for, on a pot whose values are nearly all from `low` to `high`. Colours with a middle have 0 there; where all values
 * are on one side of it, colours that rise tell more of them apart. The range is never empty.
 */
export function scaleOf(
  map: Pick<ColourMap, "ramp" | "diverging"> & { readonly name?: MapName },
  low: number,
  high: number,
): Scale {
  if (map.name === "overhang") return { ramp: map.ramp, low: 0, high: 90, rises: false };
  if (map.diverging && low < 0 && high > 0) {
    const most = Math.max(-low, high);
    return { ramp: map.ramp, low: -most, high: most, rises: false };
  }
  const ramp = map.diverging ? RISING : map.ramp;
  const rises = map.diverging;
  if (high > low) return { ramp, low, high, rises };
  const room = 0.5 * Math.abs(low || 1);
  return { ramp, low: low - room, high: high + room, rises };
}
