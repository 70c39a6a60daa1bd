// A bottle of four rings, as a family of its own and written out, for tests of what pulls at rings.

import type { BoundaryValue, Component, Rings } from "../src/document/types";

export const BOTTLE: Rings = {
  kind: "rings",
  rings: [
    { u: 0, r: { mean: 3 }, z: { mean: 0 } },
    { u: 0.35, r: { mean: 6, waves: [{ n: 3, cos: 0.4, sin: 0.2 }] }, z: { mean: 6 } },
    { u: 0.7, r: { mean: 1.6 }, z: { mean: 15, waves: [{ n: 1, cos: 0.3 }] } },
    { u: 1, r: { mean: 2.2 }, z: { mean: 20 } },
  ],
};

const EQUATION = { order: 4, s: 1, t: 2, w: 1, free: "both" } as const;
const round = (name: "cos" | "sin"): Component => ({
  ...EQUATION,
  modes: [{ n: 1, [name]: { start: 3, end: 2.2, rings: [6, 1.6] } }],
});

/** The same but for its waves, as boundary data. */
export const WRITTEN: BoundaryValue = {
  kind: "boundary-value",
  span: "2pi",
  rings: [{ u: 0.35 }, { u: 0.7 }],
  x: round("cos"),
  y: round("sin"),
  z: { ...EQUATION, modes: [{ n: 0, cos: { start: 0, end: 20, rings: [6, 15] } }] },
};
