/** Where a part stands: scaled, then turned, then moved, as `Placement::matrix` of the crate does it. For the screen: what is exact is the solver's. */

import type { Placement } from "./types";

/** Sixteen numbers, column by column: a point of the shape goes to where it stands. */
export type Matrix = readonly number[];

export const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** All of a placement, defaults among them. */
export type WholePlacement = Required<Placement>;

/** Where the shape's own equations put it. */
export const UNMOVED: WholePlacement = { scale: [1, 1, 1], axis: [0, 0, 1], angle: 0, shift: [0, 0, 0] };

/** The matrix of a placement; null where it has none that can be undone, which the solver refuses in words. */
export function matrixOf(place: Placement | undefined): Matrix | null {
  if (!place) return IDENTITY;
  const { scale, axis, angle, shift } = { ...UNMOVED, ...place };
  const length = Math.hypot(...axis);
  const [h, k, l] = [axis[0] / length, axis[1] / length, axis[2] / length];
  // Half a turn is exact.
  const [sin, cos] = angle === -Math.PI ? [0, -1] : [Math.sin(angle), Math.cos(angle)];
  const rest = 1 - cos;
  const [x, y, z] = scale;
  const matrix = [
    x * (cos + h * h * rest),
    x * (h * k * rest + l * sin),
    x * (h * l * rest - k * sin),
    0,
    y * (h * k * rest - l * sin),
    y * (cos + k * k * rest),
    y * (k * l * rest + h * sin),
    0,
    z * (h * l * rest + k * sin),
    z * (k * l * rest - h * sin),
    z * (cos + l * l * rest),
    0,
    ...shift,
    1,
  ];
  return matrix.every(Number.isFinite) && x !== 0 && y !== 0 && z !== 0 ? matrix : null;
}

/** The placement without its movement: how large a part is and which way it looks. Undefined where both are as its own equations have it. */
export function turnOf(place: Placement | undefined): Placement | undefined {
  if (!place) return undefined;
  const { shift: _, ...turn } = place;
  return Object.keys(turn).length === 0 ? undefined : turn;
}

/** Whether two placements scale and turn alike. */
export function turnsAlike(a: Placement | undefined, b: Placement | undefined): boolean {
  if (a === b) return true;
  const [one, other] = [matrixOf(a), matrixOf(b)];
  return one !== null && other !== null && [0, 1, 2, 4, 5, 6, 8, 9, 10].every((i) => one[i] === other[i]);
}

/** Where points (xyz) stand; directions and not points with `far` 0. */
export function placedAll(matrix: Matrix, points: ArrayLike<number>, far: 0 | 1 = 1): Float64Array {
  const out = new Float64Array(points.length);
  const m = (i: number) => matrix[i] as number;
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i] as number, points[i + 1] as number, points[i + 2] as number];
    out[i] = m(0) * x + m(4) * y + m(8) * z + far * m(12);
    out[i + 1] = m(1) * x + m(5) * y + m(9) * z + far * m(13);
    out[i + 2] = m(2) * x + m(6) * y + m(10) * z + far * m(14);
  }
  return out;
}
