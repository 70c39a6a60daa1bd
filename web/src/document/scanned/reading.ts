/** What the levels of a scan say: its mean outline, and the waves round a ring. */

import type { Hoop } from "../ring-numbers";
import type { Rings, Wave } from "../types";
import type { Levels } from "./levels";
import { DIRECTIONS, middle } from "./section";

/** Waves go round at most so often: finer ones are the texture of the clay. */
const FINEST = 16;

/** Middles of the radii of each level, in pairs with its height, from the foot to the rim: half of what is around is further out. */
export function outlineOf({ heights, radii }: Levels): readonly number[] {
  return heights.flatMap((height, i) => [middle(radii[i] as Float64Array), height]);
}

/** The section at a height, between those that were taken. */
function sectionAt({ heights, radii }: Levels, height: number): Float64Array {
  const above = heights.findIndex((each) => each >= height);
  const next = above < 0 ? heights.length - 1 : above;
  const before = Math.max(0, next - 1);
  const [low, high] = [heights[before] as number, heights[next] as number];
  const share = high > low ? Math.min(1, Math.max(0, (height - low) / (high - low))) : 0;
  const [one, other] = [radii[before] as Float64Array, radii[next] as Float64Array];
  return one.map((radius, k) => (1 - share) * radius + share * (other[k] as number));
}

/** The rings of a round pot with the waves of the scan at their heights; those that are lower than `least` are left out. */
export function withWaves(shape: Rings, levels: Levels, least: number): Rings {
  const rings = shape.rings.map((ring): Hoop => {
    const section = sectionAt(levels, ring.z.mean);
    const radius = middle(section);
    const waves = wavesOf(section).filter(({ cos = 0, sin = 0 }) => Math.hypot(cos, sin) > least);
    const mean = section.reduce((sum, each) => sum + each, 0) / DIRECTIONS;
    const more = short(mean - radius, least);
    const r = { ...ring.r, mean: short(ring.r.mean + more, least) };
    return { ...ring, r: waves.length > 0 ? { ...r, waves: waves.map((wave) => rounded(wave, least)) } : r };
  });
  return { ...shape, rings };
}

function wavesOf(section: Float64Array): readonly Wave[] {
  return Array.from({ length: FINEST }, (_, i): Wave => {
    const n = i + 1;
    let [cos, sin] = [0, 0];
    for (let k = 0; k < DIRECTIONS; k += 1) {
      const angle = (2 * Math.PI * n * k) / DIRECTIONS;
      cos += (2 * (section[k] as number) * Math.cos(angle)) / DIRECTIONS;
      sin += (2 * (section[k] as number) * Math.sin(angle)) / DIRECTIONS;
    }
    return { n, cos, sin };
  });
}

/** To what is seen of it: a tenth of what is left out. */
function short(value: number, least: number): number {
  const unit = 10 ** Math.floor(Math.log10(least / 10));
  return Number((Math.round(value / unit) * unit).toPrecision(12));
}

function rounded({ n, cos = 0, sin = 0 }: Wave, least: number): Wave {
  const [c, s] = [short(cos, least), short(sin, least)];
  return { n, ...(c !== 0 && { cos: c }), ...(s !== 0 && { sin: s }) };
}
