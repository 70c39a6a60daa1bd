/**
 * The outline of a pot on a photograph: what differs from the background, which is seen at the left and the right edge of every row. A plain wall behind the pot is enough, also one that grows darker
 * to a side or downwards; how much has to differ is where the differences fall into two kinds (Otsu 1979).
 */

import type { Spot } from "./knot";

/** Pixels of red, green, blue and opacity, row by row. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

/** Both sides from the foot to the rim, in pixels. */
export interface Silhouette {
  readonly left: readonly Spot[];
  readonly right: readonly Spot[];
  readonly axis: number;
}

/** The strip at an edge that is background, as a part of the width. */
const EDGE = 0.03;
/** Rows of background above and below that count as well. */
const AROUND = 4;
/** What the eye tells apart best counts most. */
const WEIGHTS = [2, 4, 3] as const;
/** Differences are at most so large. */
const LEVELS = 256;
/** The side of a pot that lies in the shade differs less than the rest: what it takes to differ is less than where both kinds part. */
const SHADED = 0.6;
/** Where nothing differs by more there is no pot to be seen. */
const FAINT = 14;
/** A pot takes at least this part of the picture, and its narrowest end this part of its width. */
const LEAST_AREA = 0.005;
const THIN = 0.04;
const LEAST_ROWS = 12;

/** `sensitivity` 0 is what was found to be best; above, more belongs to the pot, below, less: each step halves or doubles what has to differ. Null where no pot can be told from what is behind it. */
export function silhouetteOf(picture: Picture, sensitivity = 0): Silhouette | null {
  const { width, height } = picture;
  if (width < LEAST_ROWS || height < LEAST_ROWS) return null;
  const differences = differencesOf(picture);
  let most = 0;
  for (const difference of differences) most = Math.max(most, difference);
  if (most < FAINT) return null;
  const threshold = thresholdOf(differences) / 2 ** sensitivity;
  const mask = largest(
    calmed(
      differences.map((difference) => (difference > threshold ? 1 : 0)),
      width,
    ),
    width,
  );
  return mask && sidesIn(mask, differences, threshold, width, height);
}

/** How much every pixel differs from what is behind the pot. */
function differencesOf({ width, height, data }: Picture): Float32Array {
  const strip = Math.max(2, Math.round(EDGE * width));
  const backs = [edgeOf(data, width, height, 0, strip), edgeOf(data, width, height, width - strip, strip)] as const;
  const all = new Float32Array(width * height);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const share = x / (width - 1);
      let sum = 0;
      for (let c = 0; c < 3; c += 1) {
        const back = (1 - share) * (backs[0][3 * y + c] ?? 0) + share * (backs[1][3 * y + c] ?? 0);
        sum += (WEIGHTS[c] ?? 0) * ((data[4 * (y * width + x) + c] ?? 0) - back) ** 2;
      }
      all[y * width + x] = Math.sqrt(sum / 9);
    }
  }
  return all;
}

/** The colour of a strip, row by row: the middle one of what is there, so that dust does not count. */
function edgeOf(data: Uint8ClampedArray, width: number, height: number, from: number, strip: number): Float32Array {
  const edge = new Float32Array(3 * height);
  for (let y = 0; y < height; y += 1) {
    for (let c = 0; c < 3; c += 1) {
      const seen: number[] = [];
      for (let row = Math.max(0, y - AROUND); row <= Math.min(height - 1, y + AROUND); row += 1)
        for (let x = from; x < from + strip; x += 1) seen.push(data[4 * (row * width + x) + c] ?? 0);
      seen.sort((a, b) => a - b);
      edge[3 * y + c] = seen[seen.length >> 1] ?? 0;
    }
  }
  return edge;
}

/** Where two kinds of differences are furthest apart. */
function thresholdOf(differences: Float32Array): number {
  const histogram = new Float64Array(LEVELS);
  for (const difference of differences) {
    const level = Math.min(LEVELS - 1, Math.floor(difference));
    histogram[level] = (histogram[level] ?? 0) + 1;
  }
  const total = differences.length;
  const sum = histogram.reduce((all, count, level) => all + level * count, 0);
  let [below, belowSum, best, threshold] = [0, 0, -1, 1];
  for (let level = 0; level < LEVELS - 1; level += 1) {
    below += histogram[level] ?? 0;
    belowSum += level * (histogram[level] ?? 0);
    if (below === 0 || below === total) continue;
    const apart = belowSum / below - (sum - belowSum) / (total - below);
    const variance = below * (total - below) * apart * apart;
    if (variance > best) [best, threshold] = [variance, level + 1];
  }
  // Two kinds of background are no pot: what is nearer to it than this is background.
  return Math.max(FAINT / 2, SHADED * threshold);
}

/** Without single pixels that differ from those around them. */
function calmed(mask: Float32Array, width: number): Uint8Array {
  const height = mask.length / width;
  const calm = new Uint8Array(mask.length);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      let [on, all] = [0, 0];
      for (let row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row += 1) {
        for (let column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column += 1) {
          on += mask[row * width + column] ?? 0;
          all += 1;
        }
      }
      calm[y * width + x] = 2 * on > all ? 1 : 0;
    }
  }
  return calm;
}

/** The largest piece that hangs together; null where it is none to speak of. */
function largest(mask: Uint8Array, width: number): Uint8Array | null {
  const piece = new Int32Array(mask.length);
  const sizes = [0];
  const stack: number[] = [];
  for (let start = 0; start < mask.length; start += 1) {
    if (!mask[start] || piece[start]) continue;
    const name = sizes.length;
    let size = 0;
    piece[start] = name;
    stack.push(start);
    for (let at = stack.pop(); at !== undefined; at = stack.pop()) {
      size += 1;
      const column = at % width;
      for (const next of [at - width, at + width, column > 0 ? at - 1 : -1, column < width - 1 ? at + 1 : -1]) {
        if (next < 0 || next >= mask.length || !mask[next] || piece[next]) continue;
        piece[next] = name;
        stack.push(next);
      }
    }
    sizes.push(size);
  }
  const most = Math.max(...sizes);
  if (most < LEAST_AREA * mask.length) return null;
  const name = sizes.indexOf(most);
  return Uint8Array.from(piece, (each) => (each === name ? 1 : 0));
}

/** The outermost places of the piece in every row, where the difference passes the threshold between two pixels. */
function sidesIn(
  mask: Uint8Array,
  differences: Float32Array,
  threshold: number,
  width: number,
  height: number,
): Silhouette | null {
  const rows: { readonly y: number; readonly left: number; readonly right: number }[] = [];
  for (let y = 0; y < height; y += 1) {
    const row = mask.subarray(y * width, (y + 1) * width);
    const [first, last] = [row.indexOf(1), row.lastIndexOf(1)];
    if (first < 0) continue;
    const passes = (inner: number, outer: number) => {
      // At the edge of the picture it ends.
      if (outer < 0 || outer >= width) return outer < 0 ? 0 : width;
      const [inside, outside] = [differences[y * width + inner] ?? 0, differences[y * width + outer] ?? 0];
      const share = outside < threshold && inside > threshold ? (inside - threshold) / (inside - outside) : 0.5;
      return inner + share * (outer - inner) + 0.5;
    };
    rows.push({ y: y + 0.5, left: passes(first, first - 1), right: passes(last, last + 1) });
  }
  const widest = rows.reduce((most, { left, right }) => Math.max(most, right - left), 0);
  const thin = ({ left, right }: { readonly left: number; readonly right: number }) => right - left < THIN * widest;
  while (rows[0] && thin(rows[0])) rows.shift();
  for (let last = rows.at(-1); last && thin(last); last = rows.at(-1)) rows.pop();
  if (rows.length < LEAST_ROWS) return null;
  const middles = rows.map(({ left, right }) => 0.5 * (left + right)).sort((a, b) => a - b);
  const up = rows.reverse();
  return {
    left: up.map(({ left, y }) => ({ x: left, y })),
    right: up.map(({ right, y }) => ({ x: right, y })),
    axis: middles[middles.length >> 1] ?? 0,
  };
}

/** Both sides as one, if they are alike as far as the eye can see: the mean of both, on the right; null where they are not. */
export function alike({ left, right, axis }: Silhouette): readonly Spot[] | null {
  const height = (right[0]?.y ?? 0) - (right.at(-1)?.y ?? 0);
  const both = right.map(({ x, y }, i) => ({ one: x - axis, other: axis - (left[i]?.x ?? axis), y }));
  const off = both.map(({ one, other }) => Math.abs(one - other)).sort((a, b) => a - b);
  // A spout or a handle is not: a few rows of dust are.
  if ((off[Math.floor(0.9 * off.length)] ?? 0) > UNLIKE * height) return null;
  return both.map(({ one, other, y }) => ({ x: axis + 0.5 * (one + other), y }));
}

/** Sides are unlike where they differ by more than this part of the height. */
const UNLIKE = 0.03;
