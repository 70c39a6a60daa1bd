/** Designs of our own. Each shows one thing that the method does well; lengths in centimetres. */

import { exhibits } from "./exhibit";
import { FIRST } from "./first";
import { turned } from "./outline";

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
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 4.6, rim: 5, footSlope: 20, rimSlope: -8 },
      petals: [
        {
          n: 6,
          cos: { foot: 0.6, rimSlope: 2.83, force: [-142] },
          sin: { rim: -0.6, footSlope: 2.83, force: [142] },
        },
      ],
      height: { rim: 25, footSlope: 22, rimSlope: 24 },
    }),
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
    shape: turned({
      equation: [1, 0.2, 0.01],
      radius: { foot: 3.8, rim: 6.8, footSlope: 20, rimSlope: 9 },
      petals: [{ n: 6, cos: { rim: 0.7, rimSlope: 4 } }],
      height: { rim: 20, footSlope: 14, rimSlope: 22 },
      waves: [{ n: 6, cos: { rim: 0.9, rimSlope: 2 } }],
    }),
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-fluted",
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 4.2, rim: 6.2, footSlope: 14, rimSlope: 14 },
      petals: [{ n: 20, cos: { foot: 0.15, rim: 0.28 } }],
      height: { rim: 24, footSlope: 24, rimSlope: 22 },
    }),
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "own-melon",
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 4.4, rim: 3.6, footSlope: 28, rimSlope: -24 },
      petals: [{ n: 8, cos: { force: [300] } }],
      height: { rim: 16.5, footSlope: 12, rimSlope: 14 },
    }),
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-saddle",
    shape: turned({
      equation: [1, 2, 1],
      radius: { foot: 4.5, rim: 7.2, footSlope: 14, rimSlope: 9 },
      petals: [{ n: 2, cos: { rim: 0.8, rimSlope: 2.5 } }],
      height: { rim: 17, footSlope: 18, rimSlope: 18 },
      waves: [{ n: 2, cos: { rim: 2.4, rimSlope: 5 } }],
    }),
    look: { glaze: "tenmoku", clay: "stoneware" },
  },
  {
    id: "own-gourd",
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 4.2, rim: 2, footSlope: 44, rimSlope: -28, force: [51144, -252000, 252000] },
      height: { rim: 29, footSlope: 30, rimSlope: 30 },
    }),
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-bowl",
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 3.6, rim: 9.6, footSlope: 11, rimSlope: 3.5 },
      petals: [{ n: 10, cos: { rim: 0.36, rimSlope: 0.6 } }],
      height: { rim: 8, rimSlope: 22 },
      waves: [{ n: 10, cos: { rim: 0.16 } }],
    }),
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
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 5.4, rim: 3, footSlope: 14, rimSlope: 7 },
      petals: [{ n: 4, cos: { foot: -0.75, footSlope: -1.4 } }],
      height: { rim: 25, footSlope: 26, rimSlope: 36 },
    }),
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
    shape: turned({
      equation: [1, 0, 0],
      radius: { foot: 4.6, rim: 2.2, footSlope: 24, rimSlope: 6 },
      axis: { rim: 2.4, rimSlope: 8 },
      height: { rim: 22, footSlope: 12, rimSlope: 26 },
      waves: [{ n: 1, cos: { rim: -0.6, rimSlope: -3 } }],
    }),
    look: { glaze: "bare", clay: "black" },
  },
  {
    id: "own-plate",
    shape: turned({
      equation: [1, 2, 1],
      radius: { foot: 5.5, rim: 13, footSlope: 11, rimSlope: 8 },
      petals: [{ n: 12, cos: { rim: 0.35 } }],
      height: { rim: 2.6, rimSlope: 7 },
      waves: [{ n: 12, cos: { rim: 0.12 } }],
    }),
    look: { glaze: "tin-white", clay: "terracotta" },
  },
]);
