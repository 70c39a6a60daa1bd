/** The list of parts. */

import { phrases, plural } from "../../language";
import { formatNumber } from "../../number";

export const parts = phrases("parts", {
  heading: "Parts",
  keys: "Arrow keys select, with Shift besides, with Alt they move the part up or down. Control A selects all, O all that is glued to it. D makes copies, H hides or shows, L locks or unlocks, Delete takes away, F2 names.",
  /** Behind the name of a part, for whoever hears it. */
  isHidden: ", hidden",
  isLocked: ", locked",
  lock: "Lock where it stands",
  unlock: "Unlock",
  selected: (count: number) =>
    plural(count, { one: `${formatNumber(count)} part selected`, other: `${formatNumber(count)} parts selected` }),
  together: "Glue together",
  apart: "Separate",
  whole: "Select the whole object",
  /** The matrix of what is glued. */
  matrix: "What is glued to what",
  matrixNote: "Press a field to glue both objects together, or to take the part of its row out.",
  matrixMany: (most: number) => `With more than ${formatNumber(most)} parts it would be too large to read.`,
  pair: (one: string, other: string) => `${one} and ${other}`,
  glued: "glued",
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
  /** Why it cannot be pressed. */
  oneStays: "One part has to stay.",
  lockedStays: "Locked parts stay.",
  taken: "Another part has this name.",
  tooMany: (most: number) => `A design has at most ${formatNumber(most)} parts.`,
  notAdded: "It could not be drawn, so it was not added.",
});
