/** The few points of a part by which one knows how far it reaches, wherever it is moved to. */

import { IDENTITY, type Matrix } from "../document/placement";

/** Horizontal directions, as many as extents are sought in: their farthest points are exact while the part is only moved. */
const ROUND = 128;
/** Directions of all kinds, by which one knows well enough how far a part reaches that is being turned. */
const AROUND = 96;
/** These are sought among so many points. */
const FEW = 4000;
const GOLDEN = Math.PI * (3 - Math.sqrt(5));

/** The points (xyz, before placement) that are farthest in some direction: in horizontal ones exactly, as the part is scaled and turned. */
export function reachOf(positions: Float32Array, turn: Matrix | null): Float32Array {
  if (positions.length < 3) return new Float32Array();
  const found: number[] = [];
  const m = (i: number) => (turn ?? IDENTITY)[i] as number;
  const add = (x: number, y: number, z: number, stride = 1) => {
    const at = farthest(positions, x, y, z, stride);
    found.push(positions[at] as number, positions[at + 1] as number, positions[at + 2] as number);
  };
  /** A direction of the model, as the part has it. */
  const ofModel = (x: number, y: number, z: number) =>
    add(m(0) * x + m(1) * y + m(2) * z, m(4) * x + m(5) * y + m(6) * z, m(8) * x + m(9) * y + m(10) * z);
  for (let k = 0; k < ROUND; k += 1) {
    const angle = (2 * Math.PI * k) / ROUND;
    ofModel(Math.cos(angle), Math.sin(angle), 0);
  }
  ofModel(0, 0, 1);
  ofModel(0, 0, -1);
  // An odd stride wanders over the columns of a grid instead of following some of them.
  const stride = 2 * Math.floor(positions.length / 3 / FEW / 2) + 1;
  for (let k = 0; k < AROUND; k += 1) {
    const z = 1 - (2 * k + 1) / AROUND;
    const r = Math.sqrt(1 - z * z);
    add(r * Math.cos(GOLDEN * k), r * Math.sin(GOLDEN * k), z, stride);
  }
  return new Float32Array(found);
}

function farthest(points: Float32Array, x: number, y: number, z: number, stride: number): number {
  let [best, at] = [Number.NEGATIVE_INFINITY, 0];
  for (let i = 0; i < points.length; i += 3 * stride) {
    const along = x * (points[i] as number) + y * (points[i + 1] as number) + z * (points[i + 2] as number);
    if (along > best) [best, at] = [along, i];
  }
  return at;
}
