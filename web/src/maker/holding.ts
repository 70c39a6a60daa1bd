/** What a pot holds is kept while a hand changes it: its rings come nearer to the foot or further from it, or others become wider or narrower, all by one factor, until the measured capacity is what it was. */

import { measure } from "pasu";
import type { Design, Rings, Sent, Series } from "../document/types";
import type { HeldShape, HoldAsk } from "./messages";

/** How far the capacity may be from what it was, as a part of it. */
export const HELD = 1e-6;

/** Steps of the secant method at most: four or five suffice. */
const MOST_STEPS = 16;

/** Nothing becomes more than so many times as high or wide, or as low or narrow. */
const MOST = 3;

/** Far below what {@link HELD} asks for. */
const DIGITS = 10;

/** Null where nothing was held before, or no ring that is free makes up for it. */
export function holding({ before, after, along, rings }: HoldAsk): HeldShape | null {
  const goal = brim(before);
  const shape = after.parts[0]?.shape;
  if (goal === null || shape?.kind !== "rings" || rings.length === 0) return null;
  const at = (factor: number) => {
    const made = scaled(shape, along, rings, factor);
    const held = brim({ ...after, parts: after.parts.map((part) => ({ ...part, shape: made })) });
    return held === null ? null : { factor, made, off: held / goal - 1 };
  };
  let last = at(1);
  if (!last || Math.abs(last.off) <= HELD) return last && { shape: last.made };
  // What a pot holds goes as its height and as the square of its width: that is near enough to begin with.
  let next = at(within((1 + last.off) ** (along === "z" ? -1 : -0.5)));
  for (let step = 0; next && step < MOST_STEPS; step += 1) {
    if (Math.abs(next.off) <= HELD) return { shape: next.made };
    if (next.off === last.off) return null;
    const factor = within(next.factor - (next.off * (next.factor - last.factor)) / (next.off - last.off));
    [last, next] = [next, at(factor)];
  }
  return null;
}

function within(factor: number): number {
  return Math.min(MOST, Math.max(1 / MOST, factor));
}

function brim(design: Design): number | null {
  return measure(design as Sent, { product: "pot" }).capacity?.brim.value ?? null;
}

function scaled(shape: Rings, along: HoldAsk["along"], rings: readonly number[], factor: number): Rings {
  const from = along === "z" ? (shape.rings[0]?.z.mean ?? 0) : 0;
  return {
    ...shape,
    rings: shape.rings.map((ring, index) =>
      rings.includes(index) ? { ...ring, [along]: times(ring[along], factor, from) } : ring,
    ),
  };
}

/** A series as far again from `from`, by a factor. */
function times({ mean, waves }: Series, factor: number, from: number): Series {
  const short = (value: number) => Number(value.toPrecision(DIGITS));
  return {
    mean: short(from + factor * (mean - from)),
    ...(waves && {
      waves: waves.map(({ n, cos, sin }) => ({
        n,
        ...(cos !== undefined && { cos: short(factor * cos) }),
        ...(sin !== undefined && { sin: short(factor * sin) }),
      })),
    }),
  };
}
