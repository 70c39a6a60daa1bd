/** Whether a pot can be made, in sentences: what the checks found, where the wall is thin, what needs support, how it stands. */

import { formatNumber } from "../number";
import { hangingInsideWords, type Outline, placeWords } from "./places";
import { degreesWords, lengthWords } from "./quantities";
import { fittedWords } from "./remedy-words";
import { UNITS as MILLIMETRES } from "./tables.gen";
import type { Finding, Measures, PartMeasures, Report, Triple, Unit } from "./types";

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

/** The code of a finding of the checks. */
const THINNED = "thinned";

/** Codes of findings that the page says by itself, from the measures and in the unit of the design. */
const MEASURED: readonly string[] = ["too-thin", "overhang"];

const ORDER: readonly Severity[] = ["error", "warning", "note", "good"];

/** The worst comes first. */
export function verdict(
  measures: Measures | null,
  report: Report | null,
  outline: Outline,
  unit: Unit,
): readonly Sentence[] {
  const thinned = (report?.findings ?? []).filter(({ code }) => code === THINNED).map(({ part }) => part);
  return [
    ...(report ? checked(report, outline, unit) : []),
    ...(measures ? measured(measures, outline, unit, thinned) : []),
  ].sort(worstFirst);
}

/** What stands in the way of making a file of this size: what the checks say of it, and where its wall is thin; `millimetres` is how many a model unit has in it. */
export function madeOf(
  report: Report,
  measures: Measures,
  outline: Outline,
  unit: Unit,
  millimetres: number,
): readonly Sentence[] {
  return [
    ...checked(report, outline, unit),
    ...inParts(measures, (part) => thinWords(part, outline, millimetres)),
  ].sort(worstFirst);
}

function worstFirst(a: Sentence, b: Sentence): number {
  return ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity);
}

/** What the checks say of the very triangles that a file holds. */
export function checked(report: Report, outline: Outline, unit: Unit): readonly Sentence[] {
  const sentences = report.findings
    .filter(({ code }) => !MEASURED.includes(code))
    .map((finding) => ({
      severity: finding.severity,
      text:
        finding.code === THINNED
          ? thinnedWords(finding, report, outline, unit)
          : (fittedWords(finding, unit) ?? findingWords(finding, outline)),
    }));
  const closed: Sentence = {
    severity: "good",
    text: "The mesh is closed, every edge is shared by two triangles, and it does not cross itself.",
  };
  return report.ok ? [...sentences, closed] : sentences;
}

/** A finding as a sentence, with the name of its place. */
export function findingWords({ message, at }: Finding, outline: Outline): string {
  const sentence = asSentence(message);
  if (!at || outline.length < 2) return sentence;
  const place = placeWords(at, outline);
  return sentence.includes(place) ? sentence : `${sentence.slice(0, -1)} (${place}).`;
}

/** A message of the library as a sentence of its own. */
export function asSentence(message: string): string {
  const ended = /[.!?]$/.test(message) ? message : `${message}.`;
  return ended.charAt(0).toUpperCase() + ended.slice(1);
}

/** "The wall is thinned to 0.12 cm at the shoulder, where it bends too tightly: 3 % of it is thinner than asked for." */
function thinnedWords(finding: Finding, { meshes }: Report, outline: Outline, unit: Unit): string {
  const { part, at } = finding;
  const mesh = meshes.find((each) => each.part === part);
  if (!mesh?.thinnest || !at) return findingWords({ ...finding, at: null }, outline);
  const share = formatNumber(Math.max(0.1, 100 * mesh.thinned), 2);
  return `The wall is thinned to ${lengthWords(mesh.thinnest, unit, 3)} ${placeWords(at, outline)}, where the pot bends more tightly or comes closer to itself than the wall is thick: ${share}\u00a0% of it is thinner than asked for.`;
}

function measured(measures: Measures, outline: Outline, unit: Unit, thinned: readonly number[]): readonly Sentence[] {
  return [
    ...inParts(measures, (part) => ofPart(part, outline, unit, thinned.includes(part.part))),
    ...stands(measures),
  ];
}

/** What is said of each part, with its name where there are several. */
function inParts(measures: Measures, words: (part: PartMeasures) => readonly Sentence[]): readonly Sentence[] {
  const several = measures.parts.length > 1;
  return measures.parts.flatMap((part) => {
    const name = several ? `${part.name ?? `Part ${part.part + 1}`}: ` : "";
    return words(part).map(({ severity, text }) => ({ severity, text: `${name}${text}` }));
  });
}

function whereWords(at: Triple | null, outline: Outline): string {
  return at ? placeWords(at, outline) : "in places";
}

/** A wall that is too thin to be made where a model unit is so many millimetres. */
function thinWords({ thickness }: PartMeasures, outline: Outline, millimetres: number): readonly Sentence[] {
  if (!thickness || thickness.least.value * millimetres >= LEAST_PRINTED_MM) return [];
  const { value, at } = thickness.least;
  const thin = lengthWords(value * millimetres, "mm", 2);
  return [
    {
      severity: "warning",
      text: `The wall is only ${thin} thick ${whereWords(at, outline)}: too thin for most clay and most printers at this size.`,
    },
  ];
}

function ofPart(part: PartMeasures, outline: Outline, unit: Unit, told: boolean): readonly Sentence[] {
  const sentences: Sentence[] = [];
  const say = (severity: Severity, text: string) => sentences.push({ severity, text });
  const where = (at: Triple | null) => whereWords(at, outline);
  if (!part.isPot && part.reason) say("error", asSentence(part.reason));
  const { thickness } = part;
  if (thickness) {
    const { least, asked } = thickness;
    const thin = lengthWords(least.value, unit, 3);
    if (part.thickness?.thinned.value && !told) {
      say(
        "warning",
        `The wall is thinned to ${thin} ${where(least.at)}, where the pot bends too tightly for ${lengthWords(asked, unit, 3)}.`,
      );
    }
  }
  sentences.push(...thinWords(part, outline, MILLIMETRES[unit]));
  sentences.push(...overhangs(part, outline));
  return sentences;
}

/** A printer builds both sides of the wall: the pot prints without support where neither hangs over too far. */
function overhangs({ overhang, overhangInside }: PartMeasures, outline: Outline): readonly Sentence[] {
  const sides = [
    ...(overhang ? [{ degrees: overhang.degrees, place: placeWords(overhang.at, outline) }] : []),
    ...(overhangInside
      ? [{ degrees: overhangInside.degrees, place: hangingInsideWords(overhangInside.at, outline) }]
      : []),
  ].sort((a, b) => b.degrees - a.degrees);
  const [steepest] = sides;
  if (!steepest) return [];
  const hanging = sides.filter(({ degrees }) => degrees > SUPPORT_DEGREES);
  if (hanging.length > 0) {
    return hanging.map(({ degrees, place }) => ({
      severity: "warning",
      text: `Overhang of ${degreesWords(degrees)} ${place}: a printer needs support there.`,
    }));
  }
  const text =
    steepest.degrees > 1
      ? `The steepest overhang is ${degreesWords(steepest.degrees)}, ${steepest.place}: it prints without support.`
      : "Nothing hangs over: it prints without support.";
  return [{ severity: "good", text }];
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
