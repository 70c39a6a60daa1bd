/**
 * Pots of rings in short: radii and heights from the foot to the rim. Where nothing else is said the rings are along the profile as far apart as they are in the clay, which lets the wall
 * run through them as a draughtsman's spline does.
 */

import type { Hoop, Rings, Series, Wave } from "./types";

/** A number that is the same all round, or a mean and what goes up and down about it. */
export type Round = number | readonly [mean: number, ...waves: readonly Wave[]];

/** What else a pot of rings may have. */
export type More = Partial<Pick<Rings, "a" | "foot" | "rim">>;

export function ringed(radii: readonly Round[], heights: readonly Round[], more: More = {}): Rings {
  const [r, z] = [radii.map(series), heights.map(series)];
  const along = places(r, z);
  const hoop = (at: number): Hoop => ({ u: along[at] ?? 0, r: r[at] ?? series(0), z: z[at] ?? series(0) });
  return { kind: "rings", ...more, rings: radii.map((_, at) => hoop(at)) };
}

/** A wave that goes `n` times round, with its first crest so many of its own turns on. */
export function wave(n: number, depth: number, turned = 0): Wave {
  const angle = 2 * Math.PI * turned;
  const [cos, sin] = [short(depth * Math.cos(angle)), short(depth * Math.sin(angle))];
  return { n, ...(cos !== 0 && { cos }), ...(sin !== 0 && { sin }) };
}

/** What a hand pulls out on one side: `height cos^(2 N)(v / 2)` as waves, and the mean that they are about. The larger `N`, the narrower it is. */
export function bump(height: number, N: number): readonly [mean: number, ...waves: readonly Wave[]] {
  const share = (n: number) => choose(2 * N, N - n) / 4 ** N;
  const waves = Array.from({ length: N }, (_, at) => ({ n: at + 1, cos: short(2 * height * share(at + 1)) }));
  return [short(height * share(0)), ...waves.filter(({ cos }) => cos !== 0)];
}

/** One thing on top of the other: means are added, and so are waves that go equally often round. */
export function together(...all: readonly Round[]): Round {
  const sums = new Map<number, { cos: number; sin: number }>();
  for (const { n, cos = 0, sin = 0 } of all.flatMap((each) =>
    typeof each === "number" ? [] : (each.slice(1) as Wave[]),
  )) {
    const sum = sums.get(n) ?? { cos: 0, sin: 0 };
    sums.set(n, { cos: sum.cos + cos, sin: sum.sin + sin });
  }
  const mean = all.reduce((sum: number, each) => sum + (typeof each === "number" ? each : each[0]), 0);
  const waves = [...sums]
    .sort(([a], [b]) => a - b)
    .map(([n, { cos, sin }]) => ({ n, ...(cos !== 0 && { cos: short(cos) }), ...(sin !== 0 && { sin: short(sin) }) }));
  return [short(mean), ...waves];
}

/** As a document has it. */
export function series(round: Round): Series {
  if (typeof round === "number") return { mean: round };
  const [mean, ...waves] = round;
  return waves.length === 0 ? { mean } : { mean, waves };
}

/** What a document has, so many times as large. */
export function times({ mean, waves = [] }: Series, factor: number): Round {
  return [mean * factor, ...waves.map(({ n, cos = 0, sin = 0 }) => ({ n, cos: cos * factor, sin: sin * factor }))];
}

/** In proportion to the way from mean to mean, from 0 to 1. */
function places(r: readonly Series[], z: readonly Series[]): readonly number[] {
  const mean = (all: readonly Series[], at: number) => all[at]?.mean ?? 0;
  let sum = 0;
  const ways = r.map((_, at) => {
    if (at > 0) sum += Math.sqrt((mean(r, at) - mean(r, at - 1)) ** 2 + (mean(z, at) - mean(z, at - 1)) ** 2);
    return sum;
  });
  return ways.map((way, at) => (at === r.length - 1 ? 1 : Math.round((1e3 * way) / sum) / 1e3));
}

/** Few digits: nobody's hand is better, and links are shorter. */
function short(value: number): number {
  return Math.round(1e4 * value) / 1e4;
}

/** The number of ways to choose `k` of `n`. */
function choose(n: number, k: number): number {
  return k <= 0 ? 1 : (choose(n, k - 1) * (n - k + 1)) / k;
}
