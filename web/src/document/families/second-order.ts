/** What the fields of the second order vase are called, ZY01 equations 1 to 8. */

import type { FieldKey, FieldWords } from "../field";

/** Shared with the mixed order, which differs in `z` alone. */
export const PLANAR: Readonly<Record<FieldKey<"second-order">, FieldWords>> = {
  "r-0": {
    name: "Rim radius",
    help: "How wide the rim is, from the axis to the middle of its petals.",
  },
  "r-1": {
    name: "Rim petal depth",
    help: "How far the petals of the rim swing out and in. 0 gives a round rim.",
  },
  "r-2": {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "r-3": {
    name: "Foot petal depth",
    help: "How far the petals of the foot swing out and in.",
  },
  height: {
    name: "Height",
    help: "From the foot up to the rim.",
  },
  "n-1": {
    symbol: "n_2 − n_1",
    name: "Petals",
    help: "How many petals the eye counts while the wall goes round. In the paper the wave has one more for each turn of the wall. A fraction leaves the pot open.",
  },
  "n-0": {
    name: "Turns of the wall",
    help: "How often the wall goes round the axis before it closes. 1 is a pot; a fraction leaves it open.",
  },
  "t-0": {
    name: "Waist pull",
    help: "Draws the wall in towards the axis between rim and foot. 0 leaves it straight.",
  },
  "t-1": {
    name: "Waist pull",
    help: "Draws the wall in towards the axis between rim and foot, across.",
  },
  "s-0": {
    name: "Wall stiffness",
    help: "Keeps the wall straight against the waist pull. It may not be 0.",
  },
  "s-1": {
    name: "Wall stiffness",
    help: "Keeps the wall straight against the waist pull, across. It may not be 0.",
  },
  "force-0": {
    name: "Even push",
    help: "Pushes the whole wall: below 0 outwards, above 0 inwards.",
  },
  "force-1": {
    name: "Push growing to the foot",
    help: "Pushes harder the nearer the foot: below 0 outwards, above 0 inwards.",
  },
};
