/** What a new design may begin as: plain forms at the size of a hand, in centimetres, of every kind of shape. */

import { type Exhibit, exhibits } from "./gallery/exhibit";
import type { Design } from "./types";

export const BEGINNINGS = exhibits([
  {
    id: "new-vase",
    shape: {
      kind: "fourth-order",
      r0: 4,
      r1: 3.4,
      rm: 6.4,
      h1: 20,
      eta: [1.2, 0.6],
      dz: [24, 30],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
  },
  {
    id: "new-jar",
    shape: {
      kind: "fourth-order",
      r0: 4,
      r1: 4,
      rm: 6.6,
      h1: 13,
      eta: [1.3, -1.4],
      dz: [20, 12],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "shino", clay: "stoneware" },
  },
  {
    id: "new-bowl",
    shape: {
      kind: "fourth-order",
      r0: 3.4,
      r1: 7.5,
      rm: 6.5,
      h1: 7.5,
      eta: [1.6, 0.3],
      dz: [5, 12],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "tenmoku", clay: "stoneware" },
  },
  {
    id: "new-bottle",
    shape: {
      kind: "fourth-order",
      r0: 3.3,
      r1: 2.5,
      rm: 5.2,
      h1: 20,
      eta: [2.6, 1.6],
      dz: [7.5, 30],
      s: [1, 1],
      t: [0, 0],
      w: [0, 0],
    },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "new-cup",
    shape: { kind: "second-order", r: [4, 0, 3.4, 0], height: 9.5, s: [1, 1], t: [0, 0] },
    look: { glaze: "tin-white", clay: "porcelain" },
  },
  {
    id: "new-petals",
    shape: { kind: "second-order", r: [5.2, 0.5, 4, 0.25], n: [1, 8], height: 17, s: [1, 1], t: [0.08, 0.08] },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "new-lip",
    shape: {
      kind: "mixed-order",
      r: [5.2, 0.4, 4.2, 0.2],
      n: [1, 7],
      height: 17,
      s: [1, 1],
      t: [0.08, 0.08],
      rise: -8,
    },
    look: { glaze: "clear", clay: "terracotta" },
  },
  {
    id: "new-dints",
    shape: {
      kind: "bloor-wilson",
      a: 0.3,
      r: [4.6, 0, 0, 4],
      R: [-11, 0, 0, -8],
      h: [15, 0.8],
      H: [-10, -2.5],
      n1: 5,
    },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "new-free",
    shape: {
      kind: "boundary-value",
      span: "2pi",
      x: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, cos: { start: 5, end: 4, start_u: -4, end_u: -6 } }] },
      y: { order: 4, s: 1, t: 2, w: 1, modes: [{ n: 1, sin: { start: 5, end: 4, start_u: -4, end_u: -6 } }] },
      z: { order: 2, s: 1, t: 1, modes: [{ n: 0, cos: { start: 14, end: 0 } }] },
    },
    look: { glaze: "bare", clay: "black" },
  },
]);

/** The form as a document of its own; its title is left to the person. */
export function beginningOf({ shape, look }: Exhibit): Design {
  return { pasu: 1, parts: [{ shape, ...(look && { look }) }] };
}
