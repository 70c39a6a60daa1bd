/** The language that the page speaks: its tag, its words, and numbers, plurals and lists as `Intl` forms them in it. */

export interface Language {
  /** After BCP 47. */
  readonly tag: string;
  /** What this language says in place of the English words of a room. */
  readonly say: <T extends object>(room: string, english: T) => T;
}

export const ENGLISH: Language = { tag: "en", say: (_room, english) => english };

let current = ENGLISH;
let kept = new Map<string, unknown>();

/** From here on everything is said in this language. It is chosen once, before anything is shown. */
export function speak(language: Language): void {
  current = language;
  kept = new Map();
}

export function spokenTag(): string {
  return current.tag;
}

/** The words of a room, in whichever language is spoken when one of them is read. */
export function phrases<T extends object>(room: string, english: T): T {
  return new Proxy(english, { get: (_, key) => Reflect.get(current.say(room, english), key) });
}

/** What `Intl` needs long to make is made once. */
function once<T>(key: string, make: () => T): T {
  const known = kept.get(key) as T | undefined;
  if (known !== undefined) return known;
  const made = make();
  kept.set(key, made);
  return made;
}

/** A number with so many significant digits, ungrouped, with the mark and the minus sign of the language. */
export function decimal(value: number, digits: number): string {
  const format = once(
    `decimal ${digits}`,
    () =>
      new Intl.NumberFormat(current.tag, {
        useGrouping: false,
        maximumSignificantDigits: digits,
        // What is shown can be typed again.
        numberingSystem: "latn",
      }),
  );
  return format.format(value).replace("-", "\u2212");
}

/** A count with its groups of thousands: "1,234". */
export function grouped(count: number): string {
  return once("grouped", () => new Intl.NumberFormat(current.tag)).format(count);
}

/** A day and a time of it: "Nov 23, 2026, 2:05 PM". */
export function moment(at: number): string {
  const format = once(
    "moment",
    () => new Intl.DateTimeFormat(current.tag, { dateStyle: "medium", timeStyle: "short" }),
  );
  return format.format(at);
}

/** The form of a word that goes with a count. A language names those of its forms that differ from `other`. */
export function plural(
  count: number,
  forms: Partial<Readonly<Record<Intl.LDMLPluralRule, string>>> & { other: string },
): string {
  const rule = once("plural", () => new Intl.PluralRules(current.tag)).select(count);
  return forms[rule] ?? forms.other;
}

/** "a, b, and c" */
export function listed(items: readonly string[]): string {
  return once("list", () => new Intl.ListFormat(current.tag, { type: "conjunction" })).format(items);
}

/** "a, b, or c" */
export function either(items: readonly string[]): string {
  return once("either", () => new Intl.ListFormat(current.tag, { type: "disjunction" })).format(items);
}

/** Writing from right to left, and marks that turn the direction of what follows them. */
const TURNS =
  /[\u0590-\u08ff\u200e\u200f\u202a-\u202e\u2066-\u2069\ufb1d-\ufdff\ufe70-\ufefc]|[\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;

/** Foreign text inside a sentence: whatever direction it has, or marks in it turn to, ends with it. What cannot turn anything is left as it is. */
export function isolated(text: string): string {
  return TURNS.test(text) ? `\u2068${text.replace(/[\u2066-\u2069]/g, "")}\u2069` : text;
}
