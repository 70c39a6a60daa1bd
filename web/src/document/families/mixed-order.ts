/** What the fields of the mixed order vase are called, ZY01 equations 9 to 12. */

import type { FieldKey, FieldWords } from "../field";
import { PLANAR } from "./second-order";

export const MIXED_ORDER: Readonly<Record<FieldKey<"mixed-order">, FieldWords>> = {
  ...PLANAR,
  rise: {
    name: "Rise at the rim",
    help: "How steeply the wall leaves the rim: far below 0 it drops at once, near 0 the rim lies flat, above 0 it first climbs.",
  },
};
