/** Designs of our own. Each shows one thing that the method does well; lengths in centimetres. */

import { exhibits } from "./exhibit";
import { FIRST } from "./first";

export const OWN = exhibits([
  FIRST,
  {
    id: "own-dint",
    shape: {
      kind: "bloor-wilson",
      a: 0.3,
      r: [7, 0.5, 0.5, 5],
      R: [-22, -3, -3, -14],
      h: [21, 1.4],
      H: [-14, -4],
      n1: 5,
    },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "own-moon-jar",
    shape: {
      kind: "fourth-order",
      r0: 5.5,
      r1: 6.2,
      rm: 14,
      h1: 26.5,
      eta: [1.1, -1.05],
      dz: [14, 17],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "tin-white", clay: "porcelain" },
  },
  {
    id: "own-twist",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 4.6, waves: [{ n: 6, cos: 0.6 }] }, z: { mean: 0 } },
        { u: 0.25, r: { mean: 7.85, waves: [{ n: 6, cos: 0.166, sin: 0.512 }] }, z: { mean: 5.875 } },
        { u: 0.5, r: { mean: 8.3, waves: [{ n: 6, cos: -0.424, sin: 0.424 }] }, z: { mean: 12.25 } },
        { u: 0.75, r: { mean: 7, waves: [{ n: 6, cos: -0.512, sin: -0.166 }] }, z: { mean: 18.75 } },
        { u: 1, r: { mean: 5, waves: [{ n: 6, sin: -0.6 }] }, z: { mean: 25 } },
      ],
      foot: { r: { mean: 20, waves: [{ n: 6, sin: 2.83 }] }, z: { mean: 22 } },
      rim: { r: { mean: -8, waves: [{ n: 6, cos: 2.83 }] }, z: { mean: 24 } },
    },
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "own-amphora",
    shape: {
      kind: "fourth-order",
      r0: 3,
      r1: 4.6,
      rm: 9,
      h1: 33,
      eta: [2.3, 1.25],
      dz: [70, 40],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "bare", clay: "terracotta" },
  },
  {
    id: "own-tulip",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 3.8 }, z: { mean: 0 } },
        {
          u: 0.5,
          r: { mean: 6.668, waves: [{ n: 6, cos: -0.085 }] },
          z: { mean: 9.002, waves: [{ n: 6, cos: 0.225 }] },
        },
        {
          u: 0.75,
          r: { mean: 6.002, waves: [{ n: 6, cos: 0.073 }] },
          z: { mean: 14.441, waves: [{ n: 6, cos: 0.492 }] },
        },
        { u: 1, r: { mean: 6.8, waves: [{ n: 6, cos: 0.7 }] }, z: { mean: 20, waves: [{ n: 6, cos: 0.9 }] } },
      ],
      foot: { r: { mean: 20 }, z: { mean: 14 } },
      rim: { r: { mean: 9, waves: [{ n: 6, cos: 4 }] }, z: { mean: 22, waves: [{ n: 6, cos: 2 }] } },
    },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-fluted",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 4.2, waves: [{ n: 20, cos: 0.15 }] }, z: { mean: 0 } },
        { u: 0.125, r: { mean: 5.434, waves: [{ n: 20, cos: 0.156 }] }, z: { mean: 3.027 } },
        { u: 0.25, r: { mean: 5.825, waves: [{ n: 20, cos: 0.17 }] }, z: { mean: 6.094 } },
        { u: 0.375, r: { mean: 5.653, waves: [{ n: 20, cos: 0.191 }] }, z: { mean: 9.176 } },
        { u: 0.5, r: { mean: 5.2, waves: [{ n: 20, cos: 0.215 }] }, z: { mean: 12.25 } },
        { u: 0.625, r: { mean: 4.747, waves: [{ n: 20, cos: 0.239 }] }, z: { mean: 15.293 } },
        { u: 0.75, r: { mean: 4.575, waves: [{ n: 20, cos: 0.26 }] }, z: { mean: 18.281 } },
        { u: 0.875, r: { mean: 4.966, waves: [{ n: 20, cos: 0.274 }] }, z: { mean: 21.191 } },
        { u: 1, r: { mean: 6.2, waves: [{ n: 20, cos: 0.28 }] }, z: { mean: 24 } },
      ],
      foot: { r: { mean: 14 }, z: { mean: 24 } },
      rim: { r: { mean: 14 }, z: { mean: 22 } },
    },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "own-melon",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 4.4 }, z: { mean: 0 } },
        { u: 0.25, r: { mean: 9.337, waves: [{ n: 8, cos: 0.439 }] }, z: { mean: 3.609 } },
        { u: 0.5, r: { mean: 10.5, waves: [{ n: 8, cos: 0.781 }] }, z: { mean: 8 } },
        { u: 0.75, r: { mean: 8.413, waves: [{ n: 8, cos: 0.439 }] }, z: { mean: 12.516 } },
        { u: 1, r: { mean: 3.6 }, z: { mean: 16.5 } },
      ],
      foot: { r: { mean: 28 }, z: { mean: 12 } },
      rim: { r: { mean: -24 }, z: { mean: 14 } },
    },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-saddle",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 4.5 }, z: { mean: 0 } },
        { u: 1, r: { mean: 7.2, waves: [{ n: 2, cos: 0.8 }] }, z: { mean: 17, waves: [{ n: 2, cos: 2.4 }] } },
      ],
      foot: { r: { mean: 14 }, z: { mean: 18 } },
      rim: { r: { mean: 9, waves: [{ n: 2, cos: 2.5 }] }, z: { mean: 18, waves: [{ n: 2, cos: 5 }] } },
    },
    look: { glaze: "tenmoku", clay: "stoneware" },
  },
  {
    id: "own-gourd",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 4.2 }, z: { mean: 0 } },
        { u: 0.125, r: { mean: 8.154 }, z: { mean: 3.707 } },
        { u: 0.25, r: { mean: 7.832 }, z: { mean: 7.344 } },
        { u: 0.375, r: { mean: 5.101 }, z: { mean: 10.934 } },
        { u: 0.5, r: { mean: 3.1 }, z: { mean: 14.5 } },
        { u: 0.625, r: { mean: 3.356 }, z: { mean: 18.066 } },
        { u: 0.75, r: { mean: 4.819 }, z: { mean: 21.656 } },
        { u: 0.875, r: { mean: 4.831 }, z: { mean: 25.293 } },
        { u: 1, r: { mean: 2 }, z: { mean: 29 } },
      ],
      foot: { r: { mean: 44 }, z: { mean: 30 } },
      rim: { r: { mean: -28 }, z: { mean: 30 } },
    },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-bowl",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 3.6 }, z: { mean: 0 } },
        {
          u: 0.5,
          r: { mean: 7.537, waves: [{ n: 10, cos: 0.105 }] },
          z: { mean: 1.25, waves: [{ n: 10, cos: 0.08 }] },
        },
        {
          u: 0.75,
          r: { mean: 8.686, waves: [{ n: 10, cos: 0.219 }] },
          z: { mean: 3.656, waves: [{ n: 10, cos: 0.135 }] },
        },
        { u: 1, r: { mean: 9.6, waves: [{ n: 10, cos: 0.36 }] }, z: { mean: 8, waves: [{ n: 10, cos: 0.16 }] } },
      ],
      foot: { r: { mean: 11 }, z: { mean: 0 } },
      rim: { r: { mean: 3.5, waves: [{ n: 10, cos: 0.6 }] }, z: { mean: 22 } },
    },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-carafe",
    shape: {
      kind: "fourth-order",
      r0: 4.4,
      r1: 3.4,
      rm: 7,
      h1: 27,
      eta: [2.6, 1.6],
      dz: [10, 40],
      s: [1, 1],
      t: [0, 0],
      w: [0, 0],
    },
    look: { glaze: "tenmoku", clay: "stoneware" },
  },
  {
    id: "own-square",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 5.4, waves: [{ n: 4, cos: -0.75 }] }, z: { mean: 0 } },
        { u: 0.25, r: { mean: 6.666, waves: [{ n: 4, cos: -0.83 }] }, z: { mean: 5.875 } },
        { u: 0.5, r: { mean: 5.075, waves: [{ n: 4, cos: -0.55 }] }, z: { mean: 11.25 } },
        { u: 1, r: { mean: 3 }, z: { mean: 25 } },
      ],
      foot: { r: { mean: 14, waves: [{ n: 4, cos: -1.4 }] }, z: { mean: 26 } },
      rim: { r: { mean: 7 }, z: { mean: 36 } },
    },
    look: { glaze: "shino", clay: "stoneware" },
  },
  {
    id: "own-trumpet",
    shape: { kind: "second-order", r: [7.4, 0.5, 5, 0.2], n: [1, 11], height: 22, s: [1, 1], t: [0.1, 0.1] },
    look: { glaze: "clear", clay: "porcelain" },
  },
  {
    id: "own-plum",
    shape: {
      kind: "fourth-order",
      r0: 5,
      r1: 2.9,
      rm: 10,
      h1: 29,
      eta: [-0.3, -2.3],
      dz: [52, 10],
      s: [1, 1],
      t: [2, 2],
      w: [1, 1],
    },
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "own-leaning",
    shape: {
      kind: "rings",
      rings: [
        {
          u: 0,
          r: {
            mean: 4.521,
            waves: [
              { n: 1, cos: -1.2 },
              { n: 2, cos: 0.08 },
            ],
          },
          z: { mean: 0 },
        },
        {
          u: 0.5,
          r: {
            mean: 5.605,
            waves: [
              { n: 1, cos: -1 },
              { n: 2, cos: 0.045 },
            ],
          },
          z: {
            mean: 9.257,
            waves: [
              { n: 1, cos: 0.075 },
              { n: 2, cos: -0.007 },
            ],
          },
        },
        {
          u: 0.75,
          r: {
            mean: 2.848,
            waves: [
              { n: 1, cos: -0.3 },
              { n: 2, cos: 0.008 },
            ],
          },
          z: { mean: 15.464, waves: [{ n: 1, cos: -0.084 }] },
        },
        {
          u: 1,
          r: {
            mean: 2.026,
            waves: [
              { n: 1, cos: 1.2 },
              { n: 2, cos: 0.178 },
            ],
          },
          z: {
            mean: 22.164,
            waves: [
              { n: 1, cos: -0.577 },
              { n: 2, cos: -0.164 },
              { n: 3, cos: -0.024 },
            ],
          },
        },
      ],
      foot: { r: { mean: 24.425, waves: [{ n: 2, cos: -0.43 }] }, z: { mean: 12 } },
      rim: {
        r: {
          mean: 4.058,
          waves: [
            { n: 1, cos: 8 },
            { n: 2, cos: 2.019 },
          ],
        },
        z: {
          mean: 27.463,
          waves: [
            { n: 1, cos: -2.693 },
            { n: 2, cos: -1.463 },
            { n: 3, cos: -0.318 },
          ],
        },
      },
    },
    look: { glaze: "bare", clay: "black" },
  },
  {
    id: "own-plate",
    shape: {
      kind: "rings",
      rings: [
        { u: 0, r: { mean: 5.5 }, z: { mean: 0 } },
        { u: 1, r: { mean: 13, waves: [{ n: 12, cos: 0.35 }] }, z: { mean: 2.6, waves: [{ n: 12, cos: 0.12 }] } },
      ],
      foot: { r: { mean: 11 }, z: { mean: 0 } },
      rim: { r: { mean: 8 }, z: { mean: 7 } },
    },
    look: { glaze: "tin-white", clay: "terracotta" },
  },
]);
