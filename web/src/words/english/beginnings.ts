/** What a new design may begin as. */

import type { BEGINNINGS } from "../../document/beginnings";
import { phrases } from "../../language";

export const beginnings = phrases("beginnings", {
  heading: "New pot",
  lead: "Your present pot stays within reach: undo brings it back.",
  forms: {
    "new-vase": {
      title: "Vase",
      note: "Fourth order: the slopes at rim and foot are yours.",
    },
    "new-jar": {
      title: "Jar",
      note: "Fourth order: a shoulder under a wide mouth.",
    },
    "new-bowl": {
      title: "Bowl",
      note: "Fourth order: from a narrow foot to an open rim.",
    },
    "new-bottle": {
      title: "Bottle",
      note: "Fourth order: a low belly and a long neck.",
    },
    "new-cup": {
      title: "Cup",
      note: "Second order: two edges, and a straight wall between them.",
    },
    "new-petals": {
      title: "Petalled vase",
      note: "Second order: petals, and a waist that the equation draws in.",
    },
    "new-lip": {
      title: "Vase with a lip",
      note: "Mixed order: petals, and how steeply the wall leaves the rim.",
    },
    "new-dints": {
      title: "Dint vase",
      note: "Bloor–Wilson: waves in the rim that fade in the wall.",
    },
    "new-free": {
      title: "Free boundary data",
      note: "Any edges, wave by wave. For those who like tables.",
    },
  } satisfies Readonly<Record<(typeof BEGINNINGS)[number]["id"], { readonly title: string; readonly note: string }>>,
});
