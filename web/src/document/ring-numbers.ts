/** A ring in a potter's words: how far it is from round and from level, each as a size and a turn. What is left over was pulled by hand. */

import type { Rings, Series } from "./types";

export type Hoop = Rings["rings"][number];
type Wave = NonNullable<Series["waves"]>[number];

/** What goes round a ring so many times: how far it swings, and where its first crest is, in degrees. */
export interface Swing {
  readonly n: number;
  readonly size: number;
  readonly turn: number;
}

/** Each is one wave of the radius or of the height: those with no number of their own have a fixed one. */
const SWINGS = {
  oval: { of: "r", n: 2 },
  petals: { of: "r", least: 3, usual: 5 },
  tilt: { of: "z", n: 1 },
  waves: { of: "z", least: 2, usual: 3 },
} as const;
export type SwingName = keyof typeof SWINGS;
export const SWING_NAMES = Object.keys(SWINGS) as readonly SwingName[];

const DEGREES = 180 / Math.PI;
/** Digits of a wave: with those of a document a turn comes back as it was typed. */
const DIGITS = 12;

/** Whether a person chooses how many there are. */
export function isCounted(name: SwingName): boolean {
  return "least" in SWINGS[name];
}

/** The fewest and the most that there may be of them. */
export function countsOf(name: SwingName): readonly [least: number, most: number] {
  const swing = SWINGS[name];
  return "least" in swing ? [swing.least, MOST] : [swing.n, swing.n];
}

const MOST = 48;

/** A swing of a ring; of petals and of waves the largest that it has. */
export function swingOf(ring: Hoop, name: SwingName): Swing {
  const swing = SWINGS[name];
  const all = ring[swing.of].waves ?? [];
  const fitting = all.filter(({ n }) => ("least" in swing ? n >= swing.least : n === swing.n));
  const sized = fitting.map((wave) => ({ ...wave, size: Math.hypot(wave.cos ?? 0, wave.sin ?? 0) }));
  const [largest] = sized.sort((a, b) => b.size - a.size || a.n - b.n);
  if (!largest || largest.size === 0) return { n: "least" in swing ? swing.usual : swing.n, size: 0, turn: 0 };
  const turn = (Math.atan2(largest.sin ?? 0, largest.cos ?? 0) * DEGREES) / largest.n;
  return { n: largest.n, size: read(largest.size), turn: read(turn) };
}

/** The ring with another swing in the place of one; the wave that is there already at its new number is written over. */
export function withSwing(ring: Hoop, name: SwingName, before: Swing, next: Swing): Hoop {
  const { of } = SWINGS[name];
  const others = (ring[of].waves ?? []).filter(({ n }) => n !== before.n && n !== next.n);
  const angle = (next.n * next.turn) / DEGREES;
  const [cos, sin] = [rounded(next.size * Math.cos(angle)), rounded(next.size * Math.sin(angle))];
  const wave = cos === 0 && sin === 0 ? [] : [{ n: next.n, ...(cos !== 0 && { cos }), ...(sin !== 0 && { sin }) }];
  const waves = [...others, ...wave].sort((a, b) => a.n - b.n);
  return { ...ring, [of]: withWaves(ring[of], waves) };
}

/** How many waves of a ring are none of those that have a name: what a hand has pulled. */
export function restOf(ring: Hoop): number {
  const named = SWING_NAMES.map((name) => ({ of: SWINGS[name].of, ...swingOf(ring, name) }));
  const isRest = (of: "r" | "z") => (wave: { readonly n: number }) =>
    !named.some((swing) => swing.of === of && swing.n === wave.n);
  return (["r", "z"] as const).reduce((sum, of) => sum + (ring[of].waves ?? []).filter(isRest(of)).length, 0);
}

/** The ring without any waves: round and level. */
export function madeRound(ring: Hoop): Hoop {
  return { ...ring, r: { mean: ring.r.mean }, z: { mean: ring.z.mean } };
}

export function withSharp({ sharp: _sharp, ...ring }: Hoop, sharp: boolean): Hoop {
  return sharp ? { ...ring, sharp } : ring;
}

/** The ring at another radius or height. */
export function withMean(ring: Hoop, of: "r" | "z", mean: number): Hoop {
  return ring[of].mean === mean ? ring : { ...ring, [of]: { ...ring[of], mean } };
}

/** The same round the axis, so many degrees further on. */
export function turnedSeries(series: Series, degrees: number): Series {
  const { mean, waves = [] } = series;
  if (degrees === 0) return series;
  return withWaves(
    { mean },
    waves.map(({ n, cos = 0, sin = 0 }) => {
      const angle = (n * degrees) / DEGREES;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      return waveOf(n, cos * c - sin * s, cos * s + sin * c);
    }),
  );
}

/** A wave with the digits that a document keeps. */
export function waveOf(n: number, cos: number, sin: number): Wave {
  const [c, s] = [Number(cos.toPrecision(DIGITS)), Number(sin.toPrecision(DIGITS))];
  return { n, ...(c !== 0 && { cos: c }), ...(s !== 0 && { sin: s }) };
}

export function withWaves({ mean }: Series, waves: NonNullable<Series["waves"]>): Series {
  return { mean, ...(waves.length > 0 && { waves }) };
}

/** Two digits less than are kept, so that what is read is what was typed. */
function read(value: number): number {
  return Number(value.toPrecision(DIGITS - 2));
}

function rounded(value: number): number {
  const short = Number(value.toPrecision(DIGITS));
  return Math.abs(short) < 1e-12 ? 0 : short;
}

/** The pot with an end whose slope nothing gives any more: the wall comes to it as straight as it can. */
export function withFreeEnd(pot: Rings, end: "foot" | "rim"): Rings {
  const { foot, rim, ...rest } = pot;
  return end === "foot" ? { ...rest, ...(rim && { rim }) } : { ...rest, ...(foot && { foot }) };
}
