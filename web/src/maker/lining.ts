/** The colours of a map inside a pot: from what is known of the surface, at the place of the surface that each vertex of the lining lies behind. */

import type { MapName } from "../document/types";

/** The surface with what was computed at its vertices. */
export interface Mapped {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly mean: ArrayLike<number>;
  readonly gaussian: ArrayLike<number>;
  readonly thickness: ArrayLike<number>;
}

/** A vertex lies behind a place whose normal goes by it: so much of the way between them may go sideways, as a share of the thickness. */
const ASIDE = 0.6;
/** And its distance is what the wall is thick there, but for this share of it: the floor is none of the wall. */
const OFF = 0.4;

/**
 * The values of a map at vertices `points` of the lining, NaN where there is no wall before them and for points that are NaN. A wall of a thickness `d` is the surface moved along its normal: a curvature `k` of the surface is
 * `k / (1 - d k)` of the lining within it, so that with the mean `H` and Gaussian `K` it has `K' = K / D` and `H' = (H - d K) / D`, `D = 1 - 2 d H + d^2 K` (do Carmo 1976, section 3.5).
 */
export function liningValues(map: MapName, surface: Mapped, points: Float32Array): Float32Array {
  const near = nearest(surface.positions);
  const values = new Float32Array(points.length / 3).fill(Number.NaN);
  for (let i = 0; i < values.length; i += 1) {
    const [x, y, z] = [points[3 * i] as number, points[3 * i + 1] as number, points[3 * i + 2] as number];
    if (Number.isNaN(x)) continue;
    const k = near(x, y, z);
    if (k < 0) continue;
    const [nx, ny, nz] = [0, 1, 2].map((axis) => surface.normals[3 * k + axis] as number) as [number, number, number];
    const dx = x - (surface.positions[3 * k] as number);
    const dy = y - (surface.positions[3 * k + 1] as number);
    const dz = z - (surface.positions[3 * k + 2] as number);
    const thick = surface.thickness[k] as number;
    const along = -(dx * nx + dy * ny + dz * nz);
    const aside = Math.sqrt(Math.max(0, dx * dx + dy * dy + dz * dz - along * along));
    if (!(thick > 0) || Math.abs(along - thick) > OFF * thick || aside > ASIDE * thick + near.spacing) continue;
    const [h, g] = [surface.mean[k] as number, surface.gaussian[k] as number];
    const d = 1 - 2 * thick * h + thick * thick * g;
    if (map === "thickness") values[i] = thick;
    else if (map === "mean-curvature") values[i] = (h - thick * g) / d;
    else if (map === "gaussian-curvature") values[i] = g / d;
  }
  return values;
}

interface Nearest {
  (x: number, y: number, z: number): number;
  /** About how far vertices are from each other. */
  readonly spacing: number;
}

/** Finds the nearest of points by a grid of cells, about two points in each of those that have any; -1 where none is near. */
function nearest(points: Float32Array): Nearest {
  const count = points.length / 3;
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < points.length; i += 1) {
    low[i % 3] = Math.min(low[i % 3] as number, points[i] as number);
    high[i % 3] = Math.max(high[i % 3] as number, points[i] as number);
  }
  const size = Math.max(...low.map((from, axis) => (high[axis] as number) - from), 1e-30);
  // Points of a surface fill as many cells as its area has.
  const cell = size / Math.max(1, Math.sqrt(count / 4));
  const cells = new Map<number, number[]>();
  const side = Math.ceil(size / cell) + 5;
  const at = (value: number, axis: number) => Math.floor((value - (low[axis] as number)) / cell) + 2;
  const key = (i: number, j: number, k: number) => (i * side + j) * side + k;
  for (let i = 0; i < count; i += 1) {
    const where = key(
      at(points[3 * i] as number, 0),
      at(points[3 * i + 1] as number, 1),
      at(points[3 * i + 2] as number, 2),
    );
    const here = cells.get(where);
    if (here) here.push(i);
    else cells.set(where, [i]);
  }
  const find = (x: number, y: number, z: number): number => {
    const [a, b, c] = [at(x, 0), at(y, 1), at(z, 2)];
    let [best, distance] = [-1, Infinity];
    for (let ring = 0; ring < side; ring += 1) {
      if (distance <= ((ring - 1) * cell) ** 2) break;
      for (let i = a - ring; i <= a + ring; i += 1) {
        for (let j = b - ring; j <= b + ring; j += 1) {
          const shell = Math.abs(i - a) === ring || Math.abs(j - b) === ring;
          for (let k = c - ring; k <= c + ring; k += shell || ring === 0 ? 1 : 2 * ring) {
            for (const point of cells.get(key(i, j, k)) ?? []) {
              const dx = (points[3 * point] as number) - x;
              const dy = (points[3 * point + 1] as number) - y;
              const dz = (points[3 * point + 2] as number) - z;
              const off = dx * dx + dy * dy + dz * dz;
              if (off < distance) [best, distance] = [point, off];
            }
          }
        }
      }
    }
    return best;
  };
  return Object.assign(find, { spacing: cell });
}
