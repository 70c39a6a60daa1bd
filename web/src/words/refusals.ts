/**
 * Refusals as sentences, from their code and what they name. What a person reads begins with the thing that it is about, as the page calls it; how the document calls it
 * stands behind, for whoever writes documents.
 */

import type { JointName } from "../document/joints";
import { unitOf } from "../document/look";
import { getPath, type Path, pathOf, pathText } from "../document/path";
import { familyOf } from "../document/schema";
import type { Design, Refusal, Unit } from "../document/types";
import { either, isolated, listed } from "../language";
import { formatNumber } from "../number";
import { refusals } from "./english/refusals";
import { fieldWords } from "./parameters";
import { partName } from "./parts";

/** Why, where the place already says of what. `unit` is that of the lengths, where it is known. */
export function whyWords(refusal: Refusal, unit: Unit | null = null): string {
  const own = later[refusal.code]?.(refusal, unit) ?? STATEMENTS[refusal.code]?.(refusal, unit) ?? null;
  return own ?? refusals.general[refusal.code] ?? libraryWords(refusal.message);
}

/** What the library says, where all that is known of it is its sentence. */
export function libraryWords(message: string): string {
  const ended = /[.!?]$/.test(message) ? message : `${message}.`;
  return refusals.library(ended.charAt(0).toUpperCase() + ended.slice(1));
}

/** The whole sentence. `design` is what was refused, where the page has it. */
export function refusalWords(refusal: Refusal, design: Design | null = null): string {
  const why = whyWords(refusal, design && unitOf(design));
  const path = pathOf(refusal.path);
  // What is not known there is named by the sentence itself.
  const subjects = subjectsOf(refusal.code === "unknown-field" ? path.slice(0, -1) : path, design);
  return subjects.length === 0 ? why : refusals.of(refusals.within(subjects), why);
}

export type Statement = (refusal: Refusal, unit: Unit | null) => string | null;

/** What only makers refuse, and what only files have. */
const later: Record<string, Statement> = {};

/** From here on these tell of refusals too. They come with what makes pots or reads files: nobody waits for them before. */
export function tellOf(statements: Readonly<Record<string, Statement>>): void {
  Object.assign(later, statements);
}

/** Null where what the refusal names is not enough for a sentence of the page's own. */
const STATEMENTS: Readonly<Record<string, Statement>> = {
  "out-of-range": (refusal) => expected(refusal, rangeOf(refusal)),
  "unknown-name": (refusal) => expected(refusal, wordsOf(refusal, either)),
  "unknown-field": (refusal) => {
    const found = textOf(refusal, "found");
    return found && wordsOf(refusal, (words) => refusals.unknownField(isolated(found), listed(words)));
  },
  "missing-field": () => refusals.missing,
  "not-finite": () => refusals.notFinite,
  "too-large": (refusal) => {
    if (refusal.args?.rows !== undefined) return refusals.tooManyPoints;
    const [found, greatest] = [numberOf(refusal, "found"), numberOf(refusal, "greatest")];
    // Of what a shape has too much to be made, what makes it speaks.
    const counts = found !== null && greatest !== null && !refusal.path.includes(".shape");
    return counts ? refusals.tooMany(found, greatest) : null;
  },
  "no-wall": () => refusals.noWall,
  overflow: () => refusals.overflow,
  "resonant-problem": () => refusals.resonant,
  "file-too-large": (refusal) => refusals.fileTooLarge(isolated(named(refusal))),
  "no-design": (refusal) =>
    (/\.stl$/i.test(named(refusal)) ? refusals.noDesignInStl : refusals.noDesign)(isolated(named(refusal))),
  "solver-stopped": () => refusals.solverStopped,
  "maker-stopped": () => refusals.makerStopped,
  "solver-unusable": ({ message }) => refusals.solverUnusable(message),
  "maker-unusable": ({ message }) => refusals.makerUnusable(message),
};

/** The name of the file that was refused. */
function named(refusal: Refusal): string {
  return textOf(refusal, "name") ?? "";
}

export function textOf({ args }: Refusal, name: string): string | null {
  const text = args?.[name];
  return typeof text === "string" ? text : null;
}

export function numberOf({ args }: Refusal, name: string): string | null {
  const number = args?.[name];
  return typeof number === "number" ? formatNumber(number) : null;
}

function wordsOf({ args }: Refusal, say: (words: readonly string[]) => string): string | null {
  const words = args?.words;
  return typeof words === "object" && words.length > 0 ? say(words) : null;
}

function expected(refusal: Refusal, what: string | null): string | null {
  if (what === null) return null;
  const text = textOf(refusal, "found");
  const found = text === null ? numberOf(refusal, "found") : refusals.quoted(isolated(text));
  return found === null ? refusals.hasToBe(what) : refusals.hasToBeNot(what, found);
}

function rangeOf(refusal: Refusal): string | null {
  const end = (name: string) => numberOf(refusal, name);
  const [least, greatest, above, below, not] = [end("least"), end("greatest"), end("above"), end("below"), end("not")];
  if (least !== null || greatest !== null) return refusals.range(least, greatest);
  if (above !== null || below !== null) return refusals.open(above, below);
  return not === null ? null : refusals.not(not);
}

/** What a place of the document is called on the page, from the large to the small. */
function subjectsOf(path: Path, design: Design | null): readonly string[] {
  const [first, place, ...rest] = path;
  if (first === undefined) return [];
  if (first !== "parts" || typeof place !== "number") return [fieldOf(String(first))];
  const part = design?.parts[place];
  const whole = partName(place, part?.name === undefined ? undefined : isolated(part.name));
  // Of a pot of one part nobody says so.
  const told = design?.parts.length === 1 ? [] : [whole];
  const [kind, ...inside] = rest;
  if (kind === undefined) return told;
  const [joint, limits, end] = inside;
  if (kind === "joints" && limits === "limits") {
    const label = part?.joints?.[joint as JointName]?.label;
    return [
      ...told,
      fieldOf(kind),
      label ? refusals.quoted(isolated(label)) : "",
      refusals.limits[Number(end)] ?? "",
    ].filter(Boolean);
  }
  if (kind === "place") {
    const [what, axis] = inside;
    const said = refusals.placed[what as keyof typeof refusals.placed];
    return said ? [...told, said(refusals.axes[Number(axis)] ?? "")] : [...told, fieldOf(kind)];
  }
  if (kind !== "shape")
    return [...told, fieldOf(String(kind)), ...(inside.length > 0 ? [refusals.field(pathText(inside))] : [])];
  return [...told, ...numberOfShape(inside, part?.shape)];
}

function fieldOf(name: string): string {
  return refusals.fields[name as keyof typeof refusals.fields] ?? refusals.field(name);
}

function numberOfShape(path: Path, shape: Design["parts"][number]["shape"] | undefined): readonly string[] {
  if (path.length === 0) return [];
  const family = shape && familyOf(shape.kind);
  const field = family?.fields.find((each) => pathText(each.path) === pathText(path));
  if (family && field) return [fieldWords(family.kind, field.key).name];
  if (shape?.kind === "vertex-frame") return placeInNetwork(path);
  const [axis, modes, index] = path;
  if (shape?.kind === "octant" && typeof modes === "number") return [refusals.exponent(refusals.axes[modes] ?? "")];
  if (shape?.kind !== "boundary-value" || !(axis === "x" || axis === "y" || axis === "z"))
    return [refusals.field(pathText(path))];
  const n = modes === "modes" ? getPath(shape, [axis, "modes", index ?? 0, "n"]) : undefined;
  const component = refusals.component(axis);
  return typeof n === "number" ? [component, refusals.mode(formatNumber(n))] : [component];
}

/** “patch 3, force 1, u to”; what has no words here as the document calls it. */
function placeInNetwork(path: Path): readonly string[] {
  const { network: words, axes } = refusals;
  const [what, index, ...inside] = path;
  const along = (at: Path[number] | undefined) => (typeof at === "number" ? [words.component(axes[at] ?? "")] : []);
  const numbered = (say: (n: string) => string, at: number) => say(formatNumber(at + 1));
  if (what !== "patches" && what !== "vertices") return [refusals.field(pathText(path))];
  if (typeof index !== "number") return [words[what]];
  if (what === "vertices") return [numbered(words.point, index), ...along(inside[0])];
  const force = inside[0] === "forces" && typeof inside[1] === "number" ? inside[1] : null;
  const told = [numbered(words.patch, index), ...(force === null ? [] : [numbered(words.force, force)])];
  const [key, at] = force === null ? inside : inside.slice(2);
  switch (key) {
    case undefined:
      return told;
    case "frame":
      return [...told, typeof at === "number" ? numbered(words.corner, at) : words.frame];
    case "u":
    case "v":
      return [...told, words.ends[Number(at)]?.(key) ?? key];
    case "a1":
    case "a2":
    case "f0":
      return [...told, words[key], ...along(at)];
    case "falloff":
      return [...told, words.falloff];
    default:
      return [...told, refusals.field(pathText(inside))];
  }
}
