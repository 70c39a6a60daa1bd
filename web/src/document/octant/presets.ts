/** Octants that have a name: all three exponents alike. */

import type { Octant } from "../types";

export const PRESETS = [
  { id: "ball", exponent: 2 },
  { id: "box", exponent: 8 },
  { id: "facet", exponent: 1 },
  { id: "hollow", exponent: 0.6 },
] as const;

export type PresetId = (typeof PRESETS)[number]["id"];

/** Which of them an octant is; null for any other. */
export function presetOf({ exponents }: Octant): PresetId | null {
  const found = PRESETS.find(({ exponent }) => exponents.every((each) => each === exponent));
  return found?.id ?? null;
}

/** The octant whose three exponents are this one. */
export function alike(exponent: number): Octant {
  return { kind: "octant", exponents: [exponent, exponent, exponent] };
}
