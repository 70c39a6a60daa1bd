/**
 * A scan of a pot that stands upright, level by level: how far its outside is from the axis in every direction. Inside and floor are not looked at, and what stands out like a handle is taken for the
 * outermost there is.
 */

import { withoutHandle } from "./handle";
import { DIRECTIONS } from "./section";

export interface Levels {
  /** Where the axis is, in the scan. */
  readonly axis: readonly [x: number, y: number];
  /** The lowest point of the scan, and how high it is. */
  readonly bottom: number;
  readonly height: number;
  /** From the foot to the rim, above the bottom. */
  readonly heights: readonly number[];
  /** For each of them, the distance from the axis in {@link DIRECTIONS} directions. */
  readonly radii: readonly Float64Array[];
}

const LEVELS = 160;

/** Levels keep off the very foot and the very rim by this part of a gap, where a scan is level and has no section. */
const INSET = 0.25;

/** So many levels at least go all round. */
const FEWEST = 24;

/** The axis is where sections have their middle; a few rounds find it. */
const ROUNDS = 3;

/** `positions` are triangles, nine numbers each. Null where there is no pot: too few levels are closed round an axis. */
export function levelsOf(positions: Float32Array): Levels | null {
  const box = boxOf(positions);
  if (!box) return null;
  const { bottom, height } = box;
  const all = Array.from({ length: LEVELS }, (_, i) => (height * (i + INSET)) / (LEVELS - 1 + 2 * INSET));
  let axis = box.middle;
  let radii = sections(positions, axis, bottom, all);
  for (let round = 0; round < ROUNDS; round += 1) {
    const shift = middleOf(withoutHandle(radii.filter(isWhole)));
    if (!shift) return null;
    axis = [axis[0] + shift[0], axis[1] + shift[1]];
    radii = sections(positions, axis, bottom, all);
  }
  // What is not closed all round, at a broken or slanting rim, is left out; from there on the pot ends.
  const first = radii.findIndex(isWhole);
  let last = first;
  while (last + 1 < radii.length && isWhole(radii[last + 1] as Float64Array)) last += 1;
  if (first < 0 || last - first < FEWEST) return null;
  return { axis, bottom, height, heights: all.slice(first, last + 1), radii: radii.slice(first, last + 1) };
}

function boxOf(
  positions: Float32Array,
): { readonly bottom: number; readonly height: number; readonly middle: readonly [number, number] } | null {
  const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const most = least.map((each) => -each);
  for (let i = 0; i < positions.length; i += 1) {
    const value = positions[i] ?? 0;
    if (!Number.isFinite(value)) return null;
    least[i % 3] = Math.min(least[i % 3] as number, value);
    most[i % 3] = Math.max(most[i % 3] as number, value);
  }
  const [x0 = 0, y0 = 0, z0 = 0] = least;
  const [x1 = 0, y1 = 0, z1 = 0] = most;
  return z1 > z0 ? { bottom: z0, height: z1 - z0, middle: [(x0 + x1) / 2, (y0 + y1) / 2] } : null;
}

function isWhole(section: Float64Array): boolean {
  return section.every((radius) => radius > 0);
}

/** How far sections' middles are from where the axis was taken to be. */
function middleOf(whole: readonly Float64Array[]): readonly [number, number] | null {
  if (whole.length === 0) return null;
  let [x, y] = [0, 0];
  for (const section of whole) {
    // The wave that goes round once: a circle beside the axis has it, and little else has.
    for (let k = 0; k < DIRECTIONS; k += 1) {
      const angle = (2 * Math.PI * k) / DIRECTIONS;
      x += (2 * (section[k] as number) * Math.cos(angle)) / DIRECTIONS;
      y += (2 * (section[k] as number) * Math.sin(angle)) / DIRECTIONS;
    }
  }
  return [x / whole.length, y / whole.length];
}

/** The outermost crossing of every triangle with each level and direction; 0 where there is none. */
function sections(
  positions: Float32Array,
  [cx, cy]: readonly [number, number],
  bottom: number,
  levels: readonly number[],
): Float64Array[] {
  const radii = levels.map(() => new Float64Array(DIRECTIONS));
  const [low = 0, gap = 1] = [levels[0], (levels[1] ?? 1) - (levels[0] ?? 0)];
  for (let t = 0; t + 8 < positions.length; t += 9) {
    const z = (k: number) => (positions[t + 3 * k + 2] as number) - bottom;
    const [za, zb, zc] = [z(0), z(1), z(2)];
    const from = Math.max(0, Math.ceil((Math.min(za, zb, zc) - low) / gap));
    const to = Math.min(levels.length - 1, Math.floor((Math.max(za, zb, zc) - low) / gap));
    for (let level = from; level <= to; level += 1) {
      const at = levels[level] as number;
      const ends: number[] = [];
      for (const [k, l] of EDGES) {
        const [zk, zl] = [z(k), z(l)];
        if (zk < at === zl < at) continue;
        const share = (at - zk) / (zl - zk);
        const along = (axis: 0 | 1) =>
          (positions[t + 3 * k + axis] as number) * (1 - share) + (positions[t + 3 * l + axis] as number) * share;
        ends.push(along(0) - cx, along(1) - cy);
      }
      if (ends.length === 4) mark(radii[level] as Float64Array, ends as [number, number, number, number]);
    }
  }
  return radii;
}

const EDGES = [
  [0, 1],
  [1, 2],
  [2, 0],
] as const;

/** A piece is seen beside its ends too, over this part of the gap to the next direction: two that meet in a direction would both be beside it by rounding. */
const BESIDE = 0.01;

/** Marks the directions that a straight piece is seen in. */
function mark(section: Float64Array, [x0, y0, x1, y1]: readonly [number, number, number, number]): void {
  const step = (2 * Math.PI) / DIRECTIONS;
  const begin = Math.atan2(y0, x0);
  // The short way round.
  const turn = Math.atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
  const [low, high] = turn < 0 ? [begin + turn, begin] : [begin, begin + turn];
  for (let k = Math.ceil(low / step - BESIDE); k <= high / step + BESIDE; k += 1) {
    const [dx, dy] = [Math.cos(k * step), Math.sin(k * step)];
    const cross = dx * (y1 - y0) - dy * (x1 - x0);
    if (cross === 0) continue;
    const radius = (x0 * (y1 - y0) - y0 * (x1 - x0)) / cross;
    const place = ((k % DIRECTIONS) + DIRECTIONS) % DIRECTIONS;
    if (radius > (section[place] as number)) section[place] = radius;
  }
}
