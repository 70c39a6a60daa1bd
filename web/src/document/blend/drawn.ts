/** A closed line that was drawn, as a Fourier series with few waves, and how far that is from the line. */

import { between, evenly, lengthOf, type Spot, turnAt } from "../drawn/knot";
import { type Complex, type OutlineSection, seriesOf, sizeOf, turnedBy, type Waves } from "./waves";

export interface DrawnOutline extends Pick<OutlineSection, "x" | "y"> {
  /** How many waves it has. */
  readonly waves: number;
  /** The curve, closed, where it is on the sheet. */
  readonly curve: readonly Spot[];
  /** No point of the line is further from it, in units of the sheet. */
  readonly off: number;
  /** Where its middle is on the sheet, and how far it reaches from there. */
  readonly middle: Spot;
  readonly reach: number;
}

/** The line is looked at in so many points, and where it turns by more than this, in radians. */
const POINTS = 1024;
const TURN = 0.1;
/** More waves than this are a line that trembles. */
export const MOST_WAVES = 96;
/** Where no tolerance is held, nothing is gained by trying every number of waves. */
const MORE = 1.25;

/**
 * The series with about as few waves as keep the line within `tolerance`, or as many as there may be. On the sheet y goes down. It begins straight behind its middle and goes round clockwise from above,
 * as the disc of the papers does, so that what it is blended with is not twisted. Null of a line that goes round no area.
 */
export function outlineThrough(line: readonly Spot[], tolerance: number): DrawnOutline | null {
  const [first] = line;
  if (!first || line.length < 3) return null;
  const closed = [...line, first];
  const even = evenly(closed, lengthOf(closed) / POINTS).slice(0, POINTS);
  if (even.length < POINTS) return null;
  const all = wavesThrough(even);
  const forth = sizeOf(all.get(1) ?? [0, 0]);
  if (!(Math.abs(areaOf(even)) > 1e-3 * lengthOf(closed) ** 2) || !(forth > 0)) return null;
  let count = 1;
  let made = kept(all, count);
  const places = [...even.map((spot, at) => ({ spot, share: at / POINTS })), ...cornersOf(closed)];
  const isForwards = areaOf(even) > 0;
  let off = farthest(places, isForwards, made);
  while (off > tolerance && count < MOST_WAVES) {
    count = Math.min(MOST_WAVES, Math.max(count + 1, Math.floor(count * MORE)));
    made = kept(all, count);
    off = farthest(places, isForwards, made);
  }
  const centre = all.get(0) ?? [0, 0];
  const middle: Spot = { x: centre[1], y: -centre[0] };
  const curve = Array.from({ length: POINTS / 2 }, (_, at) => spotAt(made, (2 * at) / POINTS));
  const reach = Math.max(...curve.map(({ x, y }) => Math.hypot(x - middle.x, y - middle.y)));
  return { ...seriesOf(begunBehind(made), forth), waves: count, curve, off, middle, reach };
}

/** The outline so many times as large, with the digits that a hand has: a link stays short. */
export function outlineBy({ x, y }: Pick<OutlineSection, "x" | "y">, factor: number): Pick<OutlineSection, "x" | "y"> {
  const largest = Math.max(...[...x, ...y].flatMap(({ cos = 0, sin = 0 }) => [Math.abs(cos), Math.abs(sin)]));
  // All go by one step: numbers that are the same stay the same, and what is not turned stays so.
  const places = Math.min(Math.max(DIGITS - 1 - Math.floor(Math.log10(factor * largest)), 0), MOST_PLACES);
  const by = (series: typeof x) =>
    series.flatMap(({ n, cos = 0, sin = 0 }) => {
      const [c, s] = [cos, sin].map((value) => Number((factor * value).toFixed(places))) as [number, number];
      return c === 0 && s === 0 ? [] : [{ n, ...(c !== 0 && { cos: c }), ...(s !== 0 && { sin: s }) }];
    });
  return { x: by(x), y: by(y) };
}

/** Of the largest number. */
const DIGITS = 6;
/** What a number is written with at most. */
const MOST_PLACES = 15;

/** Clockwise from above, whichever way it was drawn. */
function wavesThrough(even: readonly Spot[]): Waves {
  const round = areaOf(even) > 0 ? even : [...even].reverse();
  const waves = new Map<number, Complex>();
  for (let k = -MOST_WAVES; k <= MOST_WAVES; k += 1) {
    let [re, im] = [0, 0];
    for (const [at, spot] of round.entries()) {
      const angle = (-2 * Math.PI * k * at) / POINTS;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      // y + i x, upwards.
      re += -spot.y * c - spot.x * s;
      im += -spot.y * s + spot.x * c;
    }
    waves.set(k, [re / POINTS, im / POINTS]);
  }
  return waves;
}

/** Above 0 where it goes round clockwise as it is seen. */
function areaOf(line: readonly Spot[]): number {
  return line.reduce((sum, a, at) => {
    const b = line[(at + 1) % line.length] as Spot;
    return sum + (a.x * b.y - b.x * a.y) / 2;
  }, 0);
}

function kept(waves: Waves, count: number): Waves {
  return new Map([...waves].filter(([k]) => Math.abs(k) <= count));
}

interface Place {
  readonly spot: Spot;
  /** How much of the way round lies before it. */
  readonly share: number;
}

/** Where a closed line turns: between two points of many it may be further off than at both. */
function cornersOf(closed: readonly Spot[]): readonly Place[] {
  const length = lengthOf(closed);
  const around = [...closed.slice(-2, -1), ...closed];
  let done = 0;
  return closed.slice(0, -1).flatMap((spot, at) => {
    const share = done / length;
    done += between(spot, closed[at + 1] as Spot);
    return turnAt(around, at + 1, 1) > TURN ? [{ spot, share }] : [];
  });
}

/** How far any of these places is from the curve at the same share of the way, or nearer to it. */
function farthest(places: readonly Place[], isForwards: boolean, waves: Waves): number {
  return places.reduce((most, { spot, share }) => {
    const on = spotAt(waves, isForwards ? share : 1 - 1 / POINTS - share);
    return Math.max(most, Math.hypot(on.x - spot.x, on.y - spot.y));
  }, 0);
}

function spotAt(waves: Waves, share: number): Spot {
  let [up, right] = [0, 0];
  for (const [k, wave] of waves) {
    const [re, im] = turnedBy(wave, 2 * Math.PI * k * share);
    up += re;
    right += im;
  }
  return { x: right, y: -up };
}

/** About its middle, and from straight behind it on. */
function begunBehind(waves: Waves): Waves {
  const [re, im] = waves.get(1) ?? [1, 0];
  const begin = -Math.atan2(im, re);
  return new Map([...waves].filter(([k]) => k !== 0).map(([k, wave]) => [k, turnedBy(wave, k * begin)]));
}
