/** How large the pot is. */

import { phrases } from "../../language";

export const size = phrases("size", {
  heading: "How large",
  unit: "Unit",
  units: { mm: "millimetres", cm: "centimetres", in: "inches" },
  names: { height: "Height", width: "Width", capacity: "Holds" },
  wallScales: "The wall scales too",
  wallStays: (thickness: string) => `It stays ${thickness} thick.`,
  positive: "A size is greater than 0.",
  tooSmall: "With a wall as thick as this the pot cannot be made in that size.",
});
