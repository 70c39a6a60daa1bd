/**
 * The widget of ASB88 as 23 octants. Of it the paper says, as `docs/scenes.md` has it, how many there are, that each cylindrical hole is lined by four concave octants, and that eight are the outside
 * of the annulus. That leaves seven, of which nothing is known: here they are a plate round a second hole, a web and two ribs.
 */

import { moved, turned, unit } from "../moving";
import { UNMOVED, type WholePlacement } from "../placement";
import type { Octant, Part, Triple } from "../types";

/** An octant that is as good as a box, and the exponent by which another one is as good as a prism. */
const FLAT = 50;
/** `x^p + y^p <= 1` with a curve through the middle of the arc of a round hole: `2 (1 - 1 / sqrt 2)^p = 1`, to four digits. */
const CONCAVE = 0.5645;

/** In centimetres: half as wide as a hole, how thick plate and annulus are, and at which height the annulus has its middle. */
const HOLE = 1.6;
const PLATE = 1.4;
const RING = 2;
const MIDDLE = 8.2;
/** The circle round the square of a hole. */
const OUTSIDE = HOLE * Math.SQRT2;
/** How far from the annulus the hole of the plate is. */
const ASIDE = 5.6;

const octant = (...exponents: readonly [number, number, number]): Octant => ({ kind: "octant", exponents });

interface Piece {
  readonly shape: Octant;
  readonly place: WholePlacement;
}

const box = (scale: Triple, shift: Triple): Piece => ({
  shape: octant(FLAT, FLAT, FLAT),
  place: { ...UNMOVED, scale, shift },
});

/** Four times the same, a quarter of a turn apart, about the upright axis. */
function quarters(pieces: readonly Piece[]): readonly Piece[] {
  return [0, 1, 2, 3].flatMap((quarter) =>
    pieces.map(({ shape, place }) => ({
      shape,
      place: turned(place, unit(2), (quarter * Math.PI) / 2, [0, 0, 0]),
    })),
  );
}

/** What is left of a square when its round hole is taken out: in every corner one. */
function lining(thickness: number): readonly Piece[] {
  const corner: Piece = {
    shape: octant(CONCAVE, CONCAVE, FLAT),
    place: { ...UNMOVED, scale: [HOLE, HOLE, thickness], shift: [-HOLE, -HOLE, 0] },
  };
  return quarters([corner]);
}

/** What is round about a square within its circle: on every side the two halves of a segment, which are `x^2 + y = 1` as near as anyone sees. */
function rim(thickness: number): readonly Piece[] {
  const shape = octant(2, 1, FLAT);
  const high = OUTSIDE - HOLE;
  const half = (mirrored: boolean): Piece => ({
    shape,
    place: {
      ...UNMOVED,
      scale: [HOLE, mirrored ? -high : high, thickness],
      angle: mirrored ? -Math.PI : 0,
      shift: [0, HOLE, 0],
    },
  });
  return quarters([half(false), half(true)]);
}

/** The annulus upright, its hole along y. */
function annulus(): readonly Piece[] {
  return [...lining(RING), ...rim(RING)].map(({ shape, place }) => ({
    shape,
    place: moved(turned(place, unit(0), Math.PI / 2, [0, 0, 0]), [0, RING / 2, MIDDLE]),
  }));
}

/** The plate: four boxes about a hole. */
function plate(): readonly Piece[] {
  const [left, right, deep] = [-3.2, ASIDE + HOLE + 1.6, 3.2];
  return [
    box([ASIDE - HOLE - left, 2 * deep, PLATE], [left, -deep, 0]),
    box([right - ASIDE - HOLE, 2 * deep, PLATE], [ASIDE + HOLE, -deep, 0]),
    box([2 * HOLE, deep - HOLE, PLATE], [ASIDE - HOLE, -deep, 0]),
    box([2 * HOLE, deep - HOLE, PLATE], [ASIDE - HOLE, HOLE, 0]),
    ...lining(PLATE).map(({ shape, place }) => ({ shape, place: moved(place, [ASIDE, 0, 0]) })),
  ];
}

/** What the annulus stands on: a web up to the square of its hole, and a rib on either side of it. */
function web(): readonly Piece[] {
  const [wide, deep] = [1.2, 0.7];
  const rib: Piece = {
    shape: octant(1, FLAT, 1),
    place: { ...UNMOVED, scale: [1.7, 2 * deep, 3], shift: [wide, -deep, PLATE] },
  };
  return [
    box([2 * wide, 2 * deep, MIDDLE - HOLE - PLATE], [-wide, -deep, PLATE]),
    rib,
    { shape: rib.shape, place: turned(rib.place, unit(2), Math.PI, [0, 0, 0]) },
  ];
}

/** All of them glued into one object. */
export function widget(): readonly Part[] {
  const look = { glaze: "cobalt", clay: "porcelain" } as const;
  return [...annulus(), ...plate(), ...web()].map(({ shape, place }) => ({ shape, look, place }));
}
