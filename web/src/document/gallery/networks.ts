/** Networks of patches, in centimetres: pots with what no wheel throws, clothes, a face; and single patches with the forces that sculpt them. */

import { opening, type Ring, ringOf, turned, Weaving } from "../network/weaving";
import type { Triple, VertexFrame } from "../types";
import { exhibits } from "./exhibit";

/** So many patches go round a vessel. */
const ROUND = 8;
/** The one of them that looks along x, and the one that looks against it. */
const [EAST, WEST] = [0, ROUND / 2];

type Spot = readonly [x: number, z: number];
/** Radius and height of rings, corners and middles in turn. */
type Profile = readonly (readonly [radius: number, height: number])[];
/** Where a point of a ring is. */
type Round = (radius: number, angle: number, height: number) => Triple;

const circle: Round = (radius, angle, height) => [radius * Math.cos(angle), radius * Math.sin(angle), height];

/**
 * A vessel with both sides of its wall, from the middle of its bottom to the middle of its floor. `holes` are the patches of each row that stay open; what is given back says what goes
 * round such an opening.
 */
function vessel(
  weaving: Weaving,
  profile: Profile,
  holes: Readonly<Record<number, readonly number[]>> = {},
  round = circle,
) {
  const rings = profile.map(([radius, height]) => ringOf(ROUND, (angle) => round(radius, angle, height)));
  const ring = (place: number) => rings[place] as Ring;
  const row = (number: number) => [ring(2 * number), ring(2 * number + 1), ring(2 * number + 2)] as const;
  for (let number = 0; 2 * number + 2 < rings.length; number += 1) weaving.wall(...row(number), holes[number]);
  for (const end of [ring(0), ring(rings.length - 1)]) {
    const height = end.reduce((sum, [, , z]) => sum + z, 0) / end.length;
    const centre: Triple = [0, 0, height];
    weaving.disc(end, centre, (share, [x, y, z]) => [share * x, share * y, height + share * (z - height)]);
  }
  return (number: number, column: number): Ring => opening(...row(number), column);
}

/** A tube whose rings are given, corners and middles in turn. */
function tube(weaving: Weaving, rings: readonly Ring[]): void {
  for (let row = 0; row + 2 < rings.length; row += 2) {
    weaving.wall(rings[row] as Ring, rings[row + 1] as Ring, rings[row + 2] as Ring);
  }
}

/** A ring across a tube at a point of the plane y = 0, half as wide and half as thick as told: from its outer side on, which looks along `out`. */
function across(at: Spot, out: Spot, [wide, thick]: Spot): Ring {
  // A little more than on an ellipse: four parabolas go round it.
  const corner = 1.12 * Math.SQRT1_2;
  const point = (side: number, layer: number): Triple => [
    at[0] + layer * thick * out[0],
    side * wide,
    at[1] + layer * thick * out[1],
  ];
  return [
    point(-corner, corner),
    point(0, 1),
    point(corner, corner),
    point(1, 0),
    point(corner, -corner),
    point(0, -1),
    point(-corner, -corner),
    point(-1, 0),
  ];
}

/** Rings across a tube at so many places of its way: where it is, where its outer side looks, and how wide and thick it is. */
function along(count: number, of: (share: number) => readonly [at: Spot, out: Spot, size: Spot]): readonly Ring[] {
  return Array.from({ length: count }, (_, place) => across(...of((place + 1) / (count + 1))));
}

/** Half an ellipse about a point, from `from` to `to`, in turns: a handle. */
function bow([x, z]: Spot, [a, b]: Spot, [from, to]: Spot, size: Spot) {
  return (share: number) => {
    const angle = 2 * Math.PI * (from + share * (to - from));
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const length = Math.hypot(b * c, a * s);
    return [[x + a * c, z + b * s], [(b * c) / length, (a * s) / length], size] as const;
  };
}

/** What goes round an opening that looks along x, as a ring across a tube: its outer side above, or below. */
const above = (hole: Ring) => turned(hole, 6, true);
const below = (hole: Ring) => hole;

function mug(): VertexFrame {
  const weaving = new Weaving();
  const profile: Profile = [
    ...([
      [3.6, 0],
      [3.8, 0.12],
      [3.95, 0.5],
      [4, 1.2],
      [4, 1.9],
      [4, 2.5],
      [4, 3.1],
      [4, 4.65],
      [4, 6.2],
    ] as const),
    ...([
      [4, 6.8],
      [4, 7.4],
      [4, 8.2],
      [4, 8.9],
      [3.98, 9.3],
      [3.8, 9.4],
      [3.62, 9.3],
      [3.6, 8.9],
    ] as const),
    ...([
      [3.6, 7],
      [3.6, 5],
      [3.6, 3],
      [3.6, 1.4],
      [3.5, 0.8],
      [3, 0.55],
    ] as const),
  ];
  const hole = vessel(weaving, profile, { 2: [EAST], 4: [EAST] });
  const handle = along(7, bow([4.1, 4.65], [3.1, 2.15], [0.25, -0.25], [0.75, 0.5]));
  tube(weaving, [above(hole(4, EAST)), ...handle, below(hole(2, EAST))]);
  return weaving.network();
}

/** A handle by itself: its ends are closed, and stand `reach` from the axis of the pot whose wall they run into. */
export function handle(reach: number, height: number, [far, half]: Spot, size: Spot): VertexFrame {
  const weaving = new Weaving();
  const way = bow([reach, height], [far, half], [0.25, -0.25], size);
  const rings = Array.from({ length: 9 }, (_, place) => across(...way(place / 8)));
  tube(weaving, rings);
  for (const ring of [rings[0], rings.at(-1)] as readonly [Ring, Ring]) {
    const z = ring.reduce((sum, point) => sum + point[2] / ring.length, 0);
    weaving.disc(ring, [reach, 0, z], (share, point) => [reach, share * point[1], z + share * (point[2] - z)]);
  }
  return weaving.network();
}

function basket(): VertexFrame {
  const weaving = new Weaving();
  const profile: Profile = [
    ...([
      [5, 0],
      [6, 0.25],
      [7, 1],
      [8.4, 2.8],
      [9.2, 5],
      [9.7, 7],
      [10, 9],
      [9.7, 9.35],
      [9.4, 9],
    ] as const),
    ...([
      [9.1, 7],
      [8.6, 5],
      [7.8, 3],
      [6.6, 1.4],
      [5.8, 0.9],
      [4.8, 0.7],
    ] as const),
  ];
  const hole = vessel(weaving, profile, { 3: [EAST, WEST] });
  const arch = along(11, bow([0, 9.2], [9.7, 12], [0, 0.5], [1.7, 0.5]));
  tube(weaving, [hole(3, EAST), ...arch, turned(hole(3, WEST), 2, true)]);
  return weaving.network();
}

function teapot(): VertexFrame {
  const weaving = new Weaving();
  const profile: Profile = [
    ...([
      [4.2, 0],
      [5.2, 0.2],
      [6, 0.9],
      [6.8, 1.9],
      [7.2, 2.9],
      [7.45, 3.7],
      [7.5, 4.6],
      [7.3, 5.8],
    ] as const),
    ...([
      [6.8, 7],
      [6, 8.1],
      [5, 8.9],
      [4.5, 9.2],
      [4.1, 8.8],
      [5.5, 7.75],
      [6.3, 6.75],
      [6.8, 5.6],
    ] as const),
    ...([
      [7, 4.6],
      [6.95, 3.7],
      [6.7, 3],
      [6.35, 2.1],
      [5.6, 1.2],
      [5, 0.8],
      [4, 0.6],
    ] as const),
  ];
  const hole = vessel(weaving, profile, { 1: [EAST], 2: [WEST], 3: [EAST], 8: [WEST] });
  const handle = along(7, bow([6.9, 3.9], [4, 2.1], [0.25, -0.25], [0.8, 0.55]));
  tube(weaving, [above(hole(3, EAST)), ...handle, below(hole(1, EAST))]);
  // The spout goes out and turns up; it narrows, and its bore with it.
  const spout = (less: number) => (share: number) => {
    const way: Spot = [-7.6 - 6 * share, 3.65 + 1.2 * share + 3.6 * share * share];
    const [x, z] = [-6, 1.2 + 7.2 * share];
    const length = Math.hypot(x, z);
    const size: Spot = [1.6 - 0.75 * share - less, 1.0 - 0.25 * share - less];
    return [way, [z / length, -x / length], size] as const;
  };
  const [shell, bore] = [along(5, spout(0)), along(5, spout(0.35))];
  const [lip, tip, mouth] = [spout(0), spout(0.17), spout(0.35)].map((of) => of(1));
  const end = (of: ReturnType<ReturnType<typeof spout>> | undefined, by: number): Ring => {
    const [[x, z], out, size] = of ?? spout(0)(1);
    return across([x - by * out[1], z + by * out[0]], out, size);
  };
  tube(weaving, [
    turned(hole(2, WEST), 4),
    ...shell,
    end(lip, 0),
    end(tip, 0.12),
    end(mouth, 0),
    ...bore.toReversed(),
    turned(hole(8, WEST), 2, true),
  ]);
  return weaving.network();
}

function hat(): VertexFrame {
  const weaving = new Weaving();
  const profile: Profile = [
    ...([
      [5.8, 11.9],
      [7, 11.5],
      [7.3, 10.4],
      [7.6, 7],
      [8.1, 3.4],
      [8.6, 2.3],
      [9.8, 1.8],
      [13, 1.2],
      [16, 1.8],
    ] as const),
    ...([
      [16.2, 1.6],
      [16, 1.4],
      [13, 0.8],
      [9.6, 1.35],
      [8.2, 1.8],
      [7.7, 3.2],
      [7.2, 6.8],
      [6.9, 10.1],
    ] as const),
    ...([
      [6.6, 11],
      [5.6, 11.4],
    ] as const),
  ];
  // The brim turns up at the sides; a head is longer than it is wide.
  const round: Round = (radius, angle, height) => {
    const brim = Math.max(0, radius - 8.6) / 7.6;
    const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return [0.92 * x, 1.1 * y, height + 2.2 * brim * brim * Math.cos(2 * angle)];
  };
  vessel(weaving, profile, {}, round);
  return weaving.network();
}

function dress(): VertexFrame {
  const weaving = new Weaving();
  const outside: Profile = [
    ...([
      [13.6, 0],
      [12.6, 3],
      [11.4, 6.5],
      [10, 10],
      [8.4, 13.5],
      [6.8, 17],
      [5.6, 20],
      [5.2, 21.5],
      [5.3, 23],
    ] as const),
    ...([
      [5.9, 25],
      [6.5, 27],
      [6.6, 28.6],
      [6.2, 30],
    ] as const),
  ];
  const profile: Profile = [
    ...outside,
    [6, 30.15],
    ...outside.toReversed().map(([radius, height]) => [radius - 0.4, height] as const),
    [13.4, -0.15],
    ...outside.slice(0, 1),
  ];
  const folds = 8;
  const round: Round = (radius, angle, height) => {
    const fold = 1 + 0.07 * (Math.max(0, 20 - height) / 20) * Math.cos(folds * angle);
    return [radius * fold * Math.cos(angle), 0.72 * radius * fold * Math.sin(angle), height];
  };
  const rings = profile.map(([radius, height]) => ringOf(2 * folds, (angle) => round(radius, angle, height)));
  tube(weaving, rings);
  return weaving.network();
}

/** A push of a rectangle towards the eye, at its crest so far; against y, and over whatever patches it lies on. */
function push(far: number, u: readonly [number, number], v: readonly [number, number]) {
  return { f0: [0, Number((2 * Math.PI ** 2 * far).toPrecision(6)), 0] as const, u, v, falloff: "smooth" as const };
}

function face(): VertexFrame {
  const weaving = new Weaving();
  const [columns, rows] = [4, 5];
  const point = (u: number, v: number): Triple => {
    const [s, t] = [(2 * u) / columns - 1, (2 * v) / rows - 1];
    const wide = 6.6 * Math.sqrt(1 - 0.5 * t * t) * (t < 0 ? 1 + 0.22 * t : 1);
    return [wide * Math.sin(1.15 * s), -5.2 * Math.cos(1.15 * s) * Math.sqrt(1 - 0.55 * t * t), 10 + 9.5 * t];
  };
  // By the patch in the lower left corner of what is pushed, in columns and rows.
  const forces: Readonly<Record<string, readonly ReturnType<typeof push>[]>> = {
    "1 2": [push(2.4, [0.62, 1.38], [0.05, 1.25]), push(0.7, [0.3, 1.7], [0, 0.6])],
    "1 3": [
      push(-0.9, [-0.15, 0.8], [0.02, 0.72]),
      push(0.5, [0.05, 0.6], [0.2, 0.55]),
      push(0.6, [-0.2, 0.9], [0.6, 1.1]),
    ],
    "2 3": [
      push(-0.9, [0.2, 1.15], [0.02, 0.72]),
      push(0.5, [0.4, 0.95], [0.2, 0.55]),
      push(0.6, [0.1, 1.2], [0.6, 1.1]),
    ],
    "1 1": [push(0.75, [0.4, 1.6], [0.5, 0.82]), push(0.8, [0.45, 1.55], [0.18, 0.5])],
    "1 0": [push(1.2, [0.3, 1.7], [0.25, 1.1])],
  };
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const at = (u: number, v: number) => point(column + u, row + v);
      const own = forces[`${column} ${row}`];
      weaving.patch(
        [at(0, 0), at(0.5, 0), at(1, 0), at(1, 0.5), at(1, 1), at(0.5, 1), at(0, 1), at(0, 0.5)],
        own && { forces: own },
      );
    }
  }
  return weaving.network();
}

/** Eight points of a leaf: what the single patches begin as. */
const LEAF: readonly Triple[] = [
  [-6, -6, 0],
  [0, -7, 3],
  [6, -6, 0],
  [7, 0, -2],
  [6, 6, 0],
  [0, 7, 3],
  [-6, 6, 0],
  [-7, 0, -2],
];

type More = Omit<VertexFrame["patches"][number], "frame">;

function leaf(more: More): VertexFrame {
  const weaving = new Weaving();
  weaving.patch(LEAF, more);
  return weaving.network();
}

function upward(far: number): Triple {
  return [0, 0, Number((-2 * Math.PI ** 2 * far).toPrecision(6))];
}

const dent = (far: number, u: readonly [number, number], v: readonly [number, number]) => ({
  f0: upward(far),
  u,
  v,
  falloff: "smooth" as const,
});

export const NETWORKED = exhibits([
  { id: "own-mug", shape: mug(), look: { glaze: "celadon", clay: "stoneware" } },
  { id: "own-basket", shape: basket(), look: { glaze: "tenmoku", clay: "stoneware" } },
  { id: "own-spouted", shape: teapot(), look: { glaze: "cobalt", clay: "porcelain" } },
  { id: "own-hat", shape: hat(), look: { glaze: "shino", clay: "stoneware" } },
  { id: "own-dress", shape: dress(), look: { glaze: "copper-red", clay: "porcelain" } },
  { id: "own-face", shape: face(), look: { glaze: "bare", clay: "terracotta" } },
  { id: "own-leaf", shape: leaf({}), look: { glaze: "celadon", clay: "porcelain" } },
  {
    id: "own-leaf-pushed",
    shape: leaf({ forces: [{ f0: upward(4) }] }),
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "own-leaf-regions",
    shape: leaf({ forces: [dent(3, [0.12, 0.5], [0.12, 0.5]), dent(-2.5, [0.55, 0.9], [0.5, 0.9])] }),
    look: { glaze: "celadon", clay: "porcelain" },
  },
]);
