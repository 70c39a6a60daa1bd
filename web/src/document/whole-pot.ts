/**
 * A pot of rings as a whole: what a slider for all of it does to every ring. Each is linear in the numbers of the pot, and is applied to the pot as it was when the first of them was touched, so that
 * a slider there and back leaves the same pot.
 */

import { type Hoop, turnedSeries, waveOf, withWaves } from "./ring-numbers";
import type { Rings, Series } from "./types";

/** Where petals are strongest. */
export type PetalsAt = "all" | "rim" | "belly" | "foot";
export const PETALS_AT: readonly PetalsAt[] = ["all", "rim", "belly", "foot"];

/** What is changed, from how the pot was. */
export interface Whole {
  /** Factors of all heights and of all radii. */
  readonly height: number;
  readonly width: number;
  /** How far the rim is turned against the foot, in degrees. */
  readonly twist: number;
  /** How far the rim stands beside the foot, as a share of the height. */
  readonly lean: number;
  /** How much longer one way than round, as a share of every radius. */
  readonly oval: number;
  /** How much wider the rim and narrower the foot, as a share of every radius. */
  readonly taper: number;
  /** How deep petals are, as a share of every radius; how many, and where. */
  readonly depth: number;
  readonly petals: number;
  readonly at: PetalsAt;
  /** How deep flutes are from ridge to groove, as a share of every radius, and how many. */
  readonly flutes: number;
  readonly fluteCount: number;
}

export const UNCHANGED: Whole = {
  height: 1,
  width: 1,
  twist: 0,
  lean: 0,
  oval: 0,
  taper: 0,
  depth: 0,
  petals: 5,
  at: "all",
  flutes: 0,
  fluteCount: 20,
};

/** A flute is a round groove between two ridges, `-|cos|` of half the angle, of which two waves are kept: the second is so much of the first, and both together are this deep for each unit of that. */
const SECOND = -1 / 5;
const DEEP = 2;

/** Digits that a number of a document keeps. */
const DIGITS = 12;

/** The pot with all of it changed; the very same where nothing is. */
export function changed(pot: Rings, whole: Whole): Rings {
  if (isUnchanged(whole)) return pot;
  const rings = pot.rings.map((ring, index) => ringOf(ring, shareOf(pot, index), whole, heightOf(pot)));
  const { foot, rim } = pot;
  const slopes = <S extends { readonly r: Series; readonly z: Series }>(given: S, share: number): S => ({
    ...given,
    r: turnedSeries(scaled(given.r, whole.width * taperAt(whole.taper, share)), whole.twist * share),
    z: turnedSeries(scaled(given.z, whole.height), whole.twist * share),
  });
  return { ...pot, rings, ...(foot && { foot: slopes(foot, 0) }), ...(rim && { rim: slopes(rim, 1) }) };
}

function isUnchanged({ petals: _petals, at: _at, fluteCount: _count, ...sizes }: Whole): boolean {
  return Object.entries(sizes).every(([name, value]) => value === UNCHANGED[name as keyof Whole]);
}

/** From the foot to the rim. */
export function heightOf({ rings }: Rings): number {
  return (rings.at(-1)?.z.mean ?? 0) - (rings[0]?.z.mean ?? 0);
}

/** Across the widest ring. */
export function widthOf({ rings }: Rings): number {
  return 2 * rings.reduce((most, { r }) => Math.max(most, Math.abs(r.mean)), 0);
}

/** How high a ring is, from 0 at the foot to 1 at the rim; where it is along the profile in a pot without height. */
function shareOf(pot: Rings, index: number): number {
  const ring = pot.rings[index];
  const height = heightOf(pot);
  if (!ring) return 0;
  return height === 0 ? ring.u : (ring.z.mean - (pot.rings[0]?.z.mean ?? 0)) / height;
}

function ringOf(ring: Hoop, share: number, whole: Whole, height: number): Hoop {
  const wider = whole.width * taperAt(whole.taper, share);
  const r = turnedSeries(scaled(ring.r, wider), whole.twist * share);
  const z = turnedSeries(scaled(ring.z, whole.height), whole.twist * share);
  const added = [
    { n: 1, cos: whole.lean * share * height * whole.height },
    { n: 2, cos: whole.oval * r.mean },
    { n: whole.petals, cos: whole.depth * strength(whole.at, share) * r.mean },
    { n: whole.fluteCount, cos: (-whole.flutes / DEEP) * r.mean },
    { n: 2 * whole.fluteCount, cos: ((-whole.flutes * SECOND) / DEEP) * r.mean },
  ];
  return { ...ring, r: added.reduce(plus, r), z };
}

function taperAt(taper: number, share: number): number {
  return 1 + taper * (share - 0.5);
}

function strength(at: PetalsAt, share: number): number {
  switch (at) {
    case "all":
      return 1;
    case "rim":
      return share * Math.abs(share);
    case "belly":
      return Math.max(0, 4 * share * (1 - share));
    case "foot":
      return (1 - share) * Math.abs(1 - share);
  }
}

function scaled({ mean, waves = [] }: Series, factor: number): Series {
  if (factor === 1) return { mean, ...(waves.length > 0 && { waves }) };
  return withWaves(
    { mean: rounded(mean * factor) },
    waves.map(({ n, cos = 0, sin = 0 }) => waveOf(n, cos * factor, sin * factor)),
  );
}

function plus(series: Series, { n, cos }: { readonly n: number; readonly cos: number }): Series {
  if (cos === 0) return series;
  const { waves = [] } = series;
  const there = waves.find((wave) => wave.n === n);
  const wave = waveOf(n, (there?.cos ?? 0) + cos, there?.sin ?? 0);
  const others = waves.filter((each) => each.n !== n);
  return withWaves(
    series,
    [...others, wave].sort((a, b) => a.n - b.n),
  );
}

function rounded(value: number): number {
  return Number(value.toPrecision(DIGITS));
}
