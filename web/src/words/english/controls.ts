/** What a page is made of: dialogues, and fields of numbers. */

import { phrases } from "../../language";
import type { NumberProblem } from "../../number";

export const controls = phrases("controls", {
  close: "Close",
  /** What sets a number apart from others of the same name. */
  qualified: (label: string, qualifier: string) => `${label}, ${qualifier}`,
  resetTo: (name: string, number: string) => `Reset ${name} to ${number}, as opened`,
  setToPaper: (name: string, number: string) => `Set ${name} to ${number}, as in the paper`,
  /** What a field says that has no number yet. */
  blank: "none",
  positive: "Type a number above 0.",
  within: (counted: boolean, least: string, most: string) =>
    `Type a ${counted ? "whole " : ""}number from ${least} to ${most}.`,
  /** Why what was typed is no number. */
  typed: {
    empty: () => "Type a number.",
    "no-number": (typed: string) => `“${typed}” is not a number.`,
    "no-length": (typed: string) => `“${typed}” is no length in mm, cm, m, in or ft.`,
    "no-volume": (typed: string) => `“${typed}” is no volume in ml, l, fl oz, pt, qt, gal or cups.`,
    "too-large": () => "This number is too large.",
  } satisfies Readonly<Record<NumberProblem["code"], (typed: string) => string>>,
});
