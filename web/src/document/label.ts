/** Titles and names as the document takes them: plain text on one line, no longer than so many characters. */

import { LIMITS } from "./tables.gen";

/** White space and control characters, which are pasted and are in names of files, become a space. A surrogate pair counts as one character, as it does for the solver; half of one is none. */
export function labelOf(text: string, most: number = LIMITS.characters): string {
  return [...text.replace(/\p{Surrogate}/gu, "").replace(/[\s\p{Cc}]+/gu, " ").trimStart()].slice(0, most).join("");
}
