/** Units of volume that people type and read. */

import { parseAmount, type Typed, withoutUnit } from "../number";
import type { Unit } from "./types";

/** Millilitres; ounces, cups, pints, quarts and gallons are those of the United States. */
const MILLILITRES = {
  ml: 1,
  cl: 10,
  dl: 100,
  l: 1000,
  "fl oz": 29.5735295625,
  pt: 473.176473,
  qt: 946.352946,
  gal: 3785.411784,
  cup: 236.5882365,
};
type VolumeUnit = keyof typeof MILLILITRES;

const VOLUME =
  /^(.*?)(?:U\.?S\.?\s*)?(millilit(?:er|re)s?|lit(?:er|re)s?|(?:fl\.?|fluid)\s*(?:oz\.?|ounces?)|oz\.?|ounces?|pints?|pt\.?|quarts?|qt\.?|gallons?|gal\.?|cups?|cm3|cm³|cc|ml|cl|dl|l)?$/i;

/** Reads a typed volume in millilitres; a number alone is in `unit`. */
export function parseVolume(text: string, unit: "ml" | "l" | "fl oz"): Typed {
  const [, amount = "", written = unit] = VOLUME.exec(text.trim()) ?? [];
  const typed = parseAmount(amount);
  if ("problem" in typed) return withoutUnit(text, "no-volume");
  const value = typed.value * MILLILITRES[volumeUnitOf(written.toLowerCase())];
  return Number.isFinite(value) ? { value } : { problem: { code: "too-large" } };
}

function volumeUnitOf(word: string): VolumeUnit {
  if (word in MILLILITRES) return word as VolumeUnit;
  if (/oz|ounce/.test(word)) return "fl oz";
  if (word.startsWith("p")) return "pt";
  if (word.startsWith("q")) return "qt";
  if (word.startsWith("g")) return "gal";
  if (word.startsWith("cup")) return "cup";
  return /^[mc]/.test(word) ? "ml" : "l";
}

/** In what a capacity is asked for where lengths are in this unit, and how many millilitres that is. */
export function capacityUnit(unit: Unit): { readonly name: "ml" | "fl oz"; readonly millilitres: number } {
  const name = unit === "in" ? "fl oz" : "ml";
  return { name, millilitres: MILLILITRES[name] };
}

/** What a volume in millilitres is in measures of the United States: in ounces, from a pint on in pints, from a gallon on in gallons. */
export function customary(millilitres: number): {
  readonly value: number;
  readonly unit: "ounce" | "pint" | "gallon";
} {
  const { "fl oz": ounce, pt: pint, gal: gallon } = MILLILITRES;
  if (Math.abs(millilitres) < pint) return { value: millilitres / ounce, unit: "ounce" };
  if (Math.abs(millilitres) < gallon) return { value: millilitres / pint, unit: "pint" };
  return { value: millilitres / gallon, unit: "gallon" };
}
