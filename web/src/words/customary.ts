/** Volumes and masses as they are measured in the United States, beside or in place of litres and kilograms where lengths are in inches. */

import type { Unit } from "../document/types";
import { millilitres } from "../document/volume";
import { customary } from "../document/volume-units";
import { formatNumber } from "../number";
import { quantities } from "./english/quantities";
import { type Shown, volumeWords } from "./quantities";

const GRAMS_PER_POUND = 453.59237;

/** "11.2 US fl oz", from a pint on in pints and from a gallon on in gallons; from millilitres. */
export function customaryWords(volume: number, digits = 3): string {
  const { value, unit } = customary(volume);
  return quantities.measured(formatNumber(value, digits), quantities.customary[unit]);
}

/** A volume as it is measured where lengths are in this unit. */
export function localVolumeWords(value: number, unit: Unit, digits?: number): string {
  return unit === "in" ? customaryWords(millilitres(value, unit), digits) : volumeWords(value, unit, digits);
}

/** From grams. */
export function poundsShown(): Shown {
  return { factor: 1 / GRAMS_PER_POUND, unit: quantities.pounds };
}
