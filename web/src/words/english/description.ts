/** What is said of the pot on the stage. */

import { phrases } from "../../language";

/** From two. */
const COUNTS = ["Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten", "Eleven", "Twelve"];

export const description = phrases("description", {
  forms: { plate: "A plate", bowl: "A bowl", bottle: "A bottle", jar: "A jar", vase: "A vase" },
  widest: {
    rim: "widest at the rim",
    shoulder: "widest at the shoulder",
    middle: "widest in the middle",
    low: "widest low down",
    foot: "widest at the foot",
  },
  oval: { rim: "an oval rim", foot: "an oval foot" },
  petals: {
    rim: (count: number) => `${count} petals`,
    foot: (count: number) => `${count} petals at the foot`,
  },
  slanting: "a slanting rim",
  saddle: "a saddle-shaped rim",
  /** Of the rim, three or more. */
  waves: (count: number) => `${count} waves in the rim`,
  pot: (form: string, high: string, wide: string, widest: string, marks: string | null) =>
    `${form} ${high} high and ${wide} wide, ${widest}${marks === null ? "" : `, with ${marks}`}.`,
  open: "The wall does not close.",
  parts: (count: number, high: string, wide: string) =>
    `${COUNTS[count - 2] ?? count} parts, ${high} high and ${wide} wide together.`,
  /** One that is no pot. */
  body: (high: string, wide: string) => `${high} high and ${wide} wide.`,
  sentences: (all: readonly string[]) => all.join(" "),
  accuracy: (within: string) => `Drawn to within ${within} of the true surface.`,
});
