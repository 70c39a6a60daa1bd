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

/** What is counted, in sentences. */
export function countedWords({ pot, allowance }: Wedging, unit: Unit): readonly string[] {
  const own = clayWords(pot, unit);
  const counted = allowance > 0 ? said.counted(own, clayWords(allowance, unit)) : said.countedPot(own);
  return [counted, said.density(formatNumber(WET_DENSITY))];
}
