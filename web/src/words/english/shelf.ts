/** The shelf of saved designs. */

import { phrases } from "../../language";

export const shelf = phrases("shelf", {
  heading: "My designs",
  lead: "Designs that are saved in this browser, on this device. They stay until you delete them or clear the browser's data.",
  save: "Save to the shelf",
  isSaved: "The pot on the stage is on the shelf.",
  differs: "The pot on the stage is not on the shelf as it is now.",
  empty: "Nothing is on the shelf yet.",
  title: "Title",
  onStage: "On the stage",
  /** `name` is what the design is called. */
  open: (name: string) => `Open ${name}`,
  duplicate: (name: string) => `Duplicate ${name}`,
  replace: (name: string) => `Replace ${name} with the pot on the stage`,
  remove: (name: string) => `Delete ${name}`,
  copyOf: (title: string) => `${title} (copy)`,
  saved: (name: string) => `${name} is saved on the shelf.`,
  renamed: (name: string) => `It is called ${name} now.`,
  duplicated: (name: string) => `There are two of ${name} now.`,
  replaced: (name: string) => `${name} is as on the stage now.`,
  removed: (name: string) => `${name} is deleted.`,
  undo: "Undo",
  undone: "Taken back.",
  left: "Work that was left in closed tabs was put on the shelf.",
  notKept:
    "This browser has no room for it, or keeps nothing for pages. Nothing on the shelf has changed. Save the pot as a file instead.",
  notSolved: "Not saved: the design has a value that the solver cannot use.",
  unreadable: "A design that cannot be read",
});
