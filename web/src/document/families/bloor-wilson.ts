/** What the fields of the dint vase are called, IA equations 15 to 18. The rim is at `u = 0`. */

import type { FieldKey, FieldWords } from "../field";

export const BLOOR_WILSON: Readonly<Record<FieldKey<"bloor-wilson">, FieldWords>> = {
  "r-0": {
    name: "Rim radius",
    help: "How wide the rim is.",
  },
  "R-0": {
    name: "Rim flare",
    help: "Which way the wall leaves the rim: below 0 inwards, above 0 outwards.",
  },
  "H-0": {
    name: "Rise at the rim",
    help: "How steeply the wall leaves the rim: below 0 downwards, above 0 it first climbs.",
  },
  n1: {
    name: "Number of dints",
    help: "How many waves the rim has. A fraction leaves the pot open.",
  },
  "h-1": {
    name: "Dint height",
    help: "How far the rim waves up and down. 0 gives a level rim.",
  },
  "H-1": {
    name: "Dint slope",
    help: "How the waves run on into the wall: against the dint height they fade quickly, with it they carry on.",
  },
  "r-1": {
    name: "Rim skew, first",
    help: "Stretches the rim into an oval along the diagonal. It adds to the second.",
  },
  "r-2": {
    name: "Rim skew, second",
    help: "Stretches the rim into an oval along the diagonal. It adds to the first.",
  },
  "r-3": {
    name: "Foot radius",
    help: "How wide the foot is.",
  },
  "R-3": {
    name: "Foot flare",
    help: "Which way the wall runs on through the foot: above 0 outwards, below 0 inwards.",
  },
  "h-0": {
    name: "Height",
    help: "From the foot up to the middle of the rim.",
  },
  "R-1": {
    name: "Skew slope, first",
    help: "How the oval of the rim runs on into the wall. It adds to the second.",
  },
  "R-2": {
    name: "Skew slope, second",
    help: "How the oval of the rim runs on into the wall. It adds to the first.",
  },
  a: {
    name: "Smoothing",
    help: "How far the edges reach into the wall: near 0 far, large values keep their waves close to the rim.",
  },
};
