/** What the solver made of a design, as the stage takes it. */

import { lookOf } from "../document/look";
import type { Design, Triple } from "../document/types";
import type { StageModel } from "../render/mesh";
import type { SolvedParts } from "../solver/solved";
import type { PartId } from "../state/part-ids";

/** `within` is the part in whose place its inside is shown. */
export function stageModel(
  design: Design,
  { parts, bounds }: SolvedParts,
  hidden: readonly PartId[] = [],
  within: PartId | null = null,
): StageModel {
  const objectAt = (place: number) => design.parts[place]?.object ?? 0;
  const middles = middlesOf(parts, objectAt);
  return {
    parts: parts.map((part, place) => ({
      ...part,
      look: lookOf(design.parts[place]),
      middle: middles?.get(objectAt(place)),
      hidden: hidden.includes(part.id) || part.id === within,
      inside: part.id === within && !hidden.includes(part.id),
    })),
    bounds,
  };
}

/** The middle of what the parts of each object fill; null where all are one object, whose middle is that of all. */
function middlesOf(
  parts: SolvedParts["parts"],
  objectAt: (place: number) => number,
): ReadonlyMap<number, Triple> | null {
  const filled = new Map<number, { readonly min: Triple; readonly max: Triple }>();
  for (const [place, { box }] of parts.entries()) {
    const [object, before] = [objectAt(place), filled.get(objectAt(place))];
    if (!box) continue;
    const least = (a: Triple, b: Triple): Triple => [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.min(a[2], b[2])];
    const most = (a: Triple, b: Triple): Triple => [Math.max(a[0], b[0]), Math.max(a[1], b[1]), Math.max(a[2], b[2])];
    filled.set(object, before ? { min: least(before.min, box.min), max: most(before.max, box.max) } : box);
  }
  if (filled.size < 2) return null;
  const between = (a: Triple, b: Triple): Triple => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
  return new Map([...filled].map(([object, { min, max }]) => [object, between(min, max)]));
}
