/** What a blend may begin and end as: sections chosen by their pictures, and the pot between any two of them, in centimetres, with its wall. */

import { between, LITHE, type Plan, sectionOf } from "../blend/between";
import type { Section } from "../types";
import type { Exhibit } from "./exhibit";

const PLANS = {
  round: { radius: 1 },
  oval: { radius: [1.2, 0.8] },
  square: { radius: 1, count: 4, corners: 0.6, at: 45 },
  triangle: { radius: 1, count: 3, corners: 0.5 },
  hexagon: { radius: 1, count: 6, corners: 0.6, at: 30 },
  star: { radius: 1, count: 5, petals: 0.2, corners: 0.3 },
  flower: { radius: 1, count: 7, petals: 0.14 },
} as const satisfies Readonly<Record<string, Plan>>;

export type PlanName = keyof typeof PLANS;
export const PLAN_NAMES = Object.keys(PLANS) as readonly PlanName[];

/** As large as a vase is. */
const FOOT = 5;
const RIM = 6.5;
const HEIGHT = 17;

/** A vase from one section to another. */
export function vaseBetween(foot: PlanName, rim: PlanName): Exhibit {
  return {
    id: `blend-${foot}-${rim}`,
    shape: between(sized(PLANS[foot], FOOT), sized(PLANS[rim], RIM), {
      z: [0, HEIGHT],
      taper: [0.9, 0.5],
      dz: [HEIGHT, HEIGHT],
      weights: LITHE,
    }),
    wall: { thickness: 0.45, base: 0.6, rim: "rounded" },
    look: { glaze: "celadon", clay: "stoneware" },
  };
}

/** A section of the list, of radius 1, to be looked at. */
export function sampleOf(name: PlanName): Section {
  return sectionOf(PLANS[name], { z: 0, taper: 0, dz: 0 });
}

function sized(plan: Plan, factor: number): Plan {
  const { radius } = plan;
  return {
    ...plan,
    radius: typeof radius === "number" ? factor * radius : [factor * radius[0], factor * radius[1]],
  };
}
