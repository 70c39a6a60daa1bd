/**
 * A pot that nobody has thought of, drawn from the number of a seed: one of the forms in other proportions, with petals that may turn on their way up, oval or leaning, in a glaze of its own. The
 * same number is the same pot. What is drawn keeps to what clay can do: waves that a wall can follow, and a lean under which it stands.
 */

import { FORMS } from "./forms";
import { series, times, together, wave } from "./ringed";
import type { Design, Hoop, Look, Rings } from "./types";

/** Numbers drawn one after the other. */
interface Draw {
  between(low: number, high: number): number;
  chance(share: number): boolean;
  of<T>(all: readonly [T, ...T[]]): T;
}

/** Glazes beside the clays that they look well on. */
const LOOKS: readonly [Look, ...Look[]] = [
  { glaze: "celadon", clay: "porcelain" },
  { glaze: "celadon", clay: "stoneware" },
  { glaze: "tenmoku", clay: "stoneware" },
  { glaze: "cobalt", clay: "porcelain" },
  { glaze: "tin-white", clay: "porcelain" },
  { glaze: "tin-white", clay: "terracotta" },
  { glaze: "shino", clay: "stoneware" },
  { glaze: "copper-red", clay: "porcelain" },
  { glaze: "clear", clay: "stoneware" },
  { glaze: "bare", clay: "terracotta" },
  { glaze: "bare", clay: "black" },
];

type Place = (u: number) => number;

/** Where petals are as deep as they get, by the place along the profile. */
const EDGE: Place = (u) => u * u;
const PLACES: readonly [Place, ...Place[]] = [
  (u) => Math.sin(Math.PI * u) ** 2,
  EDGE,
  (u) => 0.4 + 0.6 * u,
  (u) => 0.85 - 0.4 * u,
];

/** The depth of a wave, in radii, over which the wall bends more tightly than it is thick: so much over the square of its number. */
const TIGHTEST = 2.6;
/** Waves turn by no more than this from one ring to the next: further apart they would wipe each other out. */
const TURN = 0.2;

export function surprise(seed: number): Design {
  const draw = drawing(seed);
  const form = draw.of(FORMS as readonly [(typeof FORMS)[number], ...typeof FORMS]);
  const { rings, ...rest } = form.shape as Rings;
  const grow = proportions(draw);
  const petals = draw.chance(0.8) ? petalled(draw, rings) : null;
  const oval = draw.chance(0.25) ? draw.between(0.04, 0.11) : 0;
  const lean = draw.chance(0.25) ? draw.between(0.03, 0.09) : 0;
  const away = draw.between(0, 1);
  const height = grow(rings.length - 1, rings).z;
  const edge = draw.chance(0.3)
    ? { n: draw.of([1, 2, 3, petals?.n ?? 4]), depth: draw.between(0.04, 0.12), at: draw.between(0, 1) }
    : null;
  const made = rings.map((hoop, at): Hoop => {
    const { r, z } = grow(at, rings);
    const last = at === rings.length - 1;
    const bent = Math.min(lean * z * hoop.u, 0.25 * r);
    const radius = together(
      times(hoop.r, r / hoop.r.mean),
      ...(petals
        ? [[0, wave(petals.n, petals.depth * r * petals.where(hoop.u), petals.turn * hoop.u + away)] as const]
        : []),
      ...(oval > 0 ? [[0, wave(2, oval * r, away)] as const] : []),
      ...(bent > 0 ? [[0, wave(1, bent, away)] as const] : []),
    );
    const top =
      last && edge ? ([0, wave(edge.n, Math.min(edge.depth * r, 0.06 * height) / edge.n, edge.at)] as const) : 0;
    return {
      u: hoop.u,
      r: series(radius),
      z: series(together(times(hoop.z, hoop.z.mean === 0 ? 1 : z / hoop.z.mean), top)),
    };
  });
  const look = { ...draw.of(LOOKS), ...(draw.chance(0.3) && { line: Number(draw.between(0.06, 0.3).toFixed(2)) }) };
  return {
    pasu: 1,
    parts: [
      {
        shape: { ...rest, rings: made },
        ...(form.wall && { wall: form.wall }),
        look: look.glaze === "bare" ? { glaze: look.glaze, ...(look.clay && { clay: look.clay }) } : look,
      },
    ],
  };
}

/** Taller or wider as a whole, and a belly that swells or slims on the way up. */
function proportions(draw: Draw) {
  const [wide, tall] = [draw.between(0.86, 1.18), draw.between(0.8, 1.25)];
  const [swell, often, from] = [draw.between(0, 0.1), draw.between(0.4, 1.2), draw.between(0, 1)];
  return (at: number, all: readonly Hoop[]) => {
    const { u = 0, r, z } = all[at] ?? {};
    const belly = 1 + swell * Math.sin(2 * Math.PI * (often * u + from));
    return { r: (r?.mean ?? 0) * wide * belly, z: (z?.mean ?? 0) * tall };
  };
}

/** Many shallow ones or few deep ones, upright or turning. */
function petalled(draw: Draw, rings: readonly Hoop[]) {
  const flat = (rings.at(-1)?.z.mean ?? 0) < (rings.at(-1)?.r.mean ?? 0) / 2;
  const n = draw.of([3, 3, 4, 5, 5, 6, 7, 8, 9, 10, 12, 16]);
  const gap = Math.max(...rings.map(({ u }, at) => u - (rings[at - 1]?.u ?? u)));
  return {
    n,
    // A plate has room for shallow ones alone, at its edge: deeper ones would run into the wall below.
    depth: Math.min(flat ? 0.035 : 0.12, TIGHTEST / (n * n)) * draw.between(0.5, 1),
    where: flat ? EDGE : draw.of(PLACES),
    turn: !flat && draw.chance(0.5) ? draw.between(-1, 1) * (TURN / gap) : 0,
  };
}

/** Mulberry32 of Tommy Ettinger: the state goes on by a constant, and each is stirred until no bit shows where it was. */
function drawing(seed: number): Draw {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let stirred = Math.imul(state ^ (state >>> 15), state | 1);
    stirred ^= stirred + Math.imul(stirred ^ (stirred >>> 7), stirred | 61);
    return ((stirred ^ (stirred >>> 14)) >>> 0) / 2 ** 32;
  };
  return {
    between: (low, high) => low + (high - low) * next(),
    chance: (share) => next() < share,
    of: (all) => all[Math.floor(next() * all.length)] ?? all[0],
  };
}
