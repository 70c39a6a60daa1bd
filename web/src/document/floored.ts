/** A pot as it is drawn where nobody makes its wall: with a floor, so that nothing is seen through its foot. */

import type { Design, Hoop, Part, Rings } from "./types";

/** A point in the middle would be a pole, for which the surface has no normal of its own. */
const NARROW = 0.02;

export function floored(design: Design): Design {
  const floors = design.parts.flatMap((part) => (part.shape.kind === "rings" ? floorOf(part, part.shape) : []));
  return floors.length === 0 ? design : { ...design, parts: [...design.parts, ...floors] };
}

/** Level with the foot and as wide; none for what is open below. */
function floorOf({ wall, place, look }: Part, { rings, a }: Rings): readonly Part[] {
  const [foot] = rings;
  if (!foot || !wall?.base) return [];
  const middle: Hoop = { u: 0, r: { mean: NARROW * foot.r.mean }, z: { mean: foot.z.mean } };
  const edge: Hoop = { u: 1, r: foot.r, z: foot.z };
  const shape: Rings = { kind: "rings", ...(a !== undefined && { a }), rings: [middle, edge] };
  return [{ shape, ...(place && { place }), ...(look && { look }) }];
}
