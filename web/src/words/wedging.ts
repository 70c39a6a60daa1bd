/** Masses of wet clay as a potter weighs them. */

import type { Unit } from "../document/types";
import type { Wedging } from "../document/wedging";
import { WET_DENSITY } from "../document/wedging";
import { formatNumber } from "../number";
import { poundsShown } from "./customary";
import { wedging as said } from "./english/wedging";
import { massShown, words } from "./quantities";

/** Nobody weighs clay closer than this. */
const DIGITS = 3;

/** Pounds where lengths are in inches. */
export function clayWords(grams: number, unit: Unit): string {
  const shown = unit === "in" ? poundsShown() : massShown(grams);
  return words(grams, shown, DIGITS);
}

/** What is counted, in sentences. `fired` is the mass of the fired pot, in grams: no clay gains any in the kiln. */
export function countedWords({ pot, allowance }: Wedging, fired: number, unit: Unit): readonly string[] {
  const own = clayWords(pot, unit);
  const counted = allowance > 0 ? said.counted(own, clayWords(allowance, unit)) : said.countedPot(own);
  const gains = pot < fired ? [said.gains(clayWords(fired, unit))] : [];
  return [...gains, counted, said.density(formatNumber(WET_DENSITY))];
}
