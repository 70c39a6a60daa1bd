/** Lengths than which something is no larger. */

import type { Unit } from "../document/types";
import { spokenLength } from "./quantities";

/** More digits of how far off something is are of no use. */
const DIGITS = 2;

/** A bound as a person reads it: in two digits, and no less than it is. */
export function boundWords(value: number, unit: Unit): string {
  return spokenLength(upwards(value), unit, DIGITS);
}

/** The least number of two digits that is not below this, but for the dust of decimal fractions. */
function upwards(value: number): number {
  const near = Number(value.toPrecision(DIGITS));
  if (near >= value) return near;
  const [, power = "0"] = near.toExponential(DIGITS - 1).split("e");
  return near + 10 ** (Number(power) - DIGITS + 1);
}
