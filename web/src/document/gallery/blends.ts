/** Pots between two sections, in centimetres, each with its wall; and the examples of the paper. */

import { between } from "../blend/between";
import type { Section, Triple } from "../types";
import { exhibits } from "./exhibit";

/** With so little corners go all the way. */
const STRAIGHT: Triple = [1, 0.001, 1];

export const BLENDED = exhibits([
  {
    id: "own-square-round-bowl",
    shape: between(
      { radius: 3.8, count: 4, corners: 0.7, at: 45 },
      { radius: 8.6 },
      { z: [0, 8.4], taper: [2.2, 0.4], dz: [4, 12] },
    ),
    wall: { thickness: 0.45, base: 0.7, rim: "rounded" },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "own-star-dish",
    shape: between(
      { radius: 4.6 },
      { radius: 11, count: 5, petals: 0.2, corners: 0.45 },
      { z: [0, 4.6], taper: [2.2, 0.7], dz: [1.2, 6] },
    ),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "own-twisted-square",
    shape: between(
      { radius: 5, count: 4, corners: 0.6, at: 45 },
      { radius: 5.2, count: 4, corners: 0.6, at: 45, turn: 75 },
      { z: [0, 25], taper: [0.7, 0.3], dz: [24, 24], weights: STRAIGHT },
    ),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "tin-white", clay: "porcelain" },
  },
  {
    id: "own-petal-planter",
    shape: between(
      { radius: [8.5, 5.6] },
      { radius: [11.4, 8], count: 8, petals: 0.13 },
      { z: [0, 14], taper: [0.5, 0.5], dz: [15, 13] },
    ),
    wall: { thickness: 0.6, base: 0.8, rim: "rounded", drain: 1.6 },
    look: { glaze: "bare", clay: "terracotta" },
  },
  {
    id: "own-three-sided-bottle",
    shape: between(
      { radius: 5.6, count: 3, corners: 0.55 },
      { radius: 2.1 },
      { z: [0, 22], taper: [1.6, 0.5], dz: [18, 34] },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "tenmoku", clay: "stoneware", line: 0.1 },
  },
  {
    id: "own-six-sided-jar",
    shape: between(
      { radius: 4.6, count: 6, corners: 0.55, at: 30 },
      { radius: 4.2, count: 6, corners: 0.55, at: 30 },
      { z: [0, 17], taper: [3.4, -3.8], dz: [16, 12], weights: STRAIGHT },
    ),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "own-flower-bowl",
    shape: between(
      { radius: 3.4 },
      { radius: 9, count: 6, petals: 0.16 },
      { z: [0, 7.4], taper: [2, 0.8], dz: [3, 8] },
    ),
    wall: { thickness: 0.4, base: 0.8, rim: "rounded", foot: [0.6, 0.5] },
    look: { glaze: "shino", clay: "stoneware" },
  },
  {
    id: "own-crossed-ovals",
    shape: between(
      { radius: [7, 3.2] },
      { radius: [3, 7.4] },
      { z: [0, 22], taper: [0.1, 0.7], dz: [24, 22], weights: STRAIGHT },
    ),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "clear", clay: "terracotta" },
  },
]);

const level = (z: number, taper: number, dz: number) => ({ z, taper, dz });
const RECTANGLE = { form: "rectangle", radius: [1, 1], ...level(4, -0.01, -2) } as const satisfies Section;

/** The three examples of Zhang and You 2004, by the method of the paper. */
export const EXAMPLES = exhibits([
  {
    id: "zhang-you-2004-1",
    shape: {
      kind: "blend",
      start: RECTANGLE,
      end: { form: "rectangle", radius: [1.5, 2], ...level(2, -0.01, -2) },
      method: "collocation",
    },
  },
  {
    id: "zhang-you-2004-2",
    shape: {
      kind: "blend",
      start: { form: "disc", radius: [2, 3], ...level(3, -0.1, -2) },
      end: { form: "disc", radius: [1, 1], ...level(1, -0.1, -2) },
      method: "collocation",
    },
  },
  {
    id: "zhang-you-2004-3",
    shape: {
      kind: "blend",
      start: { form: "disc-in-square", radius: [1, 1], ...level(5, -0.01, -2) },
      end: { form: "rectangle-reversed", radius: [2, 1.25], ...level(3, -0.01, -2) },
      method: "collocation",
    },
  },
]);
