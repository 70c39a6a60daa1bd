/** Whether both sections of a blend are run through alike: otherwise the solid between them folds through itself, whatever its numbers are. */

import type { Blend, Section } from "../types";
import { ENDS, type End, isClosed, reformed } from "./section";
import { settled } from "./solving";

/** One section goes round a middle and the other from side to side; or both from side to side, and opposite ways. */
export type Clash = "kinds" | "ways";

export function clashOf({ start, end }: Blend): Clash | null {
  if (isClosed(start.form) !== isClosed(end.form)) return "kinds";
  return isClosed(start.form) || isReversed(start) === isReversed(end) ? null : "ways";
}

/** Every form from side to side but the plain rectangle goes the way of the axes. */
function isReversed({ form }: Section): boolean {
  return form !== "rectangle";
}

/** What makes them agree: a disc goes from side to side over a square, or what has corners goes round as an outline. */
export const REMEDIES = ["disc-in-square", "outline"] as const;
export type Remedy = (typeof REMEDIES)[number];

/** Those that serve: only a disc can be laid over a square without another border, and only sections of two kinds need an outline. */
export function remediesOf(blend: Blend): readonly Remedy[] {
  const clash = clashOf(blend);
  if (clash === null) return [];
  const isPlain = ENDS.every((end) => blend[end].form !== "outline");
  return REMEDIES.filter((remedy) => (remedy === "outline" ? clash === "kinds" : isPlain));
}

/** The blend whose sections agree. */
export function agreed(blend: Blend, remedy: Remedy): Blend {
  const made = (end: End): Section => {
    const section = blend[end];
    if (remedy === "outline") return isClosed(section.form) ? section : reformed(section, roundOf(section));
    if (section.form === "disc") return reformed(section, "disc-in-square");
    return section.form === "rectangle" ? reformed(section, "rectangle-reversed") : section;
  };
  return settled({ ...blend, start: made("start"), end: made("end") });
}

/** The closed form with the same border. */
function roundOf({ form }: Section): "disc" | "outline" {
  return form === "disc-in-square" ? "disc" : "outline";
}
