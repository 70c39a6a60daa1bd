/** A section of a scan: how far its outside is from the axis, direction by direction. */

/** Directions that a section is looked at in. */
export const DIRECTIONS = 180;

/** Half of what is around is further out than this. */
export function middle(section: Float64Array): number {
  const sorted = Float64Array.from(section).sort();
  const half = DIRECTIONS >> 1;
  return ((sorted[half - 1] as number) + (sorted[half] as number)) / 2;
}
