/** The fields of the mixed order vase, ZY01 equations 9 to 12. */

import { KIND_NAMES } from "../kinds";
import type { Family } from "../schema";
import { PLANAR_FIELDS } from "./second-order";

export const MIXED_ORDER: Family = {
  kind: "mixed-order",
  name: KIND_NAMES["mixed-order"],
  source: "Zhang and You 2001, eqs 9 to 12",
  fields: [
    ...PLANAR_FIELDS,
    {
      path: ["rise"],
      symbol: "h_0'",
      name: "Rise at the rim",
      group: "Rim",
      length: true,
      min: -20,
      max: 20,
      step: 0.1,
      help: "How steeply the wall leaves the rim: far below 0 it drops at once, near 0 the rim lies flat, above 0 it first climbs.",
    },
  ],
  reset: { kind: "mixed-order", r: [1, 0.1, 0.6, 0.06], rise: -10 },
};
