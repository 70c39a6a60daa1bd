/** The list of parts. */

import { phrases } from "../../language";
import { formatNumber } from "../../number";

export const parts = phrases("parts", {
  heading: "Parts",
  keys: "Arrow keys select, with Alt they move the part up or down. D makes a copy, H hides the part or shows it, Delete takes it away, F2 names it.",
  /** Behind the name of a part, for whoever hears it. */
  isHidden: ", hidden",
  show: "Show",
  hide: "Hide",
  name: "Name of the part",
  gluedTo: "Glued to",
  nothing: "nothing",
  /** Behind the name of a part where there are several objects, counted from 1. */
  object: (number: number) => `Object ${formatNumber(number)}`,
  up: "Move up",
  down: "Move down",
  duplicate: "Duplicate",
  delete: "Delete",
  taken: "Another part has this name.",
  tooMany: (most: number) => `A design has at most ${formatNumber(most)} parts.`,
  notAdded: "It could not be drawn, so it was not added.",
});
