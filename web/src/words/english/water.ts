/** Water in the pot. */

import { phrases } from "../../language";

export const water = phrases("water", {
  heading: "Water",
  fill: "Fill it",
  pour: "Pour it out",
  level: "Water level",
  deep: (depth: string) => `${depth} deep.`,
  toBrim: (volume: string) => `To the brim: ${volume}.`,
  isBrim: "This is the brim.",
  sentences: (all: readonly string[]) => all.join(" "),
  cut: "Cut open",
  coming: "…",
});
