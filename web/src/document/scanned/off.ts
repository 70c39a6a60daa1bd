/** How far a scan is from a pot of rings: of points of the scan's outside, the way along the radius or the height, whichever is shorter. */

import type { Levels } from "./levels";
import { DIRECTIONS } from "./section";

export interface Off {
  /** The root of the mean of the squares. */
  readonly rms: number;
  readonly most: number;
  /** Level by level in {@link COLUMNS} directions: above 0 where the scan is outside of the pot. */
  readonly away: Float32Array;
}

/** Rows and columns at which the pot has to be read: pairs of u and v. */
export const ROWS = 240;
export const COLUMNS = 60;

export function placesRead(): Float64Array {
  const at = new Float64Array(2 * (ROWS + 1) * COLUMNS);
  for (let row = 0; row <= ROWS; row += 1)
    for (let k = 0; k < COLUMNS; k += 1) at.set([row / ROWS, (2 * Math.PI * k) / COLUMNS], 2 * (row * COLUMNS + k));
  return at;
}

/** `points` are those of the pot at {@link placesRead}. */
export function offBy({ heights, radii }: Levels, points: Float64Array): Off {
  let [squares, most] = [0, 0];
  const away = new Float32Array(heights.length * COLUMNS);
  for (let k = 0; k < COLUMNS; k += 1) {
    const line = Array.from({ length: ROWS + 1 }, (_, row): readonly [number, number] => {
      const i = 3 * (row * COLUMNS + k);
      return [Math.hypot(points[i] as number, points[i + 1] as number), points[i + 2] as number];
    });
    const direction = (k * DIRECTIONS) / COLUMNS;
    heights.forEach((height, level) => {
      const off = nearest(line, radii[level]?.[direction] ?? 0, height);
      squares += off * off;
      most = Math.max(most, Math.abs(off));
      away[level * COLUMNS + k] = off;
    });
  }
  return { rms: Math.sqrt(squares / Math.max(1, away.length)), most, away };
}

/** The way from a line that goes up to a point, below 0 where that is on the side of the axis. */
function nearest(line: readonly (readonly [number, number])[], r: number, z: number): number {
  let [least, inwards] = [Number.POSITIVE_INFINITY, 0];
  for (let i = 1; i < line.length; i += 1) {
    const [[a, b], [c, d]] = [line[i - 1] as readonly [number, number], line[i] as readonly [number, number]];
    const [x, y] = [c - a, d - b];
    const whole = x * x + y * y;
    const share = whole > 0 ? Math.min(1, Math.max(0, ((r - a) * x + (z - b) * y) / whole)) : 0;
    const [out, up] = [r - a - share * x, z - b - share * y];
    const squared = out * out + up * up;
    if (squared < least) [least, inwards] = [squared, x * up - y * out];
  }
  return inwards > 0 ? -Math.sqrt(least) : Math.sqrt(least);
}
