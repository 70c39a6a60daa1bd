/** Writes formulas as LaTeX, numbers rounded to so many digits; numbers of the shape are marked, so that they can be found in what it is drawn as. */

import { type Amount, amountAt, decided } from "./amount";

/** A formula, as LaTeX. */
export interface Formula {
  readonly tex: string;
  /** What `\class{m0}{..}`, `\class{m1}{..}` and so on stand for: each the numbers of the shape that it is made of, as the solver names their places. */
  readonly marks: readonly (readonly string[])[];
}

/** How formulas are written. */
export interface Hand {
  /** How many digits a number has at most. */
  readonly digits: number;
  /** The decimal mark. */
  readonly decimal: string;
  /** Whether numbers are marked. */
  readonly marked: boolean;
  /** How many waves are written, of those of a coordinate. */
  readonly most: number;
}

/** With every digit of a document, for other programs. */
export const WHOLE: Hand = { digits: 12, decimal: ".", marked: false, most: Number.POSITIVE_INFINITY };

/** A factor and what it multiplies; the factor alone where that is nothing. */
export interface Term {
  readonly amount: Amount;
  readonly body: string;
  /** With more digits than others, where the sum takes them. */
  readonly digits?: number;
}

/** As few and as many as a double tells apart. */
const LEAST_DIGITS = 1;
const MOST_DIGITS = 17;

export class Writer {
  readonly hand: Hand;
  readonly #marks: (readonly string[])[] = [];
  /** Whether amounts are written as their symbols, where they have some. */
  #symbols = false;

  constructor(hand: Hand) {
    this.hand = hand;
  }

  formula(tex: string): Formula {
    return { tex, marks: this.#marks };
  }

  /** What is written with symbols instead of numbers. */
  symbols(write: () => string): string {
    this.#symbols = true;
    const tex = write();
    this.#symbols = false;
    return tex;
  }

  /** Whether a sum has a term for it. */
  says({ value, name }: Amount): boolean {
    return value !== 0 || (this.#symbols && name !== undefined);
  }

  /** A number that is not marked. Where there is a sign it stands before it. */
  plain(value: number, digits = this.hand.digits): string {
    const rounded = Number(value.toPrecision(Math.min(MOST_DIGITS, Math.max(LEAST_DIGITS, digits))));
    const sign = rounded < 0 ? "-" : "";
    const size = Math.abs(rounded);
    if (size === 0) return "0";
    const [mantissa = "0", power = "0"] = size.toExponential().split("e");
    const exponent = Number(power);
    const text = exponent >= -4 && exponent < 7 ? decimals(size) : mantissa;
    const local = text.replace(".", this.hand.decimal === "." ? "." : `{${this.hand.decimal}}`);
    return sign + (text === mantissa && exponent !== 0 ? `${local}\\cdot 10^{${exponent}}` : local);
  }

  /** The amount without its sign: its symbol where those are asked for. */
  amount(amount: Amount, digits?: number): string {
    if (this.#symbols && amount.name !== undefined) return this.#mark(amount, amount.name);
    return this.#mark(amount, this.plain(Math.abs(amount.value), digits));
  }

  /** A power of it, in brackets where it has a sign or is a product. */
  power(amount: Amount, exponent: number): string {
    const text = this.amount(amount);
    const isNegative = this.#isNegative(amount);
    const base = isNegative || text.includes("\\cdot") ? `\\left(${isNegative ? "-" : ""}${text}\\right)` : text;
    return `${base}^{${exponent}}`;
  }

  /** Terms with their signs. Numbers that are 0 are left out, and nothing at all is `0`. */
  sum(terms: readonly Term[], more = false): string {
    let text = "";
    for (const { amount, body, digits } of terms) {
      if (!this.says(amount)) continue;
      const isSum = this.#symbols && body !== "" && amount.name?.includes(" + ");
      const factor = isSum ? `\\left(${this.amount(amount, digits)}\\right)` : this.amount(amount, digits);
      const sign = this.#isNegative(amount) ? "-" : text === "" ? "" : "+";
      text += `${sign}${factor}${body === "" ? "" : `\\,${body}`}`;
    }
    if (more) text += text === "" ? "\\cdots" : "+\\cdots";
    return text === "" ? "0" : text;
  }

  #isNegative(amount: Amount): boolean {
    return amount.value < 0 && !(this.#symbols && amount.name !== undefined);
  }

  #mark(amount: Amount, text: string): string {
    if (!this.hand.marked || amount.at.length === 0) return text;
    this.#marks.push(amount.at);
    return `\\class{m${this.#marks.length - 1}}{${text}}`;
  }

  /** `cos(k v)` or `sin(k v)` with `k = 2 pi n / span`. */
  wave(wave: "cos" | "sin", n: Amount, span: "one" | "turn" | number): string {
    return `\\${wave}(${this.#angle(n, span)})`;
  }

  #angle(n: Amount, span: "one" | "turn" | number): string {
    const named = this.#symbols && n.name !== undefined;
    if (span === "one") return named ? `2\\pi\\,${this.amount(n)}\\,v` : `${this.#sized(n, 2)}\\pi v`;
    if (span === "turn") return n.value === 1 && !named ? this.#mark(n, "v") : `${this.#sized(n, 1)}\\,v`;
    const amount = decided(n.value / span, [n, amountAt(["span"], span)]);
    return `${this.#sized(amount, 2)}\\pi v`;
  }

  #sized(n: Amount, factor: number): string {
    const amount = { ...n, value: factor * n.value };
    return (this.#isNegative(amount) ? "-" : "") + this.amount(amount);
  }
}

/** In decimals, never with an exponent. */
function decimals(value: number): string {
  const text = String(value);
  if (!text.includes("e")) return text;
  return value.toFixed(20).replace(/0+$/, "");
}

/** Lines under each other, their `&` in one column. */
export function aligned(lines: readonly string[]): string {
  return `\\begin{aligned}${lines.join("\\\\")}\\end{aligned}`;
}
