/** The list of parts. */

import { phrases } from "../../language";

export const parts = phrases("parts", {
  heading: "Parts",
  keys: "Arrow keys select, with Alt they move the part up or down. D makes a copy, Delete takes the part away, F2 names it.",
  name: "Name of the part",
  up: "Move up",
  down: "Move down",
  duplicate: "Duplicate",
  delete: "Delete",
  taken: "Another part has this name.",
});
