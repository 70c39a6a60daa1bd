/** Lengths beside the lines that show them. */

import type { Unit } from "../document/types";
import { decimal } from "../language";
import { quantities } from "./english/quantities";

const DIGITS = 3;

/** From here on, and below, in powers of ten, so that labels stay short. */
const MOST = 1e5;
const LEAST = 1e-3;

/**
 * A length in words: three significant digits, no trailing zeros, "12.4 cm". Very large and very small ones in powers of ten
 * ("2.5 × 10^6 mm").
 */
export function lengthLabel(length: number, unit: Unit): string {
  return quantities.spoken(numberText(length), quantities.units[unit]);
}

/** The same for one unit: as long as it is the same unit it is the same function. */
export const LENGTH_LABELS: Readonly<Record<Unit, (length: number) => string>> = {
  mm: (length) => lengthLabel(length, "mm"),
  cm: (length) => lengthLabel(length, "cm"),
  in: (length) => lengthLabel(length, "in"),
};

function numberText(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(DIGITS));
  if (size >= LEAST && Math.abs(rounded) < MOST) return decimal(rounded, DIGITS);
  const [digits, power] = value.toExponential(DIGITS - 1).split("e") as [string, string];
  return `${decimal(Number(digits), DIGITS)} × 10^${decimal(Number(power), DIGITS)}`;
}
