/** An octant of a supersphere: its exponents. */

import type { PresetId } from "../../document/octant/presets";
import { phrases } from "../../language";

export const octants = phrases("octants", {
  lead: "An octant.",
  about:
    "All points with xᵃ + yᵇ + zᶜ of 1 or less, where no coordinate is below 0. It ends at three flat faces, so that eight of them make a whole.",
  presets: "Begin with",
  names: {
    ball: "Round",
    box: "Box",
    facet: "Flat",
    hollow: "Hollow",
  } satisfies Readonly<Record<PresetId, string>>,
  exponents: ["Exponent of x", "Exponent of y", "Exponent of z"],
  help: "2 is round, more comes near to a box, 1 is flat and less is hollow. From 0.05 to 50.",
});
