/** Why something cannot be made of rings, as sentences. */

import type { Refusal, Unit } from "../document/types";
import { freeing } from "./english/freeing";
import { lengthOf } from "./making";
import { textOf, whyWords } from "./refusals";

export function cannotWords(refusal: Refusal, unit: Unit): string {
  const why = textOf(refusal, "what") ?? "";
  if (refusal.code === "unsupported-shape" && why in freeing.cannot)
    return freeing.cannot[why as keyof typeof freeing.cannot];
  const reached = refusal.code === "tolerance-too-fine" ? lengthOf(refusal, "reached", unit) : null;
  return reached === null ? whyWords(refusal, unit) : freeing.tooFine(reached);
}
