/** A plain loft: the cubic from one section to the other by their positions and tangents, which leaves the equation to itself. */

/** How much of a position is left of the section at the beginning and of that at the end, where tangents are `taper` times the position. */
export function loftShares(w: number, tapers: readonly [start: number, end: number]): readonly [number, number] {
  const rise = w * w * (3 - 2 * w);
  return [1 - rise + tapers[0] * w * (1 - w) ** 2, rise + tapers[1] * w * w * (w - 1)];
}
