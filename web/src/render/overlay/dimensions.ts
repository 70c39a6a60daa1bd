import type { Bounds } from "../mesh";
import type { Triple } from "../triple";

/** A dimension line with its ticks, in model units, and where its label is. */
export interface Dimension {
  segments: number[];
  label: Triple;
  length: number;
}

/** How far the lines stand off the pot, and half the length of a tick, as shares of its radius. */
const STAND_OFF = 0.16;
const TICK = 0.035;

/**
 * Height, width (x) and depth (y) of what the bounds enclose, as dimension lines: the height beside the pot, at the edge of the box that is at the
 * left of the picture, width and depth on the table on the sides that face the camera.
 *
 * @param towards the horizontal direction from the pot to the eye
 */
export function dimensionsOf(bounds: Bounds, towards: readonly [number, number]): Dimension[] {
  const { min, max, radius } = bounds;
  const off = STAND_OFF * radius;
  const tick = TICK * radius;
  // The sides of the box that face the eye.
  const x = towards[0] >= 0 ? max[0] + off : min[0] - off;
  const y = towards[1] >= 0 ? max[1] + off : min[1] - off;
  // The corner at the left of the picture; left is (towards[1], -towards[0]) turned to the eye's side.
  const left = [towards[1], -towards[0]] as const;
  const hx = left[0] >= 0 ? max[0] + off : min[0] - off;
  const hy = left[1] >= 0 ? max[1] + off : min[1] - off;
  const z = min[2];
  const out: Dimension[] = [];
  const add = (from: Triple, to: Triple, across: Triple) => {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    if (!(length > 0)) return;
    const segments = [...from, ...to];
    for (const end of [from, to]) {
      for (const sign of [-1, 1])
        for (let k = 0; k < 3; k++) segments.push((end[k] as number) + sign * (across[k] as number));
    }
    const label: Triple = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
    out.push({ segments, label, length });
  };
  add([hx, hy, min[2]], [hx, hy, max[2]], [left[0] * tick, left[1] * tick, 0]);
  add([min[0], y, z], [max[0], y, z], [0, tick, 0]);
  add([x, min[1], z], [x, max[1], z], [tick, 0, 0]);
  return out;
}
