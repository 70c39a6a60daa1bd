/** By how much a design has to grow for its finished pot to have a size: at once where all of it grows, by trial where its wall stays as thick as it is. */

import { scaled, type Walls } from "../document/scaled";
import type { Design, Measures } from "../document/types";

export type Sized = "height" | "width" | "capacity";

/** A size this near to the one that was asked for, as a share of it, is that size. */
const NEAR = 1e-9;

/** The size of a pot changes evenly with that of its surface: so many trials are more than it takes. */
const TRIALS = 12;

/** The size in model units, capacity in their cube; null where the pot holds nothing. */
export function sizeOf({ height, width, capacity }: Measures, sized: Sized): number | null {
  switch (sized) {
    case "height":
      return height.value;
    case "width":
      return width.greatest.value;
    case "capacity":
      return capacity?.brim.value ?? null;
  }
}

/**
 * The factor; null where no trial comes near enough, because a pot with this wall cannot be that small. `measures` are those of the design, `measure` takes those of another
 * or says null where that is no pot.
 */
export async function factorFor(
  design: Design,
  measures: Measures,
  goal: { readonly sized: Sized; readonly size: number; readonly walls: Walls },
  measure: (design: Design) => Promise<Measures | null>,
): Promise<number | null> {
  const { sized, size, walls } = goal;
  const power = sized === "capacity" ? 3 : 1;
  const now = sizeOf(measures, sized);
  if (now === null || !(now > 0) || !(size > 0) || !Number.isFinite(size)) return null;
  const even = (size / now) ** (1 / power);
  if (walls === "scale" || !design.parts.some(({ wall }) => wall)) return even;
  // The secant of how far off the logarithm of the size is, over the logarithm of the factor.
  let [x0, y0] = [0, Math.log(now / size)];
  let x1 = Math.log(even);
  for (let trial = 0; trial < TRIALS; trial += 1) {
    const made = await measure(scaled(design, Math.exp(x1), walls));
    const found = made && sizeOf(made, sized);
    // Too small for its wall: half way back.
    if (found === null || !(found > 0)) {
      x1 = (x0 + x1) / 2;
      if (Math.abs(x1 - x0) < NEAR) return null;
      continue;
    }
    const y1 = Math.log(found / size);
    if (Math.abs(y1) <= NEAR) return Math.exp(x1);
    const slope = (y1 - y0) / (x1 - x0);
    const next = x1 - y1 / (slope > 0 && Number.isFinite(slope) ? slope : power);
    [x0, y0, x1] = [x1, y1, next];
  }
  return Math.abs(y0) <= 1e-6 ? Math.exp(x0) : null;
}
