/** Blends in short: two closed sections, the lower one first, and how the solid leaves them. */

import type { Blend, Pair, Section, Triple } from "../types";
import { type Figure, outlineOf, PLAIN } from "./figure";

/** A section from above: a circle where nothing else is said. */
export interface Plan {
  readonly radius: number | Pair;
  /** Anticlockwise, in degrees. */
  readonly turn?: number;
  readonly count?: number;
  readonly petals?: number;
  readonly corners?: number;
  /** Where the first corner or petal is, in degrees from the axis of `y`. */
  readonly at?: number;
}

interface Way {
  /** Heights of the two. */
  readonly z: Pair;
  readonly taper: Pair;
  readonly dz: Pair;
  readonly weights?: Triple;
}

/** How much the direction round a section resists bending: with so little, corners and petals reach far, and what is round does not neck in. */
export const LITHE: Triple = [1, 0.004, 1];

export function between(foot: Plan, rim: Plan, { z, taper, dz, weights = LITHE }: Way): Blend {
  return {
    kind: "blend",
    start: sectionOf(foot, { z: z[0], taper: taper[0], dz: dz[0] }),
    end: sectionOf(rim, { z: z[1], taper: taper[1], dz: dz[1] }),
    weights,
  };
}

/** A section that is no more than a circle or an oval is a disc. */
export function sectionOf(plan: Plan, level: Pick<Section, "z" | "taper" | "dz">): Section {
  const { radius, turn = 0, count = PLAIN.count, petals = 0, corners = 0, at = 0 } = plan;
  const both: Pair = typeof radius === "number" ? [radius, radius] : radius;
  if (turn === 0 && petals === 0 && corners === 0) return { form: "disc", radius: both, ...level };
  const figure: Figure = { radius: both, turn, middle: [0, 0], ornament: { count, petals, corners, turn: at } };
  return { form: "outline", ...outlineOf(figure), ...level };
}
