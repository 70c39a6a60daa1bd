/** Numbers as people type and read them. */

export type Typed = { readonly value: number } | { readonly problem: string };

const DECIMAL = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;
const DIGITS_SHOWN = 6;

/**
 * Reads a typed number: decimal comma or point, spaces of any kind, the real minus sign, exponents
 * (`1e-3`, `1,5 × 10^-3`). Two marks are read as grouping only when they cannot be anything else (`1,234.5`).
 */
export function parseNumber(text: string): Typed {
  let plain = text.replace(/[\s\u00a0\u202f\u2009'’_]/g, "").replace(/[\u2212\u2013\uff0d]/g, "-");
  if (plain === "") return { problem: "Type a number." };
  plain = plain.replace(/[×x*]10\^?/i, "e");
  const comma = plain.lastIndexOf(",");
  const point = plain.lastIndexOf(".");
  if (comma >= 0 && point >= 0) {
    const [group, mark] = comma > point ? [".", ","] : [",", "."];
    plain = plain.split(group).join("").replace(mark, ".");
  } else if (comma >= 0) {
    plain = plain.replace(",", ".");
  }
  if (!DECIMAL.test(plain)) return { problem: `“${shortened(text)}” is not a number.` };
  const value = Number(plain);
  if (!Number.isFinite(value)) return { problem: "This number is too large." };
  return { value: value === 0 ? 0 : value };
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
  const text = size >= 1e-6 && size < 1e9 ? String(rounded) : rounded.toExponential().replace(/e\+?(-?)/, "e$1");
  return text.replace("-", "\u2212").replace("e-", "e\u2212");
}

/** `value` moved by `steps` whole steps and freed of the dust that binary fractions leave. */
export function stepped(value: number, step: number, steps: number): number {
  const moved = value + step * steps;
  const places = Math.max(0, Math.min(12, Math.ceil(-Math.log10(step)) + 2));
  return Number(moved.toFixed(places));
}
