/** Pots through rings: pulled at the lip, squeezed, turned, cut into facets. No few numbers have such forms. In centimetres, each with its wall. */

import { bump, type Round, ringed, together, wave } from "../ringed";
import type { Wave } from "../types";
import { exhibits } from "./exhibit";

export const RINGED = exhibits([
  {
    id: "own-lipped-jug",
    shape: ringed(
      [
        4.6,
        6.3,
        7,
        6,
        [3.7, wave(2, -0.15)],
        together([3.5, wave(2, -0.3)], bump(0.5, 6)),
        together([3.9, wave(2, -0.3)], bump(2.6, 10)),
      ],
      [0, 3, 7.6, 12.4, 17, 20, together(22.6, bump(1.5, 6), [0, wave(2, -0.25)])],
      { a: 0.5 },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "tenmoku", clay: "stoneware", line: 0.1 },
  },
  {
    id: "own-squeezed-bottle",
    shape: ringed(
      [4.6, [5.6, wave(2, 0.5)], [5.7, wave(2, 1.5)], [4.4, wave(2, 0.2)], [3.4, wave(2, -0.75)], 1.9, 1.5, 2],
      [0, 3, 7, 12, 16, 20, 22.6, 25],
      { a: 0.5 },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-twisted-gourd",
    shape: turning(
      [4.2, 6.2, 7, 6.6, 5.1, 3.7, 3.5, 4.3, 4.8, 4.2, 2.8, 1.9, 1.9],
      [0, 2.2, 4.8, 7.4, 9.8, 12, 13.6, 15.4, 17.6, 19.8, 21.8, 23.4, 25.4],
      { n: 5, turn: 0.085, depths: [0.03, 0.08, 0.1, 0.1, 0.09, 0.08, 0.08, 0.09, 0.1, 0.08, 0.05, 0.02, 0] },
    ),
    wall: { thickness: 0.35, base: 0.6, rim: "rounded" },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-faceted-jar",
    shape: ringed(
      [facets(4.8, 0.9), facets(6.2, 1), facets(7.6, 1), facets(7.2, 1), facets(5.6, 0.6), [4.3], [4.4]],
      [0, 4, 9.4, 12.6, 14.8, 16, 17.4],
      { a: 0.5 },
    ),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "own-trefoil-jug",
    shape: ringed(
      [3.6, 5.2, 7.4, 7, 3.2, [2.6, wave(3, 0.15)], [3.4, wave(3, 0.95), wave(6, 0.12)]],
      [0, 3, 9.4, 13, 17.2, 19.8, [22.2, wave(3, 0.45), wave(1, 0.3)]],
      { a: 0.5 },
    ),
    wall: { thickness: 0.35, base: 0.6, rim: "rounded" },
    look: { glaze: "bare", clay: "black" },
  },
  {
    id: "own-bamboo",
    shape: ringed(
      [4.6, 4.1, 4.0, 4.7, 4.1, 3.9, 4.5, 3.9, 3.7, 4.3, 3.9, 4.1],
      [0, 1.6, 5.2, 6.8, 8.4, 12.6, 14.2, 15.8, 20.2, 21.8, 23.4, 26.5],
      { a: 0.3 },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "own-dancing-bottle",
    shape: ringed(
      [
        4.2,
        [5.2, wave(1, 0.6)],
        [4.6, wave(1, 1.1)],
        [3.2, wave(1, 0.4)],
        [2.4, wave(1, -0.4)],
        [1.6, wave(1, -0.4)],
        [1.5, wave(1, 0.1)],
        [2.1, wave(1, 0.3)],
      ],
      [0, 3, 7.4, 12, 16, 20, 23, 25.6],
      { a: 0.5 },
    ),
    wall: { thickness: 0.4, base: 0.7, rim: "rounded" },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "own-shell-bowl",
    shape: ringed(
      [3.4, shell(4, 0.3), shell(7.4, 0.8), shell(9.2, 1), shell(10.2, 1.2)],
      [0, 0.7, 3, 5.6, [7.6, wave(1, 1.1), wave(2, 0.25)]],
      { a: 0.5 },
    ),
    wall: { thickness: 0.4, base: 0.9, rim: "rounded", foot: [0.6, 0.5] },
    look: { glaze: "tin-white", clay: "terracotta" },
  },
  {
    id: "own-thumbed-cup",
    shape: ringed(
      [3.2, [4.3, wave(4, 0.05)], [4.5, wave(4, 0.52), wave(8, -0.1)], [4.4, wave(4, 0.08)], 4.4],
      [0, 1.3, 4.4, 7.6, 9.2],
      { a: 0.5 },
    ),
    wall: { thickness: 0.3, base: 0.6, rim: "rounded" },
    look: { glaze: "shino", clay: "stoneware" },
  },
  {
    id: "own-chevron-vase",
    shape: turning(
      [4.4, 5.2, 6.2, 6.9, 7.2, 7, 6.3, 5.2, 4.3, 4.2, 4.9],
      [0, 2.6, 5.4, 8.2, 11, 13.8, 16.4, 18.8, 21, 23, 25.4],
      {
        n: 12,
        turn: 0.14,
        depths: [0.01, 0.022, 0.028, 0.031, 0.032, 0.032, 0.03, 0.026, 0.02, 0.015, 0.012],
        back: 5,
      },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "clear", clay: "porcelain" },
  },
]);

/** Petals that go on by `turn` of a wave from ring to ring, and from the ring `back` on the other way. */
function turning(
  radii: readonly number[],
  heights: readonly number[],
  {
    n,
    turn,
    depths,
    back = radii.length,
  }: { readonly n: number; readonly turn: number; readonly depths: readonly number[]; readonly back?: number },
) {
  const turned = (at: number) => turn * (at <= back ? at : 2 * back - at);
  return ringed(
    radii.map((r, at): Round => [r, wave(n, r * (depths[at] ?? 0), turned(at))]),
    heights,
    { a: 0.3 },
  );
}

/** Flat sides, eight of them: the first two waves of an octagon about its mean radius, the second less than it has, so that the sides have no ripples. */
function facets(mean: number, share: number): readonly [number, ...Wave[]] {
  return [mean, ...[0.031, 0.0045].map((depth, at) => wave(8 * (at + 1), share * mean * depth))];
}

/** Ribs on one side that fade to nothing on the other: a wave of fourteen times `(1 + cos v) / 2`. */
function shell(mean: number, depth: number): Round {
  return [mean, wave(1, 0.06 * mean * depth), wave(13, 0.05 * depth), wave(14, 0.1 * depth), wave(15, 0.05 * depth)];
}
