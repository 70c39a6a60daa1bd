/** The values of the colour maps in words. */

import type { Scale } from "../document/maps";
import type { MapName, Unit } from "../document/types";
import { formatNumber } from "../number";
import { maps } from "./english/maps";
import { quantities } from "./english/quantities";

const DIGITS = 3;

/** A value of a map: "0.25 cm", "62°". */
export function mapWords(name: MapName, value: number, unit: Unit): string {
  if (name === "overhang") return quantities.angle(formatNumber(Number(value.toFixed(1)), DIGITS));
  const units = {
    "mean-curvature": quantities.bent,
    "gaussian-curvature": quantities.bentTwice,
    thickness: quantities.units,
  };
  return quantities.measured(formatNumber(value, DIGITS), units[name][unit]);
}

/** What the colours mean. */
export function mapNote(name: MapName, scale?: Scale): string {
  return scale?.rises ? maps.rises : maps.notes[name];
}
