/** Whether a pot can be made, in sentences: what the checks found, where the wall is thin, what needs support, how it stands. */

import { hangingInside, type Outline, placeOf } from "../document/places";
import { UNITS as MILLIMETRES } from "../document/tables.gen";
import type { Finding, Measures, PartMeasures, Report, Triple, Unit } from "../document/types";
import { isolated } from "../language";
import { formatNumber } from "../number";
import { making } from "./english/making";
import { quantities } from "./english/quantities";
import { report as said } from "./english/report";
import { lengthOf } from "./making";
import { partName } from "./parts";
import { degreesWords, lengthWords } from "./quantities";
import { whyWords } from "./refusals";
import { fittedWords } from "./remedies";

export type Severity = "error" | "warning" | "note" | "good";

export interface Sentence {
  readonly severity: Severity;
  readonly text: string;
  /** The same in a few words, where it has many. */
  readonly brief?: string;
  /** Whether it only says where a printer needs support: the pot can be made all the same. */
  readonly support?: true;
}

/** Steeper than this, printed layers hang in the air. */
const SUPPORT_DEGREES = 45;

/** Two lines of the usual nozzle of 0.4 mm. */
const LEAST_PRINTED_MM = 0.8;

/** A pot that tips sooner than this is knocked over by a cat. */
const STEADY_DEGREES = 10;

/** Codes of findings of the checks. */
const THINNED = "thinned";
const CEILING = "ceiling";
const LEFT_OUT = "no-wall";
const TOLERANCE = "tolerance-too-fine";

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
  const found = report?.findings ?? [];
  return [
    ...(report ? checked(report, measures, outline, unit) : []),
    ...(measures ? measured(measures, outline, unit, found) : []),
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
    ...checked(report, measures, outline, unit, millimetres),
    ...inParts(measures, (part) => thinWords(part, ofItsOwn(outline, part.part), millimetres)),
  ].sort(worstFirst);
}

/** The report in which a tolerance is told in the millimetres of the file, as the field has it; `millimetres` is how many a model unit has in it. */
export function inFile(report: Report, millimetres: number): Report {
  const findings = report.findings.map((finding) => {
    if (finding.code !== TOLERANCE) return finding;
    const lengths = Object.entries(finding.args).filter(([, value]) => typeof value === "number");
    const inMillimetres = lengths.map(([name, length]) => [`${name}Mm`, millimetres * Number(length)]);
    return { ...finding, args: { ...finding.args, ...Object.fromEntries(inMillimetres) } };
  });
  return { ...report, findings };
}

function worstFirst(a: Sentence, b: Sentence): number {
  return ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity);
}

/** What the checks say of the very triangles that a file holds, with the names of the parts that `measures` has, where there are several. How thin a wall is made is told in `unit`, or in the millimetres of the file where it is given how many a model unit has in it. */
export function checked(
  report: Report,
  measures: Measures | null,
  outline: Outline,
  unit: Unit,
  millimetres?: number,
): readonly Sentence[] {
  const length = (value: number) =>
    millimetres === undefined ? lengthWords(value, unit, 3) : lengthWords(millimetres * value, "mm", 2);
  const sentences = report.findings
    .filter(({ code }) => !MEASURED.includes(code))
    .map((finding) => {
      const { severity, part } = finding;
      // What is said of all parts of an object is not said of one.
      const isOfAll = finding.path === "union" && finding.args.other === undefined;
      const of = (text: string) => (isOfAll ? text : named(measures, part, text));
      const thinned = thinnedWords(finding, report, ofItsOwn(outline, part), length);
      if (thinned) return { severity, text: of(thinned.text), brief: of(thinned.brief) };
      return { severity, text: of(fittedWords(finding, unit) ?? findingWords(finding, outline, unit, measures)) };
    });
  const closed: Sentence = {
    severity: "good",
    text: said.closed,
  };
  return report.ok ? [...sentences, closed] : sentences;
}

/** A finding as a sentence, with the name of its place; `measures` have the names of parts. */
export function findingWords(finding: Finding, outline: Outline, unit: Unit, measures: Measures | null = null): string {
  const { code, message, args, at } = finding;
  const own = OWN[code]?.(finding, unit, measures) ?? null;
  const sentence = own ?? whyWords({ code, path: finding.path ?? "", message, args }, unit);
  if (!at || !namesPlaces(ofItsOwn(outline, finding.part)) || code === CEILING) return sentence;
  const place = whereWords(at, outline);
  return sentence.includes(place) ? sentence : said.placed(sentence.slice(0, -1), place);
}

/** What only checks say; null where what a finding names is not enough. */
const OWN: Readonly<Record<string, (finding: Finding, unit: Unit, measures: Measures | null) => string | null>> = {
  // A part without a wall is an error by itself, and beside pots left out.
  "no-wall": ({ severity }) => (severity === "warning" ? said.leftOut : null),
  "thin-base": (finding) => {
    const { what } = finding.args;
    const say: ((thickness: string, least: string) => string) | undefined =
      said.thinBase[what as keyof typeof said.thinBase];
    const [thickness, least, safe] = ["thicknessMm", "leastMm", "safeMm"].map((name) => lengthOf(finding, name, "mm"));
    const limit = what === "not-printed" || what === "no-clay" ? least : safe;
    return say !== undefined && thickness && limit ? say(thickness, limit) : null;
  },
  ceiling: (finding) => {
    const [width, height] = ["widthMm", "heightMm"].map((name) => lengthOf(finding, name, "mm"));
    if (!height) return null;
    return width ? said.ceiling(width, height) : said.underside(height);
  },
  "crosses-itself": together,
  overlap: together,
  "same-place": together,
  [TOLERANCE]: (finding, unit) => {
    const [bound, asked, found] = ["bound", "asked", "found"].map(
      (name) => lengthOf(finding, `${name}Mm`, "mm") ?? lengthOf(finding, name, unit),
    );
    if (found) return making.tooFine(found);
    const say = finding.args.what === "joined" ? said.joined : said.unkept;
    return bound && asked ? say(bound, asked) : null;
  },
};

function together({ args }: Finding, _unit: Unit, measures: Measures | null): string | null {
  const say: ((other: string) => string) | undefined = said.together[args.what as keyof typeof said.together];
  const { other } = args;
  if (say === undefined || typeof other !== "number") return null;
  const name = measures?.parts.find((part) => part.part === other)?.name ?? null;
  return say(isolated(partName(other, name)));
}

/** "The wall is thinned to 0.12 cm at the shoulder, where it bends too tightly: 3 % of it is thinner than asked for."; null for another finding, or where it is not known how thin. */
function thinnedWords(
  { code, part, at }: Finding,
  { meshes }: Report,
  outline: Outline,
  length: (value: number) => string,
): { readonly text: string; readonly brief: string } | null {
  const mesh = meshes.find((each) => each.part === part);
  if (code !== THINNED || !mesh?.thinnest || !at) return null;
  const share = quantities.percent(formatNumber(Math.max(0.1, 100 * mesh.thinned), 2));
  const [thin, where] = [length(mesh.thinnest), whereWords(at, outline)];
  return { text: said.thinnedTo(thin, where, share), brief: said.thinnedBrief(thin, where) };
}

function measured(measures: Measures, outline: Outline, unit: Unit, findings: readonly Finding[]): readonly Sentence[] {
  const codes = (part: number) => findings.filter((finding) => finding.part === part).map(({ code }) => code);
  const each = (part: PartMeasures) => ofPart(part, ofItsOwn(outline, part.part), unit, codes(part.part));
  return [...inParts(measures, each), ...stands(measures)];
}

/** What is said of each part, with its name where there are several. */
function inParts(measures: Measures, words: (part: PartMeasures) => readonly Sentence[]): readonly Sentence[] {
  return measures.parts.flatMap((part) =>
    words(part).map((sentence) => ({ ...sentence, text: named(measures, part.part, sentence.text) })),
  );
}

/** A sentence with the name of its part, where there are several. */
function named(measures: Measures | null, number: number | null, text: string): string {
  const part = measures?.parts.find((each) => each.part === number);
  if (!part || measures?.parts.length === 1) return text;
  return said.ofPart(isolated(partName(part.part, part.name)), text);
}

/** The outline is that of the first part: by it no place of another has a name. */
function ofItsOwn(outline: Outline, part: number | null): Outline {
  return part === null || part === 0 ? outline : [];
}

/** What has no foot and no rim has no shoulder between them. */
function namesPlaces(outline: Outline): boolean {
  return outline.length > 1;
}

function whereWords(at: Triple | null, outline: Outline): string {
  return at && namesPlaces(outline) ? said.places[placeOf(at, outline)] : said.inPlaces;
}

/** A wall that is too thin to be made where a model unit is so many millimetres. */
function thinWords({ thickness }: PartMeasures, outline: Outline, millimetres: number): readonly Sentence[] {
  if (!thickness || thickness.least.value * millimetres >= LEAST_PRINTED_MM) return [];
  const { value, at } = thickness.least;
  const thin = lengthWords(value * millimetres, "mm", 2);
  return [
    {
      severity: "warning",
      text: said.tooThin(thin, whereWords(at, outline)),
    },
  ];
}

/** `codes` are those of what the checks found of it. */
function ofPart(part: PartMeasures, outline: Outline, unit: Unit, codes: readonly string[]): readonly Sentence[] {
  const sentences: Sentence[] = [];
  const say = (severity: Severity, text: string) => sentences.push({ severity, text });
  const where = (at: Triple | null) => whereWords(at, outline);
  // What goes round a body is made as it is, and what has no wall beside pots is left out, as the checks say: neither is in the way of what is made.
  if (part.cause && !part.clay && !codes.includes(LEFT_OUT))
    say("error", whyWords({ ...part.cause, path: part.cause.path ?? "", message: part.reason ?? "" }, unit));
  const { thickness } = part;
  if (thickness) {
    const { least, asked } = thickness;
    const thin = lengthWords(least.value, unit, 3);
    if (part.thickness?.thinned.value && !codes.includes(THINNED)) {
      say("warning", said.thinned(thin, where(least.at), lengthWords(asked, unit, 3)));
    }
  }
  sentences.push(...thinWords(part, outline, MILLIMETRES[unit]));
  sentences.push(...overhangs(part, outline, codes.includes(CEILING)));
  return sentences;
}

/** A printer builds both sides of the wall: the pot prints without support where neither hangs over too far, and there is no ceiling beneath it. */
function overhangs(
  { overhang, overhangInside }: PartMeasures,
  outline: Outline,
  hasCeiling: boolean,
): readonly Sentence[] {
  const isNamed = namesPlaces(outline);
  const sides = [
    ...(overhang ? [{ degrees: overhang.degrees, place: whereWords(overhang.at, outline) }] : []),
    ...(overhangInside
      ? [
          {
            degrees: overhangInside.degrees,
            place: isNamed ? said.inside[hangingInside(overhangInside.at, outline)] : said.inPlaces,
          },
        ]
      : []),
  ].sort((a, b) => b.degrees - a.degrees);
  const [steepest] = sides;
  if (!steepest) return [];
  const hanging = sides.filter(({ degrees }) => degrees > SUPPORT_DEGREES);
  if (hanging.length > 0) {
    // Of two places without a name the one that hangs over further says it all.
    return (isNamed ? hanging : [steepest]).map(({ degrees, place }) => ({
      severity: "warning",
      text: said.overhang(degreesWords(degrees), place),
      support: true,
    }));
  }
  const [nowhere, somewhere] = hasCeiling
    ? [said.noOverhangOfWall, said.steepestOfWall]
    : [said.noOverhang, said.steepest];
  const place = isNamed ? steepest.place : null;
  const text = steepest.degrees > 1 ? somewhere(degreesWords(steepest.degrees), place) : nowhere;
  return [{ severity: "good", text }];
}

function stands({ tipping: { empty, full } }: Measures): readonly Sentence[] {
  if (!empty) return [];
  if (empty.degrees === 0) {
    return [{ severity: "error", text: said.falls }];
  }
  if (full && full.degrees === 0) {
    return [{ severity: "error", text: said.fallsFull }];
  }
  const steady = Math.min(empty.degrees, full?.degrees ?? empty.degrees) >= STEADY_DEGREES;
  const by = degreesWords(empty.degrees);
  const [alone, both] = steady ? [said.stands, said.standsFull] : [said.tips, said.tipsFull];
  const text = full ? both(by, degreesWords(full.degrees)) : alone(by);
  return [{ severity: steady ? "good" : "warning", text }];
}
