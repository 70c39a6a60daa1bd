/** Octants of superspheres (ASB88), in centimetres: single ones, and eight around one point. */

import { alike } from "../octant/presets";
import type { Octant, Part, Triple } from "../types";
import { exhibits } from "./exhibit";

/** How far an octant reaches along each axis. */
const REACH = 6;

const SIGNS = [1, -1] as const;

/** The eight mirror images of an octant, which make a body that is whole: glued into one object. */
function whole(shape: Octant, [x, y, z]: Triple): readonly Part[] {
  const images = SIGNS.flatMap((above) => SIGNS.flatMap((left) => SIGNS.map((front) => [front, left, above] as const)));
  return images.map(([front, left, above]) => ({
    shape,
    place: { scale: [front * x, left * y, above * z], shift: [0, 0, z] },
  }));
}

const single = { scale: [REACH, REACH, REACH] } as const;

const CUSHION: Octant = { kind: "octant", exponents: [4, 4, 2] };
const STAR = alike(0.7);

export const OCTANTS = exhibits([
  { id: "own-octant-ball", shape: alike(2), place: single, look: { glaze: "celadon", clay: "porcelain" } },
  { id: "own-octant-box", shape: alike(8), place: single, look: { glaze: "cobalt", clay: "porcelain" } },
  { id: "own-octant-facet", shape: alike(1), place: single, look: { glaze: "shino", clay: "stoneware" } },
  { id: "own-octant-hollow", shape: alike(0.6), place: single, look: { glaze: "tenmoku", clay: "stoneware" } },
  { id: "own-octant-cushion", shape: CUSHION, parts: whole(CUSHION, [8, 8, 3]) },
  { id: "own-octant-star", shape: STAR, parts: whole(STAR, [8, 8, 8]) },
]);
