/** What a new pot may begin as: twelve forms that everybody knows, as large as such a thing is, of rings, with the wall that makes them. In centimetres. */

import { exhibits } from "./gallery/exhibit";
import { bump, ringed, together, wave } from "./ringed";

export const FORMS = exhibits([
  {
    id: "form-cylinder",
    shape: ringed([4.3, 4.68, 4.78, 4.8, 4.8, 4.82], [0, 0.45, 1.4, 4, 9, 14.5], { a: 0.5 }),
    wall: { thickness: 0.4, base: 0.5, rim: "rounded" },
    look: { glaze: "tenmoku", clay: "stoneware", line: 0.12 },
  },
  {
    id: "form-bowl",
    shape: ringed([3.2, 3.5, 6.1, 7.9, 8.4], [0, 0.7, 2.4, 5.6, 7.6], { a: 0.5 }),
    wall: { thickness: 0.4, base: 0.9, rim: "rounded", foot: [0.6, 0.5] },
    look: { glaze: "celadon", clay: "stoneware" },
  },
  {
    id: "form-jar",
    shape: ringed([5, 6.4, 8, 7.4, 5.2, 4.8, 5.2], [0, 4, 9.6, 13.8, 16.2, 17, 18], { a: 0.5 }),
    wall: { thickness: 0.5, base: 0.6, rim: "rounded" },
    look: { glaze: "shino", clay: "stoneware", line: 0.1 },
  },
  {
    id: "form-bottle",
    shape: ringed([4.3, 5.3, 5.2, 2.6, 1.6, 1.55, 2.1], [0, 3.5, 9.5, 15.5, 19, 22.5, 25], { a: 0.5 }),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "cobalt", clay: "porcelain" },
  },
  {
    id: "form-vase",
    shape: ringed([4.2, 5.2, 7.2, 6.2, 3.6, 3.5, 4.8], [0, 6, 14.5, 19, 22.6, 24, 26.5], { a: 0.5 }),
    wall: { thickness: 0.45, base: 0.7, rim: "rounded" },
    look: { glaze: "copper-red", clay: "porcelain" },
  },
  {
    id: "form-teapot",
    shape: ringed([4.4, 6.6, 7.2, 5.6, 3.9, 3.7], [0, 2.4, 5.4, 8.7, 10, 10.9], { a: 0.5 }),
    wall: { thickness: 0.4, base: 0.5, rim: "flat" },
    look: { glaze: "bare", clay: "terracotta" },
  },
  {
    id: "form-planter",
    shape: ringed([6.4, 7.4, 9.2, 9.9, 10.2], [0, 5, 12.4, 14, 15.5], { a: 0.5 }),
    wall: { thickness: 0.7, base: 0.9, rim: "rounded", drain: 1.6 },
    look: { glaze: "bare", clay: "terracotta" },
  },
  {
    id: "form-cup",
    shape: ringed([2.7, 3.7, 4.1, 4.05, 4.2], [0, 1.3, 3.8, 6.8, 8.6], { a: 0.5 }),
    wall: { thickness: 0.3, base: 0.6, rim: "rounded", foot: [0.45, 0.35] },
    look: { glaze: "tin-white", clay: "porcelain" },
  },
  {
    id: "form-plate",
    shape: ringed([7.2, 8.2, 10.6, 12.6, 13.4], [0, 0.5, 1.1, 2.2, 2.9], { a: 0.5 }),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded", foot: [0.7, 0.4] },
    look: { glaze: "clear", clay: "stoneware" },
  },
  {
    id: "form-jug",
    shape: ringed(
      [4.3, 6.2, 6.4, 4.4, together(3.5, bump(0.5, 6)), together(3.7, bump(2.4, 8))],
      [0, 4, 8.6, 14, 17.2, together(19.6, bump(1.2, 6))],
      { a: 0.5 },
    ),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "porcelain" },
  },
  {
    id: "form-moon-jar",
    shape: ringed(
      [5.2, 9.2, [11.3, wave(1, 0.15), wave(2, 0.12, 0.2)], 9.2, 5.7, 5.6],
      [0, 3.9, 10.2, 16.6, 19.9, 21],
      { a: 0.5 },
    ),
    wall: { thickness: 0.5, base: 0.8, rim: "rounded", foot: [0.8, 0.5] },
    look: { glaze: "tin-white", clay: "porcelain" },
  },
  {
    id: "form-gourd",
    shape: ringed([4.2, 6.6, 6.3, 3.4, 3.3, 4.3, 2.9, 1.4, 1.7], [0, 4, 8, 12.6, 13.6, 17, 20.4, 22.6, 24.5], {
      a: 0.5,
    }),
    wall: { thickness: 0.4, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "stoneware" },
  },
]);
