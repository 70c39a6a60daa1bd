/** The list of what lies under a point of the stage. */

import { phrases } from "../../language";

export const under = phrases("under", {
  heading: "What lies here",
  looking: "Looking…",
  nothing: "Nothing lies here.",
  keys: "From front to back. Arrow keys choose, Enter selects, with Shift besides the others, Escape closes.",
  /** Behind the name of a part: how far behind the first. */
  behind: (length: string) => `${length} behind`,
});
