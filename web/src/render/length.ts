/** What 1 means in a design. */
export type Unit = "mm" | "cm" | "in";

/**
 * A length in words: three significant digits, no trailing zeros, "12.4 cm". Very large and very small ones in powers of ten
 * ("2.5 × 10^6 mm"), so that they stay short.
 */
export function lengthText(length: number, unit: Unit): string {
  return `${numberText(length)} ${unit}`;
}

function numberText(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(3));
  if (size >= 1e-3 && Math.abs(rounded) < 1e5) return String(rounded).replace("-", "−");
  const [digits, power] = value.toExponential(2).split("e") as [string, string];
  return `${String(Number(digits)).replace("-", "−")} × 10^${Number(power)}`.replace("^-", "^−");
}
