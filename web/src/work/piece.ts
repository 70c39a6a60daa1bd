/** Something that the maker made of a design. */

import type { Design, Refusal } from "../document/types";

/** What was made last, and of what. */
export interface Piece<T> {
  readonly value: T | null;
  readonly of: Design | null;
  /** Why there is none. */
  readonly problem: Refusal | null;
  /** What the value was asked with besides the design. */
  readonly key: string;
}

export const NOTHING: Piece<never> = { value: null, of: null, problem: null, key: "" };

/** The key of what is made under the hand. */
export const QUICK = "quick";
