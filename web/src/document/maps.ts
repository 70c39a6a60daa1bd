/** The colour maps: what each shows, its unit, and its colours, told apart with every kind of colour vision. */

import { formatNumber } from "../number";
import type { MapName, Unit } from "./types";

export type Rgb = readonly [number, number, number];

export interface ColourMap {
  readonly name: MapName;
  readonly label: string;
  /** What its ends mean. */
  readonly note: string;
  /** Colours from least to greatest, evenly spaced, of the screen (sRGB, 0 to 255). */
  readonly ramp: readonly Rgb[];
  /** Whether the middle of the colours stands for 0. */
  readonly diverging: boolean;
  readonly needsWall: boolean;
}

/** From blue by a light grey to vermilion: below and above 0. */
const DIVERGING: readonly Rgb[] = [
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
    label: "Mean curvature",
    note: "Blue is hollow, orange bulges.",
    ramp: DIVERGING,
    diverging: true,
    needsWall: false,
  },
  {
    name: "gaussian-curvature",
    label: "Gaussian curvature",
    note: "Blue is a saddle, orange a dome.",
    ramp: DIVERGING,
    diverging: true,
    needsWall: false,
  },
  {
    name: "thickness",
    label: "Wall thickness",
    note: "Violet is thin, yellow thick.",
    ramp: RISING,
    diverging: false,
    needsWall: true,
  },
  {
    name: "overhang",
    label: "Overhang",
    note: "From upright, where it faces down, outside and inside: above 45° a printer needs support. What it stands on is grey.",
    ramp: RISING,
    diverging: false,
    needsWall: false,
  },
];

export function mapOf(name: MapName): ColourMap {
  return MAPS.find((map) => map.name === name) ?? (MAPS[0] as ColourMap);
}

export function mapUnit(name: MapName, unit: Unit): string {
  switch (name) {
    case "mean-curvature":
      return `/${unit}`;
    case "gaussian-curvature":
      return `/${unit}²`;
    case "thickness":
      return unit;
    case "overhang":
      return "°";
  }
}

/** A value of a map in words: "0.25 cm", "62°". */
export function mapWords(name: MapName, value: number, unit: Unit): string {
  const text = formatNumber(name === "overhang" ? Number(value.toFixed(1)) : value, 3);
  return name === "overhang" ? `${text}°` : `${text}\u00a0${mapUnit(name, unit)}`;
}

/** How a map is drawn on one pot. */
export interface Scale {
  readonly ramp: readonly Rgb[];
  /** What the ends of the colours stand for. */
  readonly low: number;
  readonly high: number;
  readonly note: string;
}

/**
 * The colours and what they stand for, on a pot whose values are nearly all from `low` to `high`. Colours with a middle have 0 there; where all values
 * are on one side of it, colours that rise tell more of them apart. The range is never empty.
 */
export function scaleOf(map: ColourMap, low: number, high: number): Scale {
  if (map.name === "overhang") return { ramp: map.ramp, low: 0, high: 90, note: map.note };
  if (map.diverging && low < 0 && high > 0) {
    const most = Math.max(-low, high);
    return { ramp: map.ramp, low: -most, high: most, note: map.note };
  }
  const ramp = map.diverging ? RISING : map.ramp;
  const note = map.diverging ? "Violet is least, yellow most." : map.note;
  if (high > low) return { ramp, low, high, note };
  const room = 0.5 * Math.abs(low || 1);
  return { ramp, low: low - room, high: high + room, note };
}
