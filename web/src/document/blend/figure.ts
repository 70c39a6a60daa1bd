/**
 * An outline in a potter's words: how wide and deep, how far turned, with so many corners or petals. Nothing is remembered beside the document: all of it is read from the series, and what has no
 * name in it stays as it is.
 *
 * Corners are those of the map of the outside of a regular polygon, `dz/dq = (1 - q^-n)^(2/n)` (Schwarz and Christoffel), on a circle so much wider that they are round.
 */

import type { Pair } from "../types";
import { type Complex, type OutlineSection, seriesOf, sizeOf, turnedBy, type Waves, waveAt, wavesOf } from "./waves";

/** What goes round so many times. */
export interface Ornament {
  readonly count: number;
  /** How far petals swing out and in, as a share of the radius. */
  readonly petals: number;
  /** From 0, round, to 1, as sharp as few waves can be. */
  readonly corners: number;
  /** Where the first of them is, in degrees from the axis of `y`, clockwise. */
  readonly turn: number;
}

export interface Figure {
  readonly radius: Pair;
  /** Of the whole section, anticlockwise from above, in degrees: what is turned at one end and not at the other is twisted in between. */
  readonly turn: number;
  readonly middle: Pair;
  readonly ornament: Ornament;
}

/** An outline that was read. */
interface Read extends Figure {
  /** Waves that are none of these, of a circle of radius 1. */
  readonly rest: Waves;
  /** How far its beginning is round from where the axes are, in radians. */
  readonly lag: number;
  /** Whether it runs the other way round. */
  readonly back: boolean;
}

/** The fewest of them that are corners or petals and no oval, and the most that a person is offered. */
export const COUNTS: Pair = [3, 24];
/** So many there would be where there are none. */
const USUAL = 5;
/** So many waves make corners. */
const CORNER_WAVES = 4;
const DEGREES = 180 / Math.PI;
/** What is less, beside the radius, was rounded. */
const SLIGHT = 1e-9;
/** Digits of what is read: those that were typed come back. */
const READ = 9;

export const PLAIN: Ornament = { count: USUAL, petals: 0, corners: 0, turn: 0 };

export function figureOf(outline: Pick<OutlineSection, "x" | "y">): Figure {
  const { radius, turn, middle, ornament } = read(outline);
  return { radius, turn, middle, ornament };
}

/** How many waves an outline has that no word of ours is for. */
export function restOf(outline: Pick<OutlineSection, "x" | "y">): number {
  return new Set([...read(outline).rest.keys()].map((k) => Math.abs(k))).size;
}

/** The series of a figure. */
export function outlineOf(figure: Figure): Pick<OutlineSection, "x" | "y"> {
  return written({ ...figure, rest: new Map(), lag: 0, back: false });
}

/** The outline with something of its figure changed; what has no name goes with it. */
export function withFigure(
  outline: Pick<OutlineSection, "x" | "y">,
  change: Partial<Figure>,
): Pick<OutlineSection, "x" | "y"> {
  return written({ ...read(outline), ...change });
}

function read(outline: Pick<OutlineSection, "x" | "y">): Read {
  const given = wavesOf(outline);
  const back = sizeOf(waveAt(given, -1)) > sizeOf(waveAt(given, 1));
  const at = (k: number) => waveAt(given, back ? -k : k);
  const [alpha, beta] = [angleOf(at(1)), angleOf(at(-1))];
  const isRound = sizeOf(at(-1)) <= SLIGHT * sizeOf(at(1));
  const lag = isRound ? 0 : quarter((alpha - beta) / 2);
  const angle = alpha - lag;
  const across = sizeOf(at(1));
  const [along] = isRound ? [0] : turnedBy(at(-1), lag - angle);
  const radius: Pair = [across - along, across + along];
  const framed = new Map(
    [...given.keys()].map((key) => {
      const k = back ? -key : key;
      return [k, turnedBy(at(k), -angle - k * lag)] as const;
    }),
  );
  const stretched = stretchedBy(framed, [1 / radius[0], 1 / radius[1]]);
  const [y, x] = waveAt(given, 0);
  return {
    radius: [neat(radius[0]), neat(radius[1])],
    turn: neat(-angle * DEGREES, 360),
    middle: [neat(x, across), neat(y, across)],
    ...ornamentIn(stretched),
    lag: Math.abs(lag) < SLIGHT ? 0 : lag,
    back,
  };
}

/** The largest of what goes round often enough, with what belongs to it; the rest. */
function ornamentIn(waves: Waves): { readonly ornament: Ornament; readonly rest: Waves } {
  const rest = new Map([...waves].filter(([k, c]) => Math.abs(k) !== 1 && k !== 0 && sizeOf(c) > SLIGHT));
  // The first of them: those of corners go on to multiples.
  const counts = [...rest.keys()].map((k) => 1 - k).filter((n) => n >= COUNTS[0]);
  const [count] = counts.sort((a, b) => sizeOf(waveAt(rest, 1 - b)) - sizeOf(waveAt(rest, 1 - a)) || a - b);
  if (count === undefined) return { ornament: PLAIN, rest };
  const forth = waveAt(rest, 1 - count);
  const round = angleOf(forth);
  const [half, aside] = turnedBy(waveAt(rest, 1 + count), round);
  const corners = (sizeOf(forth) - half) / cornerWave(count, 1);
  const ornament: Ornament = {
    count,
    petals: neat(2 * half, 1),
    corners: neat(corners, 1),
    turn: neat((round / count) * DEGREES, 360),
  };
  if (Math.abs(aside) > SLIGHT || half < -SLIGHT || corners < -SLIGHT) return { ornament: PLAIN, rest };
  const left = new Map(rest);
  for (const [k, [re, im]] of wavesIn(ornament)) {
    const [a, b] = waveAt(rest, k);
    const off: Complex = [a - re, b - im];
    if (sizeOf(off) > 10 * SLIGHT) left.set(k, off);
    else left.delete(k);
  }
  // What only looks like corners is a curve of its own.
  return left.size > rest.size - 1 ? { ornament: PLAIN, rest } : { ornament, rest: left };
}

/** What an ornament adds to a circle of radius 1. */
function wavesIn({ count, petals, corners, turn }: Ornament): Waves {
  const waves = new Map<number, Complex>();
  const add = (k: number, size: number, times: number) => {
    const [re, im] = turnedBy([size, 0], (times * count * turn) / DEGREES);
    const [a, b] = waveAt(waves, k);
    if (size !== 0) waves.set(k, [a + re, b + im]);
  };
  add(1 - count, petals / 2, 1);
  add(1 + count, petals / 2, -1);
  for (let times = 1; times <= CORNER_WAVES; times += 1)
    add(1 - times * count, cornerWave(count, times) * corners ** times, times);
  return waves;
}

/** The coefficient of `q^(1 - times n)` of the map of the outside of a polygon. */
function cornerWave(count: number, times: number): number {
  let binomial = 1;
  for (let k = 0; k < times; k += 1) binomial *= (2 / count - k) / (k + 1);
  return (binomial * (-1) ** times) / (1 - times * count);
}

function written({ radius, turn, middle, ornament, rest, lag, back }: Read): Pick<OutlineSection, "x" | "y"> {
  const round = new Map<number, Complex>(rest);
  for (const [k, [re, im]] of wavesIn(ornament)) {
    const [a, b] = waveAt(round, k);
    round.set(k, [a + re, b + im]);
  }
  round.set(1, [1, 0]);
  const angle = -turn / DEGREES;
  const placed = new Map<number, Complex>();
  for (const [k, wave] of stretchedBy(round, radius)) placed.set(back ? -k : k, turnedBy(wave, angle + k * lag));
  placed.set(0, [middle[1], middle[0]]);
  return seriesOf(placed, Math.max(...radius.map(Math.abs)));
}

/** `x` and `y` so many times as large. */
function stretchedBy(waves: Waves, [inX, inY]: Pair): Waves {
  const orders = new Set([...waves.keys()].flatMap((k) => [k, -k]));
  const [mean, half] = [(inY + inX) / 2, (inY - inX) / 2];
  return new Map(
    [...orders].map((k) => {
      const [re, im] = waveAt(waves, k);
      const [reBack, imBack] = waveAt(waves, -k);
      return [k, [mean * re + half * reBack, mean * im - half * imBack] as Complex];
    }),
  );
}

function angleOf([re, im]: Complex): number {
  return Math.atan2(im, re);
}

/** The same but for quarters of a turn, from minus an eighth to an eighth. */
function quarter(angle: number): number {
  const turn = Math.PI / 2;
  return angle - turn * Math.round(angle / turn);
}

/** With the digits that a person sees; 0 where it is nothing beside `unit`. */
function neat(value: number, unit = 0): number {
  return Math.abs(value) < SLIGHT * unit ? 0 : Number(value.toPrecision(READ));
}
