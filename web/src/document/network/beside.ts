/** One boundary and three surfaces over it: a patch of the equation, a bicubic Coons patch and a NURBS patch, as three parts of one scene (figures 7 and 8 of W22). */

import type { Design, GlazeName, Part, Triple, VertexFrame } from "../types";
import type { Network, Patch } from "./network";
import { pointOn } from "./surface";
import { Weaving } from "./weaving";

/** Eight points of a leaf that is raised at one side. */
const LEAF: readonly Triple[] = [
  [-6, -6, 0],
  [0, -7, 4],
  [6, -6, 0],
  [7, 0, -3],
  [6, 6, 2],
  [0, 7, 4],
  [-6, 6, 0],
  [-7, 0, -2],
];

/** What shapes the patch of the equation inside. */
export interface Shaping {
  readonly a1: number;
  readonly a2: number;
  /** How far the force raises the surface, in units of the document. */
  readonly height: number;
  /** How much of the patch it acts on, along either side. */
  readonly width: number;
}

export const USUAL: Shaping = { a1: 1, a2: 1, height: 3, width: 0.5 };

/** The three in their order, and the glaze that tells each from the others. */
export const SURFACES = [
  { name: "equation", glaze: "celadon" },
  { name: "coons", glaze: "shino" },
  { name: "nurbs", glaze: "cobalt" },
] as const satisfies readonly { readonly name: string; readonly glaze: GlazeName }[];

/** From the middle of one to that of the next. */
const APART = 17;

/** Coons and NURBS patches are drawn as so many patches a side through their own points: no screen shows the difference. */
const DENSE = 8;

type Curve = (t: number) => Triple;
type Surface = (u: number, v: number) => Triple;

export function besideOneAnother(shaping: Shaping): Design {
  const patch = patchOf(shaping);
  const sides = boundaryOf(network(patch));
  const shapes = [network(patch), woven(coons(sides)), woven(nurbs(sides))];
  const parts = SURFACES.map(
    ({ glaze }, place): Part => ({
      shape: shapes[place] as VertexFrame,
      place: { shift: [APART * (place - 1), 0, 0] },
      look: { glaze, clay: "porcelain" },
    }),
  );
  return { pasu: 1, parts: parts as [Part, ...Part[]] };
}

function patchOf({ a1, a2, height, width }: Shaping): Omit<Patch, "frame"> {
  // `-f0 / (pi^2 (a1 + a2))` at the crest.
  const f0 = Number((-height * Math.PI ** 2 * (a1 + a2)).toPrecision(9));
  const side = [0.5 - width / 2, 0.5 + width / 2] as const;
  const forces =
    height === 0 ? {} : { forces: [{ f0: [0, 0, f0] as const, u: side, v: side, falloff: "smooth" as const }] };
  return { a1: [a1, a1, a1], a2: [a2, a2, a2], ...forces };
}

function network(more: Omit<Patch, "frame">): VertexFrame {
  const weaving = new Weaving();
  weaving.patch(LEAF, more);
  return weaving.network();
}

interface Boundary {
  /** `v = 0`, `v = 1`, `u = 0`, `u = 1`. */
  readonly along: readonly [Curve, Curve];
  readonly across: readonly [Curve, Curve];
}

/** The edges of the patch; no force reaches them. */
function boundaryOf(of: Network): Boundary {
  return {
    along: [(t) => pointOn(of, 0, t, 0), (t) => pointOn(of, 0, t, 1)],
    across: [(t) => pointOn(of, 0, 0, t), (t) => pointOn(of, 0, 1, t)],
  };
}

/** Opposite edges blended by `1 - 3 t^2 + 2 t^3`, less what both pairs have in common (S. A. Coons, 1967). */
function coons({ along, across }: Boundary): Surface {
  const blend = (t: number) => t * t * (3 - 2 * t);
  return (u, v) => blended(along, across, [u, v], [blend(u), blend(v)]);
}

function blended(
  along: Boundary["along"],
  across: Boundary["across"],
  [u, v]: readonly [number, number],
  [p, q]: readonly [number, number],
): Triple {
  const corners: Curve = (t) => mixed(along[0](t), along[1](t), q);
  const one = mixed(along[0](u), along[1](u), q);
  const other = mixed(across[0](v), across[1](v), p);
  const both = mixed(corners(0), corners(1), p);
  return [one[0] + other[0] - both[0], one[1] + other[1] - both[1], one[2] + other[2] - both[2]];
}

function mixed(from: Triple, to: Triple, share: number): Triple {
  return [
    from[0] + share * (to[0] - from[0]),
    from[1] + share * (to[1] - from[1]),
    from[2] + share * (to[2] - from[2]),
  ];
}

/**
 * Bicubic, with sixteen control points of weight 1: those of the edges, which are cubics, and inside those that the same blending makes of them, linearly (G. Farin, *Curves and Surfaces for CAGD*, on the discrete
 * Coons patch).
 */
function nurbs({ along, across }: Boundary): Surface {
  const control = (curve: Curve): Curve => {
    const [a, b, c, d] = [0, 1 / 3, 2 / 3, 1].map(curve) as [Triple, Triple, Triple, Triple];
    const point = (k: 0 | 1 | 2, place: number) =>
      place === 1
        ? (-5 * a[k] + 18 * b[k] - 9 * c[k] + 2 * d[k]) / 6
        : (2 * a[k] - 9 * b[k] + 18 * c[k] - 5 * d[k]) / 6;
    const inner = (place: number): Triple => [point(0, place), point(1, place), point(2, place)];
    const all = [a, inner(1), inner(2), d];
    return (place) => all[Math.round(3 * place)] as Triple;
  };
  const both = ([one, other]: readonly [Curve, Curve]) => [control(one), control(other)] as const;
  const [alongNet, acrossNet] = [both(along), both(across)];
  const places = [0, 1 / 3, 2 / 3, 1];
  const net = places.map((u) => places.map((v) => blended(alongNet, acrossNet, [u, v], [u, v])));
  return (u, v) => {
    const [b, c] = [bernstein(u), bernstein(v)];
    const sum = (k: 0 | 1 | 2) =>
      net.reduce((all, row, i) => all + (b[i] ?? 0) * row.reduce((some, at, j) => some + (c[j] ?? 0) * at[k], 0), 0);
    return [sum(0), sum(1), sum(2)];
  };
}

function bernstein(t: number): readonly number[] {
  const s = 1 - t;
  return [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
}

function woven(surface: Surface): VertexFrame {
  const weaving = new Weaving();
  for (let row = 0; row < DENSE; row += 1) {
    for (let column = 0; column < DENSE; column += 1) {
      const at = (a: number, b: number) => surface((row + a) / DENSE, (column + b) / DENSE);
      weaving.patch([at(0, 0), at(0.5, 0), at(1, 0), at(1, 0.5), at(1, 1), at(0.5, 1), at(0, 1), at(0, 0.5)]);
    }
  }
  return weaving.network();
}
