/** What became of the parts of one scene in another, part by part. */

import type { Difference } from "./types";

/** The most telling first: a part that was changed may be elsewhere too. */
export const FATES = ["changed", "moved", "reglued", "added", "gone", "kept"] as const;
export type Fate = (typeof FATES)[number];

/** Parts of one fate: their places in the other scene and in this. */
export interface Group {
  readonly which: Fate;
  readonly parts: readonly { readonly before?: number; readonly after?: number }[];
}

/** What a person looks for first comes first. */
export function groupsOf({ kept, moved, changed, gone, added, reglued }: Difference): readonly Group[] {
  return [
    { which: "changed", parts: changed },
    { which: "moved", parts: moved },
    { which: "reglued", parts: reglued },
    { which: "added", parts: added.map((after) => ({ after })) },
    { which: "gone", parts: gone.map((before) => ({ before })) },
    { which: "kept", parts: kept },
  ];
}

/** By the places of a scene, the most telling fate of each part; of this scene, or of the other. */
export function fatesOf(difference: Difference, of: "before" | "after"): ReadonlyMap<number, Fate> {
  const found = new Map<number, Fate>();
  for (const { which, parts } of groupsOf(difference)) {
    for (const part of parts) {
      const place = part[of];
      if (place !== undefined && !found.has(place)) found.set(place, which);
    }
  }
  return found;
}
