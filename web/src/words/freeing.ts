/** Why something cannot be made of rings, as sentences. */

import type { Refusal, Unit } from "../document/types";
import { boundWords } from "./bound";
import { freeing } from "./english/freeing";
import { textOf, whyWords } from "./refusals";

export function cannotWords(refusal: Refusal, unit: Unit): string {
  const why = textOf(refusal, "what") ?? "";
  if (refusal.code === "unsupported-shape" && why in freeing.cannot)
    return freeing.cannot[why as keyof typeof freeing.cannot];
  const reached = refusal.code === "tolerance-too-fine" ? refusal.args?.reached : null;
  return typeof reached === "number" ? freeing.tooFine(boundWords(reached, unit)) : whyWords(refusal, unit);
}
