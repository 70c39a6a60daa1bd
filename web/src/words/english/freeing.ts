/** Making rings of a form that is none of rings yet. */

import { phrases, plural } from "../../language";

export const freeing = phrases("freeing", {
  heading: "Make it rings",
  lead: "The same form, through as many rings as it takes. Every ring can then be pulled, made oval or given petals; the numbers of this family go. Undo brings them back.",
  tolerance: "No further off than",
  toleranceHelp: "Less takes more rings.",
  coming: "Finding rings…",
  found: (rings: number, distance: string) =>
    plural(rings, {
      one: `1 ring, ${distance} off at most.`,
      other: `${rings} rings, ${distance} off at most.`,
    }),
  exact: (rings: number) =>
    plural(rings, { one: "1 ring, the very same form.", other: `${rings} rings, the very same form.` }),
  use: "Use the rings",
  leave: "Leave it as it is",
  done: (rings: number, distance: string) =>
    plural(rings, {
      one: `It is 1 ring now, ${distance} off at most.`,
      other: `It is ${rings} rings now, ${distance} off at most.`,
    }),
  changed: "The form was changed meanwhile. Try it once more.",
  /** Why a form cannot be made of rings. */
  cannot: {
    "no-ends": "This cannot be made of rings: it is no wall between a foot and a rim.",
    open: "This cannot be made of rings: its wall does not close round the axis.",
    "turns-back":
      "This cannot be made of rings: somewhere its wall turns back on its way round the axis, or does not go round it. A ring goes round once.",
  },
  tooFine: (reached: string) =>
    `More rings than are possible would be needed for that. ${reached} off at most can be reached.`,
});
