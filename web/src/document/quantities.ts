/** Numbers of the workbench as people read them: lengths, areas, volumes, masses and angles with their units. */

import { formatNumber } from "../number";
import { UNITS as MILLIMETRES } from "./tables.gen";
import type { Unit } from "./types";

/** Digits that a person reads; the error tells how many more are known. */
const DIGITS = 4;

/** From here on, rounded to whole numbers, the larger unit is shorter. */
const THOUSAND = 999.5;

/** A space that does not break, between a number and its unit. */
const GAP = "\u00a0";

/** How a measure is shown: by what it is multiplied, and the unit that it has then. */
export interface Shown {
  readonly factor: number;
  readonly unit: string;
}

export function lengthWords(value: number, unit: Unit, digits = DIGITS): string {
  return words(value, { factor: 1, unit }, digits);
}

export function areaShown(unit: Unit): Shown {
  return { factor: 1, unit: `${unit}²` };
}

export function areaWords(value: number, unit: Unit): string {
  return words(value, areaShown(unit));
}

/** Millilitres in a volume of this unit's cube. */
export function millilitres(value: number, unit: Unit): number {
  return (value * MILLIMETRES[unit] ** 3) / 1000;
}

/** In ml below a litre, else in l: what jugs are marked with, whatever the unit of the design. */
export function volumeShown(value: number, unit: Unit): Shown {
  const factor = millilitres(1, unit);
  return Math.abs(value * factor) < THOUSAND ? { factor, unit: "ml" } : { factor: factor / 1000, unit: "l" };
}

export function volumeWords(value: number, unit: Unit, digits = DIGITS): string {
  return words(value, volumeShown(value, unit), digits);
}

/** From grams. */
export function massShown(grams: number): Shown {
  return Math.abs(grams) < THOUSAND ? { factor: 1, unit: "g" } : { factor: 0.001, unit: "kg" };
}

/** A number with its unit, which does not leave it at the end of a line. */
export function words(value: number, { factor, unit }: Shown, digits = DIGITS): string {
  return `${formatNumber(value * factor, digits)}${GAP}${unit}`;
}

export function angleWords(degrees: number): string {
  return `${formatNumber(Number(degrees.toFixed(1)))}°`;
}

/** An angle inside a sentence that may be read aloud. */
export function degreesWords(degrees: number): string {
  const rounded = Math.round(degrees);
  return `${formatNumber(rounded)} ${Math.abs(rounded) === 1 ? "degree" : "degrees"}`;
}

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** "± 3 × 10⁻¹³", rounded up, because it is a promise; nothing where nothing is known. */
export function errorWords(error: number): string {
  if (!Number.isFinite(error) || error < 0) return "";
  if (error === 0) return "exact";
  const power = Math.floor(Math.log10(error));
  const digit = Math.ceil(error / 10 ** power - 1e-9);
  const [shown, exponent] = digit === 10 ? [1, power + 1] : [digit, power];
  if (exponent >= -3 && exponent <= 2) return `±${GAP}${formatNumber(shown * 10 ** exponent, 1)}`;
  const raised = [...String(Math.abs(exponent))].map((each) => SUPERSCRIPT[Number(each)]).join("");
  return `±${GAP}${shown === 1 ? "" : `${shown}${GAP}×${GAP}`}10${exponent < 0 ? "⁻" : ""}${raised}`;
}
