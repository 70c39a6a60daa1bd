/** Numbers of the workbench as people read them: lengths, areas, volumes, masses and angles with their units. */

import type { Unit } from "../document/types";
import { millilitres } from "../document/volume";
import { formatNumber } from "../number";
import { quantities } from "./english/quantities";

/** Digits that a person reads; the error tells how many more are known. */
const DIGITS = 4;

/** From here on, rounded to whole numbers, the larger unit is shorter. */
const THOUSAND = 999.5;

/** How a measure is shown: by what it is multiplied, and the unit that it has then. */
export interface Shown {
  readonly factor: number;
  readonly unit: string;
}

export function lengthWords(value: number, unit: Unit, digits = DIGITS): string {
  return words(value, lengthShown(unit), digits);
}

export function lengthShown(unit: Unit): Shown {
  return { factor: 1, unit: quantities.units[unit] };
}

/** The same inside a sentence, which may break between number and unit. */
export function spokenLength(value: number, unit: Unit, digits = DIGITS): string {
  return quantities.spoken(formatNumber(value, digits), quantities.units[unit]);
}

export function areaShown(unit: Unit): Shown {
  return { factor: 1, unit: quantities.squares[unit] };
}

export function areaWords(value: number, unit: Unit): string {
  return words(value, areaShown(unit));
}

/** In ml below a litre, else in l: what jugs are marked with, whatever the unit of the design. */
export function volumeShown(value: number, unit: Unit): Shown {
  const factor = millilitres(1, unit);
  return Math.abs(value * factor) < THOUSAND
    ? { factor, unit: quantities.millilitres }
    : { factor: factor / 1000, unit: quantities.litres };
}

export function volumeWords(value: number, unit: Unit, digits = DIGITS): string {
  return words(value, volumeShown(value, unit), digits);
}

/** From grams. */
export function massShown(grams: number): Shown {
  return Math.abs(grams) < THOUSAND
    ? { factor: 1, unit: quantities.grams }
    : { factor: 0.001, unit: quantities.kilograms };
}

/** A number with its unit, which does not leave it at the end of a line. */
export function words(value: number, { factor, unit }: Shown, digits = DIGITS): string {
  return quantities.measured(formatNumber(value * factor, digits), unit);
}

export function angleWords(degrees: number): string {
  return quantities.angle(formatNumber(Number(degrees.toFixed(1))));
}

/** An angle inside a sentence that may be read aloud. */
export function degreesWords(degrees: number): string {
  const rounded = Math.round(degrees);
  return quantities.degrees(rounded, formatNumber(rounded));
}

/** A direction, counted from 0° until `turn` comes back to it: one that is nearly all the way round is 0°, and not 360°. */
export function directionWords(degrees: number, turn: number): string {
  const rounded = Number(degrees.toFixed(1));
  return angleWords(rounded >= turn ? rounded - turn : rounded);
}

const GAP = "\u00a0";
const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** "± 3 × 10⁻¹³", rounded up, because it is a promise; nothing where nothing is known. */
export function errorWords(error: number): string {
  if (!Number.isFinite(error) || error < 0) return "";
  if (error === 0) return quantities.exact;
  const power = Math.floor(Math.log10(error));
  const digit = Math.ceil(error / 10 ** power - 1e-9);
  const [shown, exponent] = digit === 10 ? [1, power + 1] : [digit, power];
  if (exponent >= -3 && exponent <= 2) return quantities.within(formatNumber(shown * 10 ** exponent, 1));
  const raised = [...String(Math.abs(exponent))].map((each) => SUPERSCRIPT[Number(each)]).join("");
  return quantities.within(`${shown === 1 ? "" : `${shown}${GAP}×${GAP}`}10${exponent < 0 ? "⁻" : ""}${raised}`);
}
