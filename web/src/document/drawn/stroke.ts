/** What a hand, a file or a picture drew as few knots: what trembles is smoothed, what turns sharply is a corner. */

import { between, evenly, type Knot, type Spot, turnAt } from "./knot";

/** Points of a line that is looked at, so far apart. */
const GAP = 2;

/** A corner turns by more than this, in radians, seen over so many points to either side: 40 degrees over 12 units. */
const TURN = 0.7;
const OVER = 6;
/** What is round turns half as much over half the way; what is sharp does not. */
const SHARP = 0.7;

/** How far knots may leave the line. */
const OFF = 1.4;

/** How much a line is smoothed, in points to either side. */
export type Smoothing = 0 | 1 | 2 | 4;

export function knotsOf(line: readonly Spot[], smoothing: Smoothing): readonly Knot[] {
  const even = evenly(line, GAP);
  if (even.length < 2) return [];
  const calm = smoothed(even, 0, even.length - 1, Math.min(smoothing, 1));
  const ends = [0, ...corners(calm), even.length - 1];
  const knots: Knot[] = [];
  for (let i = 0; i + 1 < ends.length; i += 1) {
    const [from, to] = [ends[i] as number, ends[i + 1] as number];
    const piece = smoothed(even, from, to, smoothing).slice(from, to + 1);
    const kept = thinned(piece, OFF);
    for (const spot of i === 0 ? kept : kept.slice(1)) knots.push({ ...spot, sharp: false });
    if (to !== even.length - 1) knots.push({ ...(knots.pop() as Knot), sharp: true });
  }
  return knots;
}

/** The points from one to another, both of which stay, each as the mean of those around it; nearer an end of fewer. */
function smoothed(line: readonly Spot[], from: number, to: number, reach: number): readonly Spot[] {
  return line.map((spot, i) => {
    const near = Math.min(reach, i - from, to - i);
    if (near <= 0) return spot;
    // Twice a mean is as good as a bell.
    let [x, y, weights] = [0, 0, 0];
    for (let k = -near; k <= near; k += 1) {
      const weight = near + 1 - Math.abs(k);
      const other = line[i + k] as Spot;
      x += weight * other.x;
      y += weight * other.y;
      weights += weight;
    }
    return { x: x / weights, y: y / weights };
  });
}

/** Which points are corners. */
function corners(line: readonly Spot[]): readonly number[] {
  const found: { at: number; turn: number }[] = [];
  for (let i = OVER; i + OVER < line.length; i += 1) {
    const turn = turnAt(line, i, OVER);
    if (turn < TURN || turnAt(line, i, OVER / 2) < SHARP * turn) continue;
    const last = found.at(-1);
    if (last && i - last.at <= OVER) {
      if (turn > last.turn) Object.assign(last, { at: i, turn });
    } else found.push({ at: i, turn });
  }
  return found.map(({ at }) => at);
}

/** As few of the points as keep the line within a distance (Ramer 1972, Douglas and Peucker 1973). */
function thinned(line: readonly Spot[], off: number): readonly Spot[] {
  const keep = new Set([0, line.length - 1]);
  const open: [number, number][] = [[0, line.length - 1]];
  for (let pair = open.pop(); pair; pair = open.pop()) {
    const [from, to] = pair;
    const [a, b] = [line[from] as Spot, line[to] as Spot];
    let [worst, most] = [-1, off];
    for (let i = from + 1; i < to; i += 1) {
      const away = awayFrom(line[i] as Spot, a, b);
      if (away > most) [worst, most] = [i, away];
    }
    if (worst < 0) continue;
    keep.add(worst);
    open.push([from, worst], [worst, to]);
  }
  return line.filter((_, i) => keep.has(i));
}

/** How far a point is from a straight piece. */
export function awayFrom(point: Spot, a: Spot, b: Spot): number {
  const squared = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
  const part = squared === 0 ? 0 : ((point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y)) / squared;
  const share = Math.min(1, Math.max(0, part));
  return between(point, { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) });
}
