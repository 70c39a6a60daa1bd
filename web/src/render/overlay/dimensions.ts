import type { Bounds } from "../mesh";
import type { Triple } from "../triple";

/** A dimension line with its ticks, in model units, and where its label is. */
export interface Dimension {
  segments: number[];
  label: Triple;
  length: number;
}

/** The pot between two upright planes square to a horizontal direction, in degrees from the x axis; `low` is where the first is along it. */
export interface Breadth {
  readonly direction: number;
  readonly low: number;
  readonly width: number;
}

/** How high the pot is, and how wide at most and at least. */
export interface Size {
  readonly bottom: number;
  readonly height: number;
  readonly greatest: Breadth;
  readonly least: Breadth;
}

/** A length that is but rounding, as a share of the radius of the pot. */
const NOTHING = 1e-9;

/** Widths that differ by less are the same all round: one line shows them. */
const ROUND = 1e-3;

/** How far the lines stand off the pot, and half the length of a tick, as shares of its radius. */
const STAND_OFF = 0.16;
const TICK = 0.035;

/**
 * Height, greatest and least width of what the bounds enclose, as dimension lines: the height beside the pot, at the edge of the box that is at the
 * left of the picture, the widths on the table, each along its own direction, on the sides that face the camera.
 *
 * @param towards the horizontal direction from the pot to the eye
 */
export function dimensionsOf(bounds: Bounds, towards: readonly [number, number], size: Size): Dimension[] {
  const { min, max, radius, centre } = bounds;
  const off = STAND_OFF * radius;
  const tick = TICK * radius;
  // The corner at the left of the picture; left is (towards[1], -towards[0]) turned to the eye's side.
  const left = [towards[1], -towards[0]] as const;
  const hx = left[0] >= 0 ? max[0] + off : min[0] - off;
  const hy = left[1] >= 0 ? max[1] + off : min[1] - off;
  const z = size.bottom;
  const out: Dimension[] = [];
  const add = (length: number, from: Triple, to: Triple, across: Triple) => {
    if (!(length > NOTHING * radius)) return;
    const segments = [...from, ...to];
    for (const end of [from, to]) {
      for (const sign of [-1, 1])
        for (let k = 0; k < 3; k++) segments.push((end[k] as number) + sign * (across[k] as number));
    }
    const label: Triple = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
    out.push({ segments, label, length });
  };
  add(size.height, [hx, hy, z], [hx, hy, z + size.height], [left[0] * tick, left[1] * tick, 0]);
  const widths = size.greatest.width - size.least.width > ROUND * size.greatest.width;
  for (const { direction, low, width } of widths ? [size.greatest, size.least] : [size.greatest]) {
    const angle = (direction * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    // On the side that faces the eye, beyond the pot as it is that way.
    const side = -s * towards[0] + c * towards[1] >= 0 ? 1 : -1;
    const [nx, ny] = [-s * side, c * side];
    const beyond = Math.max(...[min[0], max[0]].flatMap((x) => [min[1], max[1]].map((y) => nx * x + ny * y)));
    const reach = Math.min(beyond, nx * centre[0] + ny * centre[1] + size.greatest.width / 2) + off;
    const at = (along: number): Triple => [c * along + nx * reach, s * along + ny * reach, z];
    add(width, at(low), at(low + width), [nx * tick, ny * tick, 0]);
  }
  return out;
}
