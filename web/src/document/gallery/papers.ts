/**
 * All 26 figures of the two papers on vases, as printed: the values of `tests/reference/surfaces.json` by figure.
 * A unit test holds the two lists against each other.
 */

import { exhibits } from "./exhibit";

export const PAPERS = exhibits([
  {
    id: "zhang-you-1a",
    shape: {
      kind: "second-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.5, 0.5],
    },
  },
  {
    id: "zhang-you-1b",
    shape: {
      kind: "second-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.1, 0.1],
    },
  },
  {
    id: "zhang-you-2a",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [5, 5],
      t: [0.2, 0.2],
    },
  },
  {
    id: "zhang-you-2b",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [1, 1],
      t: [0.5, 0.5],
    },
  },
  {
    id: "zhang-you-3a",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [5, 5],
      t: [0.2, 0.2],
      force: [-1, 0],
    },
  },
  {
    id: "zhang-you-3b",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [5, 5],
      t: [0.2, 0.2],
      force: [-0.5, 0],
    },
  },
  {
    id: "zhang-you-3c",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [5, 5],
      t: [0.2, 0.2],
      force: [1.5, -4],
    },
  },
  {
    id: "zhang-you-3d",
    shape: {
      kind: "second-order",
      r: [1, 0, 0.6, 0],
      s: [5, 5],
      t: [0.2, 0.2],
      force: [-3.1, 5],
    },
  },
  {
    id: "zhang-you-4a",
    shape: {
      kind: "mixed-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.5, 0.5],
      rise: -10,
    },
  },
  {
    id: "zhang-you-4b",
    shape: {
      kind: "mixed-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.5, 0.5],
      rise: -0.01,
    },
  },
  {
    id: "zhang-you-4c",
    shape: {
      kind: "mixed-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.1, 0.1],
      rise: -10,
    },
  },
  {
    id: "zhang-you-4d",
    shape: {
      kind: "mixed-order",
      r: [1, 0.1, 0.6, 0.06],
      s: [1, 1],
      t: [0.1, 0.1],
      rise: -0.01,
    },
  },
  {
    id: "zhang-you-5a",
    shape: {
      kind: "fourth-order",
      r0: 0.4,
      r1: 0.3,
      rm: 0.8,
      h1: 2,
      eta: [0.5, 0.5],
      dz: [6, 6],
      s: [1, 1],
      t: [3, 3],
      w: [1, 1],
    },
  },
  {
    id: "zhang-you-5b",
    shape: {
      kind: "fourth-order",
      r0: 0.2,
      r1: 0.8,
      rm: 0.7,
      h1: 2,
      eta: [0.1, 0.1],
      dz: [6, 6],
      s: [1, 1],
      t: [16, 16],
      w: [60, 60],
    },
  },
  {
    id: "zhang-you-5c",
    shape: {
      kind: "fourth-order",
      r0: 0.4,
      r1: 0.3,
      rm: 0.2,
      h1: 2,
      eta: [2.5, 2.5],
      dz: [6, 6],
      s: [1, 1],
      t: [6, 6],
      w: [1, 1],
    },
  },
  {
    id: "zhang-you-5d",
    shape: {
      kind: "fourth-order",
      r0: 0.4,
      r1: 0.3,
      rm: 0.8,
      h1: 3,
      eta: [0.3, 0.3],
      dz: [1.5, 1.5],
      s: [1, 1],
      t: [15, 15],
      w: [1, 1],
    },
  },
  {
    id: "zhang-you-5e",
    shape: {
      kind: "fourth-order",
      r0: 0.25,
      r1: 0.5,
      rm: 0.3,
      h1: 3,
      eta: [0.5, 30],
      dz: [1.5, 9],
      s: [1, 1],
      t: [3, 3],
      w: [2, 2],
    },
  },
  {
    id: "ishak-ali-4-n1",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 1,
    },
  },
  {
    id: "ishak-ali-4-n2",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 2,
    },
  },
  {
    id: "ishak-ali-4-n3",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 3,
    },
  },
  {
    id: "ishak-ali-4-n5",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 5,
    },
  },
  {
    id: "ishak-ali-4-n10",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 10,
    },
  },
  {
    id: "ishak-ali-4-n15",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 0.01,
      n1: 15,
    },
  },
  {
    id: "ishak-ali-5-a1",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 1,
      n1: 5,
    },
  },
  {
    id: "ishak-ali-5-a6",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 6,
      n1: 5,
    },
  },
  {
    id: "ishak-ali-5-a9",
    shape: {
      kind: "bloor-wilson",
      r: [1, 0.1, 0.1, 0.8],
      R: [-3, -0.5, -0.5, 2],
      h: [3, 0.3],
      H: [-0.5, -0.7],
      a: 9,
      n1: 5,
    },
  },
]);
