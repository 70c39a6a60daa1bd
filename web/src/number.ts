/** Numbers as people type and read them. */

import { decimal } from "./language";

/** Why what was typed is no number. */
export type NumberProblem =
  | { readonly code: "empty" | "too-large" }
  | { readonly code: "no-number" | "no-length" | "no-volume"; readonly typed: string };

export type Typed = { readonly value: number } | { readonly problem: NumberProblem };

const DECIMAL = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;
const DIGITS_SHOWN = 6;

/**
 * Reads a typed number: decimal comma or point, spaces of any kind, the real minus sign, exponents
 * (`1e-3`, `1,5 × 10^-3`). Two marks are read as grouping only when they cannot be anything else (`1,234.5`), a raised comma before three digits (`12'000`).
 */
export function parseNumber(text: string): Typed {
  let plain = withPlainMinus(text).replace(/(\d)['’](?=\d{3}(?!\d))|[\s_]/g, "$1");
  if (plain === "") return { problem: { code: "empty" } };
  plain = plain.replace(/[×x*]10\^?/i, "e");
  const comma = plain.lastIndexOf(",");
  const point = plain.lastIndexOf(".");
  if (comma >= 0 && point >= 0) {
    const [group, mark] = comma > point ? [".", ","] : [",", "."];
    plain = plain.split(group).join("").replace(mark, ".");
  } else if (comma >= 0) {
    plain = plain.replace(",", ".");
  }
  if (!DECIMAL.test(plain)) return { problem: { code: "no-number", typed: shortened(text) } };
  const value = Number(plain);
  if (!Number.isFinite(value)) return { problem: { code: "too-large" } };
  return { value: value === 0 ? 0 : value };
}

const MILLIMETRES: Readonly<Record<string, number>> = { mm: 1, cm: 10, m: 1000, in: 25.4, ft: 304.8 };

/** What people write behind a length. */
const LENGTH =
  /^(.*?)(millimet(?:er|re)s?|centimet(?:er|re)s?|met(?:er|re)s?|inch(?:es)?|feet|foot|mm|cm|m|in\.?|ft\.?|″|"|′|')?$/i;

/** Feet and inches, whose mark may be left out. */
const FEET = /^([+-]?)(\d+)\s*(?:feet|foot|ft\.?|′|'|’)\s*([\d.,½¼¾].*?)\s*(inch(?:es)?|in\.?|″|"|”|'')?$/i;

const FRACTION = /^([+-]?)(?:(\d+)\s+)?(\d+)\s*[/\u2044]\s*(\d+)$/;

/**
 * Reads a typed length in a unit (`mm`, `cm` or `in`): a number as {@link parseNumber} reads it or a fraction (`1/2`, `1 1/2`), and behind it any unit of length, from which it is
 * converted. Without one it is in `unit`. Feet may have inches behind them (`5 ft 10 in`, `5'10"`).
 */
export function parseLength(text: string, unit: string): Typed {
  const own = MILLIMETRES[unit];
  const [, sign, feet, rest = "", mark] = FEET.exec(withPlainMinus(text)) ?? [];
  // 12'000 is a number.
  if (own !== undefined && feet !== undefined && (mark !== undefined || !/^\d{3}(\D|$)/.test(rest))) {
    const inches = parseAmount(rest);
    if ("value" in inches) return converted((sign === "-" ? -1 : 1) * (12 * Number(feet) + inches.value), "in", own);
  }
  const [, amount = "", written] = LENGTH.exec(text.trim()) ?? [];
  const typed = parseAmount(amount);
  // A sentence that ends in m is no length: it is named as it was typed.
  if (own === undefined) return parseAmount(text);
  if ("problem" in typed) return withoutUnit(text, "no-length");
  return written === undefined ? typed : converted(typed.value, unitOf(written), own);
}

/** A number and a word behind it. */
const IN_UNIT = /^(.*[\d.½¼¾])\s*\p{L}+\.?$/u;

/** What was typed without a unit of its kind: a number all the same, or why it is none. With another unit behind a number it is of another kind. */
export function withoutUnit(text: string, code: "no-length" | "no-volume"): Typed {
  const [, amount] = IN_UNIT.exec(text.trim()) ?? [];
  const isOther = amount !== undefined && "value" in parseAmount(amount);
  return isOther ? { problem: { code, typed: shortened(text) } } : parseAmount(text);
}

/** A length in a unit, in one of so many millimetres. */
function converted(length: number, unit: string, own: number): Typed {
  const value = (length * (MILLIMETRES[unit] ?? own)) / own;
  if (!Number.isFinite(value)) return { problem: { code: "too-large" } };
  return { value: Number(value.toPrecision(CONVERTED_DIGITS)) };
}

/** Digits that a conversion keeps: those of a document. */
const CONVERTED_DIGITS = 12;

function unitOf(written: string): string {
  const word = written.toLowerCase();
  if (word.startsWith("mi") || word === "mm") return "mm";
  if (word.startsWith("c")) return "cm";
  if (word.startsWith("m")) return "m";
  return /^(f|′|')/.test(word) ? "ft" : "in";
}

/** Fractions that are one letter. */
const LETTERS: Readonly<Record<string, string>> = { "½": "1/2", "¼": "1/4", "¾": "3/4" };

/** A number as {@link parseNumber} reads it, or a fraction (`1/2`, `1 1/2`, `1½`). */
export function parseAmount(text: string): Typed {
  const plain = withPlainMinus(text).replace(/(\d?)\s*([½¼¾])/g, (_, digit: string, letter: string) =>
    `${digit} ${LETTERS[letter]}`.trim(),
  );
  const [, sign = "", whole = "0", part, of] = FRACTION.exec(plain) ?? [];
  if (part === undefined || Number(of) === 0) return parseNumber(text);
  const size = Number(whole) + Number(part) / Number(of);
  return { value: sign === "-" ? -size : size };
}

/** With the plain minus sign in place of others. */
function withPlainMinus(text: string): string {
  return text.trim().replace(/[\u2212\u2013\uff0d]/g, "-");
}

function shortened(text: string): string {
  const trimmed = text.trim();
  return trimmed.length > 24 ? `${trimmed.slice(0, 23)}…` : trimmed;
}

/** A number for a text field: as short as six digits allow, never in exponent form unless it must be. */
export function formatNumber(value: number, digits = DIGITS_SHOWN): string {
  if (value === 0) return "0";
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size >= 1e-6 && size < 1e9) return decimal(rounded, digits);
  const [mantissa = "0", power = "0"] = rounded.toExponential().split("e");
  return `${decimal(Number(mantissa), digits)}e${decimal(Number(power), digits)}`;
}

/** `value` moved by `steps` whole steps and freed of the dust that binary fractions leave. */
export function stepped(value: number, step: number, steps: number): number {
  const moved = value + step * steps;
  const places = Math.max(0, Math.min(12, Math.ceil(-Math.log10(step)) + 2));
  return Number(moved.toFixed(places));
}
