/** What the fields of the fourth order vase are called, ZY01 equations 13 to 17. The foot is at `u = 0`. */

import type { FieldKey, FieldWords } from "../field";

export const FOURTH_ORDER: Readonly<Record<FieldKey<"fourth-order">, FieldWords>> = {
  r1: {
    name: "Rim radius",
    help: "How wide the rim is.",
  },
  "eta-1": {
    name: "Rim flare",
    help: "How strongly the wall leans where it meets the rim, as a share of the belly’s swell.",
  },
  "dz-1": {
    name: "Rise at the rim",
    help: "How steeply the wall climbs where it meets the rim.",
  },
  r0: {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "eta-0": {
    name: "Foot flare",
    help: "How strongly the wall leans where it leaves the foot, as a share of the belly’s swell.",
  },
  "dz-0": {
    name: "Rise at the foot",
    help: "How steeply the wall climbs where it leaves the foot.",
  },
  h1: {
    name: "Height",
    help: "From the foot up to the rim.",
  },
  rm: {
    name: "Belly radius",
    help: "The width that the two flares aim at half way up.",
  },
  "t-0": {
    name: "Waist pull",
    help: "Tightens the wall like a skin, towards the shortest way between its ends.",
  },
  "t-1": {
    name: "Waist pull",
    help: "Tightens the wall like a skin, towards the shortest way between its ends.",
  },
  "w-0": {
    name: "Axis pull",
    help: "Draws the middle of the wall in towards the axis.",
  },
  "w-1": {
    name: "Axis pull",
    help: "Draws the middle of the wall in towards the axis.",
  },
  "s-0": {
    name: "Wall stiffness",
    help: "Bends the wall in wide, even curves. It may not be 0.",
  },
  "s-1": {
    name: "Wall stiffness",
    help: "Bends the wall in wide, even curves. It may not be 0.",
  },
};
