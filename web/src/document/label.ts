/** Titles and names as the document takes them: plain text on one line, no longer than so many characters. */

import { LIMITS } from "./tables.gen";

/** White space and control characters, which are pasted and are in names of files, become a space, and so does half of a surrogate pair; a whole one counts as one character, as it does for the solver. */
export function labelOf(text: string, most: number = LIMITS.characters): string {
  return [...text.replace(/[\s\p{Cc}\p{Surrogate}]+/gu, " ").trimStart()].slice(0, most).join("");
}
