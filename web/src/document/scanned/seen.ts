/** A scan as it is seen from the side. */

import type { Levels } from "../types";

/** In how many directions each level was looked at. */
export function directionsOf({ radii }: Levels): number {
  return radii[0]?.length ?? 1;
}

/** How far out it reaches anywhere. */
export function widestOf({ radii }: Levels): number {
  return radii.reduce((most, section) => section.reduce((a, b) => Math.max(a, b), most), 0);
}

/** The direction of its outermost point, by its number. */
export function frontOf(levels: Levels): number {
  const widest = widestOf(levels);
  return Math.max(0, ...levels.radii.map((section) => section.indexOf(widest)));
}

/** How far out a section is seen to reach that way. */
export function seenAt(section: Float64Array, direction: number): number {
  const turned = (k: number) => Math.cos((2 * Math.PI * (k - direction)) / section.length);
  return section.reduce((most, radius, k) => Math.max(most, radius * turned(k)), 0);
}

/** A piece of the outside between two levels and two directions, as it is seen: across and up, four times, and how far off it is. */
export interface Piece {
  readonly corners: readonly (readonly [across: number, up: number])[];
  readonly away: number;
}

/** What of the outside is turned to whoever sees `right` at the right, from the back to the front. `away` is level by level in directions of equal angles. */
export function piecesSeen(levels: Levels, away: Float32Array, right: number): readonly Piece[] {
  const { heights, radii } = levels;
  const directions = directionsOf(levels);
  const columns = away.length / heights.length;
  const step = directions / columns;
  const pieces: (Piece & { readonly near: number })[] = [];
  const angle = (k: number) => (2 * Math.PI * (k * step - right)) / directions;
  for (let level = 0; level + 1 < heights.length; level += 1) {
    for (let k = 0; k < columns; k += 1) {
      const corner = (above: 0 | 1, on: 0 | 1) => {
        const radius = radii[level + above]?.[((k + on) % columns) * step] ?? 0;
        const height = heights[level + above] ?? 0;
        return [radius * Math.cos(angle(k + on)), height, -radius * Math.sin(angle(k + on))] as const;
      };
      const [a, b, c, d] = [corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)];
      // Seen from outside it goes round to the right, below and then above.
      const area = (c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]);
      if (area <= 0) continue;
      const corners = [a, b, c, d].map(([across, up]) => [across, up] as const);
      const off = (above: 0 | 1, on: 0 | 1) => away[(level + above) * columns + ((k + on) % columns)] ?? 0;
      const mean = (off(0, 0) + off(0, 1) + off(1, 0) + off(1, 1)) / 4;
      pieces.push({ corners, away: mean, near: a[2] + b[2] + c[2] + d[2] });
    }
  }
  return pieces.sort((one, other) => one.near - other.near);
}
