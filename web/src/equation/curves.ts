/** Where numbers of a shape are on its surface: the curves on which they are given. */

import { AXES } from "../document/boundary-value";
import type { Shape } from "../document/types";
import type { Amount } from "./amount";
import { problemOf } from "./posed";
import { type Component, frequency, type Harmonic, type Problem } from "./problem";

/** Points of a curve. */
const STEPS = 192;

/** For each curve that one of these numbers is about, its points one after the other, three numbers each, before placement. */
export function curvesOf(shape: Shape, places: readonly string[]): Float32Array[] {
  if (places.length === 0 || shape.kind === "vertex-frame" || shape.kind === "blend" || shape.kind === "octant")
    return [];
  const problem = problemOf(shape);
  const wanted = new Set(places);
  const about = (amount: Amount | undefined) => amount?.at.some((place) => wanted.has(place)) ?? false;
  const all = Object.values(problem.components).flatMap(({ harmonics }) => harmonics);
  const curves: Float32Array[] = [];
  if (all.some(({ start, start_u }) => about(start) || about(start_u)))
    curves.push(curve(problem, ({ start }) => start));
  problem.rings.forEach(({ u }, index) => {
    if (about(u) || all.some(({ rings }) => about(rings[index])))
      curves.push(curve(problem, ({ rings }) => rings[index]));
  });
  if (all.some(({ end, end_u }) => about(end) || about(end_u))) curves.push(curve(problem, ({ end }) => end));
  return curves;
}

function curve({ components, span }: Problem, of: (harmonic: Harmonic) => Amount | undefined): Float32Array {
  const length = span === "turn" ? 2 * Math.PI : span === "one" ? 1 : span;
  const points = new Float32Array(3 * (STEPS + 1));
  AXES.forEach((axis, place) => {
    for (const harmonic of (components[axis] satisfies Component).harmonics) {
      const value = of(harmonic)?.value ?? 0;
      if (value === 0) continue;
      const k = frequency(harmonic, span);
      const wave = harmonic.wave === "cos" ? Math.cos : Math.sin;
      for (let step = 0; step <= STEPS; step += 1) {
        const at = 3 * step + place;
        points[at] = (points[at] ?? 0) + value * wave((k * length * step) / STEPS);
      }
    }
  });
  return points;
}
