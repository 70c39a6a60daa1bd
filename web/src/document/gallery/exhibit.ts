/** A finished design to start from. */

import type { Design, Look, Part, Placement, Shape, Wall } from "../types";

export interface Exhibit<Id extends string = string> {
  /** Stable and unique: what tests, thumbnails and the words of its title and note call it. */
  readonly id: Id;
  readonly shape: Shape;
  readonly place?: Placement;
  readonly wall?: Wall;
  readonly look?: Look;
  /** Where it takes several, all of them; the shape is that of the first. */
  readonly parts?: readonly Part[];
}

/** A list of them that says whose words there have to be. */
export function exhibits<const Id extends string>(all: readonly Exhibit<Id>[]): readonly Exhibit<Id>[] {
  return all;
}

/** The exhibit as a document of its own, under a title; its parts have names where it takes several. */
export function designOf(
  { shape, place, wall, look, parts }: Exhibit,
  title?: string,
  names: readonly string[] = [],
): Design {
  return {
    pasu: 1,
    ...(title !== undefined && { title }),
    parts: parts?.map((part, at) => (names[at] === undefined ? part : { name: names[at], ...part })) ?? [
      { shape, ...(place && { place }), ...(wall && { wall }), ...(look && { look }) },
    ],
  };
}
