/** A number of the problem, with where in the shape it comes from and what the papers call it. */

import { type Path, pathText } from "../document/path";

export interface Amount {
  readonly value: number;
  /** The numbers of the shape that it is made of, each as the solver names its place. */
  readonly at: readonly string[];
  /** Its symbol, as LaTeX. */
  readonly name?: string;
}

export const NOTHING: Amount = { value: 0, at: [] };
export const ONE: Amount = { value: 1, at: [] };

/** The number at a place of the shape. */
export function amountAt(path: Path, value: number, name?: string): Amount {
  return { value, at: [pathText(path)], ...(name === undefined ? {} : { name }) };
}

/** Another number that these decide. */
export function decided(value: number, by: readonly Amount[], name?: string): Amount {
  const at = [...new Set(by.flatMap((each) => each.at))];
  return { value, at, ...(name === undefined ? {} : { name }) };
}

export function scaled(amount: Amount, factor: number): Amount {
  return { value: factor * amount.value, at: amount.at };
}

/** The sum, which has no symbol of its own. */
export function added(one: Amount, other: Amount): Amount {
  return decided(one.value + other.value, [one, other]);
}
