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
  if (typeof value === "function") return (...given: readonly unknown[]) => said(value as Say, given);
  if (Array.isArray(value)) return value.map(change);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, change(each)]));
}

type Say = (...given: readonly unknown[]) => unknown;

/** So many letters are a word, and no sign of a unit or of an equation. */
const WORD = /[a-z]{4}/i;

/** Signs that no text has, in the place of what a function is given while what it says is changed. */
const FIRST_SIGN = 0xe000;

/** What a function says: its own words are changed, and those that it was given stay as they came, so that it hides none that are not from the catalogue. */
function said(say: Say, given: readonly unknown[]): unknown {
  const kept: string[] = [];
  const hidden = (value: unknown): unknown => {
    if (Array.isArray(value)) return value.map(hidden);
    if (typeof value !== "string" || !WORD.test(value)) return value;
    kept.push(value);
    return String.fromCharCode(FIRST_SIGN + kept.length - 1);
  };
  return shown(change(say(...given.map(hidden))), kept);
}

function shown(value: unknown, kept: readonly string[]): unknown {
  if (typeof value === "string")
    return value.replace(/[\ue000-\uf8ff]/g, (sign) => kept[sign.charCodeAt(0) - FIRST_SIGN] ?? sign);
  if (Array.isArray(value)) return value.map((each) => shown(each, kept));
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, shown(each, kept)]));
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
