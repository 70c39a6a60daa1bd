/** Whether a pot can be made, in sentences: what the checks found, where the wall is thin, what needs support, how it stands. */

import type { Finding, Measures, PartMeasures, Report } from "./making";
import { type Outline, placeOf } from "./places";
import { degreesWords, lengthWords, MILLIMETRES } from "./quantities";
import type { Triple, Unit } from "./types";

export type Severity = "error" | "warning" | "note" | "good";

export interface Sentence {
  readonly severity: Severity;
  readonly text: string;
}

/** Steeper than this, printed layers hang in the air. */
const SUPPORT_DEGREES = 45;

/** Two lines of the usual nozzle of 0.4 mm. */
const LEAST_PRINTED_MM = 0.8;

/** A pot that tips sooner than this is knocked over by a cat. */
const STEADY_DEGREES = 10;

/** A wall thinner by less than this share was not thinned; it was rounded. */
const THINNED = 0.001;

const ORDER: readonly Severity[] = ["error", "warning", "note", "good"];

/** The worst comes first. */
export function verdict(
  measures: Measures | null,
  report: Report | null,
  outline: Outline,
  unit: Unit,
): readonly Sentence[] {
  const sentences = [
    ...(report ? checked(report, outline) : []),
    ...(measures ? measured(measures, outline, unit) : []),
  ];
  return sentences.toSorted((a, b) => ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity));
}

/** What the checks say of the very triangles that a file holds. */
export function checked({ findings, ok }: Report, outline: Outline): readonly Sentence[] {
  const sentences = findings.map((finding) => ({ severity: finding.severity, text: findingWords(finding, outline) }));
  const closed: Sentence = {
    severity: "good",
    text: "The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  };
  return ok ? [...sentences, closed] : sentences;
}

/** A finding with the name of its place, which the message leaves out. */
export function findingWords({ message, at }: Finding, outline: Outline): string {
  if (!at || outline.length < 2) return message;
  const place = placeOf(at, outline);
  return message.includes(place) ? message : `${message.replace(/\.$/, "")}, at the ${place}.`;
}

function measured(measures: Measures, outline: Outline, unit: Unit): readonly Sentence[] {
  const several = measures.parts.length > 1;
  return [...measures.parts.flatMap((part) => ofPart(part, outline, unit, several)), ...stands(measures)];
}

function ofPart(part: PartMeasures, outline: Outline, unit: Unit, several: boolean): readonly Sentence[] {
  const sentences: Sentence[] = [];
  const name = several ? `${part.name ?? `Part ${part.part + 1}`}: ` : "";
  const say = (severity: Severity, text: string) => sentences.push({ severity, text: `${name}${text}` });
  const where = (at: Triple) => `at the ${placeOf(at, outline)}`;
  if (!part.isPot && part.reason) say("error", part.reason);
  const { thickness, overhang } = part;
  if (thickness) {
    const { least, asked } = thickness;
    const thin = lengthWords(least.value, unit, 3);
    if (least.value < asked * (1 - THINNED)) {
      say(
        "warning",
        `The wall is thinned to ${thin} ${where(least.at)}, where the pot bends too tightly for ${lengthWords(asked, unit, 3)}.`,
      );
    }
    if (least.value * MILLIMETRES[unit] < LEAST_PRINTED_MM) {
      say(
        "warning",
        `The wall is only ${lengthWords(least.value * MILLIMETRES[unit], "mm", 2)} thick ${where(least.at)}: too thin for most clay and most printers at this size.`,
      );
    }
  }
  if (overhang) {
    const { degrees, at } = overhang;
    if (degrees > SUPPORT_DEGREES) {
      say("warning", `Overhang of ${degreesWords(degrees)} ${where(at)}: a printer needs support there.`);
    } else if (degrees > 1) {
      say("good", `The steepest overhang is ${degreesWords(degrees)}, ${where(at)}: it prints without support.`);
    } else say("good", "Nothing hangs over: it prints without support.");
  }
  return sentences;
}

function stands({ tipping: { empty, full } }: Measures): readonly Sentence[] {
  if (!empty) return [];
  const filled = full ? `, and when full by ${degreesWords(full.degrees)}` : "";
  if (empty.degrees === 0) {
    return [{ severity: "error", text: "It falls over: its weight is not above its foot." }];
  }
  if (full && full.degrees === 0) {
    return [{ severity: "error", text: `It stands empty, but falls over when it is full.` }];
  }
  const steady = Math.min(empty.degrees, full?.degrees ?? empty.degrees) >= STEADY_DEGREES;
  return [
    steady
      ? { severity: "good", text: `It stands: empty it tips when tilted by ${degreesWords(empty.degrees)}${filled}.` }
      : { severity: "warning", text: `It tips easily: empty when tilted by ${degreesWords(empty.degrees)}${filled}.` },
  ];
}
