/** A pot beside another: whether they are the same, and what became of each part. */

import { phrases } from "../../language";
import { formatNumber } from "../../number";

export const comparing = phrases("comparing", {
  heading: "Compare with…",
  lead: "Whether another pot is this one, however it was written, and otherwise what became of each part.",
  other: "Link or design",
  otherHelp: "Paste a link, or the text of a design.",
  compare: "Compare",
  file: "From a file",
  shelf: "My designs",
  with: (title: string) => `Compared with ${title}`,
  same: "The same pot, with one fingerprint.",
  different: "Another pot.",
  units: (here: string, there: string) =>
    `This one is in ${here}, the other in ${there}: numbers are compared, not how large things are.`,
  kept: "The same in both",
  moved: "Elsewhere, turned or of another size",
  changed: "Of another shape, wall or look",
  added: "Only here",
  gone: "Only in the other",
  reglued: "Glued to other parts",
  /** What a part is called in the other design. */
  there: (name: string) => `there ${name}`,
  select: (name: string) => `Select ${name}`,
  /** The same on the stage. */
  onStage: "Show on the stage",
  close: "Compare no longer",
  hatched: "Hatched: as the other has it.",
  count: (count: number) => formatNumber(count),
  refused: (why: string) => `That cannot be compared: ${why}`,
});
