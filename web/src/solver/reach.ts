/** The few points of a part by which one knows how far it reaches, wherever it is moved to. */

import { IDENTITY, type Matrix } from "../document/placement";

/** Horizontal directions, as many as extents are sought in: their farthest points are exact while the part is only moved. */
const ROUND = 128;
/** Directions of all kinds, by which one knows well enough how far a part reaches that is being turned. */
const AROUND = 96;
const GOLDEN = Math.PI * (3 - Math.sqrt(5));

/** So many points that follow each other on the grid are looked at together: most of them are far from being the farthest. */
const RUN = 16;

/** The points (xyz, before placement) that are farthest in some direction, each once: in horizontal ones as the part is scaled and turned. */
export function reachOf(positions: Float32Array, turn: Matrix | null, boxes = boxesOf(positions)): Float32Array {
  if (positions.length < 3) return new Float32Array();
  const found = new Set<number>();
  const m = (i: number) => (turn ?? IDENTITY)[i] as number;
  const add = (x: number, y: number, z: number) => found.add(farthest(positions, boxes, x, y, z));
  /** A direction of the model, as the part has it. */
  const ofModel = (x: number, y: number, z: number) =>
    add(m(0) * x + m(1) * y + m(2) * z, m(4) * x + m(5) * y + m(6) * z, m(8) * x + m(9) * y + m(10) * z);
  for (let k = 0; k < ROUND; k += 1) {
    const angle = (2 * Math.PI * k) / ROUND;
    ofModel(Math.cos(angle), Math.sin(angle), 0);
  }
  ofModel(0, 0, 1);
  ofModel(0, 0, -1);
  for (let k = 0; k < AROUND; k += 1) {
    const z = 1 - (2 * k + 1) / AROUND;
    const r = Math.sqrt(1 - z * z);
    add(r * Math.cos(GOLDEN * k), r * Math.sin(GOLDEN * k), z);
  }
  const reach = new Float32Array(3 * found.size);
  let next = 0;
  for (const at of found) {
    reach.set(positions.subarray(at, at + 3), next);
    next += 3;
  }
  return reach;
}

/** The least and the greatest coordinates of each run of points: six numbers for each. */
export function boxesOf(positions: Float32Array): Float32Array {
  const boxes = new Float32Array(6 * Math.ceil(positions.length / (3 * RUN)));
  rebox(positions, boxes, 0, positions.length / 3);
  return boxes;
}

/** Brings up to date where points are elsewhere: so many from one on. */
export function rebox(positions: Float32Array, boxes: Float32Array, first: number, count: number): void {
  const begin = Math.floor(first / RUN);
  const last = 6 * Math.ceil((first + count) / RUN);
  for (let box = 6 * begin, from = 3 * RUN * begin; box < last; box += 6, from += 3 * RUN) {
    const end = Math.min(from + 3 * RUN, positions.length);
    for (let axis = 0; axis < 3; axis += 1) {
      let low = Number.POSITIVE_INFINITY;
      let high = Number.NEGATIVE_INFINITY;
      for (let i = from + axis; i < end; i += 3) {
        const x = positions[i] as number;
        if (x < low) low = x;
        if (x > high) high = x;
      }
      boxes[box + axis] = low;
      boxes[box + 3 + axis] = high;
    }
  }
}

/** Where the first of the points is that are farthest in a direction. */
function farthest(points: Float32Array, boxes: Float32Array, x: number, y: number, z: number): number {
  // The corner of a box that is farthest in this direction.
  const [ox, oy, oz] = [x > 0 ? 3 : 0, y > 0 ? 4 : 1, z > 0 ? 5 : 2];
  let best = Number.NEGATIVE_INFINITY;
  let at = 0;
  for (let box = 0, from = 0; box < boxes.length; box += 6, from += 3 * RUN) {
    const corner = x * (boxes[box + ox] as number) + y * (boxes[box + oy] as number) + z * (boxes[box + oz] as number);
    if (corner <= best) continue;
    const end = Math.min(from + 3 * RUN, points.length);
    for (let i = from; i < end; i += 3) {
      const along = x * (points[i] as number) + y * (points[i + 1] as number) + z * (points[i + 2] as number);
      if (along > best) {
        best = along;
        at = i;
      }
    }
  }
  return at;
}
