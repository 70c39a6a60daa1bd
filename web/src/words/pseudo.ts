/**
 * English with every letter changed and every text in brackets, derived from the English words alone: what is shown unchanged did not come from the catalogue. A browser test asks for it by
 * `?lang=en-XA`, the tag that Android and ICU have for it.
 */

import type { Language } from "../language";

const PLAIN = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
const CHANGED = "åƀçðéƒĝĥîĵķļɱñöþǫŕšţûṽŵẋýžÅƁÇÐÉƑĜĤÎĴĶĻṀÑÖÞǪŔŠŢÛṼŴẊÝŽ";
const LETTERS = new Map([...PLAIN].map((letter, index) => [letter, [...CHANGED][index] ?? letter]));

/** A text with its letters changed. Places to be filled in (`{0}`) have none. */
export function marked(text: string): string {
  return text === "" ? "" : `⟦${[...text].map((letter) => LETTERS.get(letter) ?? letter).join("")}⟧`;
}

/** The same of all that is in there, and of what its functions say. */
export function markedAll<T>(words: T): T {
  return change(words) as T;
}

function change(value: unknown): unknown {
  if (typeof value === "string") return marked(value);
  if (typeof value === "function") return (...given: readonly unknown[]) => change(value(...given));
  if (Array.isArray(value)) return value.map(change);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, change(each)]));
}

const known = new WeakMap<object, unknown>();

export const PSEUDO_ENGLISH: Language = {
  tag: "en-XA",
  say: <T extends object>(_room: string, english: T) => {
    const there = known.get(english) ?? markedAll(english);
    known.set(english, there);
    return there as T;
  },
};
