/** Designs of our own. Each shows one thing that the method does well; lengths in centimetres. */

import type { Exhibit } from "../gallery";

export const OWN: readonly Exhibit[] = [
  {
    id: "own-jar",
    title: "Round jar",
    note: "Fourth order: a full belly between a narrow foot and a level rim.",
    shape: {
      kind: "fourth-order",
      r0: 5,
      r1: 4.5,
      rm: 11,
      h1: 16,
      eta: [0.9, -0.75],
      dz: [8, 16],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-tulip",
    title: "Tulip vase",
    note: "Mixed order: nine shallow petals that run from the rim into the foot.",
    shape: {
      kind: "mixed-order",
      r: [5, 0.35, 3.4, 0.1],
      n: [1, 10],
      height: 18,
      t: [0.06, 0.06],
      rise: -30,
    },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-wave-bowl",
    title: "Wave bowl",
    note: "Bloor–Wilson: five long waves in the rim that die out in the wall.",
    shape: {
      kind: "bloor-wilson",
      a: 0.8,
      r: [9, 0, 0, 4],
      R: [-2, 0, 0, -9],
      h: [7, 0.8],
      H: [-9, -1.2],
      n1: 5,
    },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
];
