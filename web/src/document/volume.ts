/** Volumes as jugs are marked with them. */

import { UNITS as MILLIMETRES } from "./tables.gen";
import type { Unit } from "./types";

/** Millilitres in a volume of this unit's cube. */
export function millilitres(value: number, unit: Unit): number {
  return (value * MILLIMETRES[unit] ** 3) / 1000;
}
