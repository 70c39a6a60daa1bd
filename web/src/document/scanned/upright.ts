/** Which way is up in a scan: no file says so. */

import type { Levels } from "../types";

/** The axis of a file that points upwards; with a minus, the one that points down. */
export const UPS = ["z", "y", "x", "-z", "-y", "-x"] as const;
export type Up = (typeof UPS)[number];

interface Turn {
  /** Which of the numbers of a point become its x, y and z. */
  readonly from: readonly [number, number, number];
  readonly sign: readonly [number, number, number];
}

/** All of them are turns: nothing is seen in the mirror. */
const TURNS: Readonly<Record<Up, Turn>> = {
  z: { from: [0, 1, 2], sign: [1, 1, 1] },
  y: { from: [0, 2, 1], sign: [1, -1, 1] },
  x: { from: [2, 1, 0], sign: [-1, 1, 1] },
  "-z": { from: [0, 1, 2], sign: [1, -1, -1] },
  "-y": { from: [0, 2, 1], sign: [1, 1, -1] },
  "-x": { from: [2, 1, 0], sign: [1, 1, -1] },
};

/** Triangles of which that is up, turned so that z is. */
export function upright(triangles: Float32Array, up: Up): Float32Array {
  if (up === "z") return triangles;
  const { from, sign } = TURNS[up];
  return triangles.map((_, i) => {
    const axis = i % 3;
    return (sign[axis] ?? 1) * (triangles[i - axis + (from[axis] ?? axis)] ?? 0);
  });
}

/** How far sections are from circles about the axis, as a part of their radius (RMS); more where less of the height is closed all round. */
export function unroundness({ heights, height, radii }: Levels): number {
  const spread = (section: Float64Array) => {
    const mean = section.reduce((sum, radius) => sum + radius, 0) / section.length;
    return section.reduce((sum, radius) => sum + (radius / mean - 1) ** 2, 0) / section.length;
  };
  const sum = radii.reduce((total, section) => total + spread(section), 0);
  const closed = ((heights.at(-1) ?? 0) - (heights[0] ?? 0)) / height;
  return Math.sqrt(sum / radii.length) / closed;
}
