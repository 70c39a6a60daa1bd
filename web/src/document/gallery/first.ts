/** The pot that a new visitor sees. It has a file of its own because the page shows it before the gallery is fetched. */

import type { Exhibit } from "./exhibit";

export const FIRST: Exhibit<"own-jar"> = {
  id: "own-jar",
  shape: {
    kind: "fourth-order",
    r0: 5.5,
    r1: 5.4,
    rm: 9.4,
    h1: 20,
    eta: [1.4, -1.9],
    dz: [34, 9],
    s: [1, 1],
    t: [2, 2],
    w: [1, 1],
  },
  look: { glaze: "shino", clay: "stoneware" },
};
