/** What a pot holds is what it was before a hand changed it, by measuring: once the hand has let go, because that takes longer than a frame. */

import { measure } from "pasu";
import type { Design, Sent } from "../document/types";
import { factorFor, madeUp } from "./making-up";
import type { HeldShape, HoldAsk } from "./messages";

/** How far the capacity may be from what it was, as a part of it. */
export const HELD = 1e-6;

/** Null where nothing was held before, or no ring that is free makes up for it. */
export function holding({ before, after, along, rings }: HoldAsk): HeldShape | null {
  const goal = brim(before);
  const shape = after.parts[0]?.shape;
  if (goal === null || shape?.kind !== "rings" || rings.length === 0) return null;
  const at = (factor: number) => madeUp(shape, { along, rings }, factor);
  const factor = factorFor(along, HELD, (factor) => {
    const held = brim({ ...after, parts: after.parts.map((part) => ({ ...part, shape: at(factor) })) });
    return held === null ? null : held / goal - 1;
  });
  return factor === null ? null : { shape: at(factor) };
}

function brim(design: Design): number | null {
  return measure(design as Sent, { product: "pot" }).capacity?.brim.value ?? null;
}
