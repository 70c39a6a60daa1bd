/** The parts that a ray goes through, in the order in which it comes to them. */

import type { Hit } from "./types";

export interface Pierced {
  readonly part: number;
  /** How far behind the first of them the ray comes to it. */
  readonly behind: number;
}

/** Each part once, where the ray comes to it first; of places that do not count nothing is said. */
export function piercedBy(hits: readonly Hit[], counts: (hit: Hit) => boolean): readonly Pierced[] {
  const seen = hits.filter(counts).toSorted((a, b) => a.distance - b.distance);
  const first = seen.filter(({ part }, at) => seen.findIndex((each) => each.part === part) === at);
  const nearest = first[0]?.distance ?? 0;
  return first.map(({ part, distance }) => ({ part, behind: distance - nearest }));
}
