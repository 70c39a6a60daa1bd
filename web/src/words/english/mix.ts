/** Two pots, mixed. */

import { phrases } from "../../language";

export const mix = phrases("mix", {
  heading: "Mix with…",
  lead: "Choose a pot. A slider then says how much of it there is in yours, from nothing to all.",
  forms: "Forms",
  gallery: "From the gallery",
  shelf: "My designs",
  of: (name: string) => `Mixed with ${name}`,
  share: "Share",
  help: "0 is your pot, 100 the other. Wall and shape are mixed; the glaze is that of the nearer one.",
  keep: "Keep",
  leave: "Cancel",
  other: "Only single pots of rings can be mixed.",
  many: "Together these two have more rings than one pot may have.",
  refused: (why: string) => `These two cannot be mixed: ${why}`,
});
