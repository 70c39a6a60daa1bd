/** What breaks the constraints of a scene, in sentences with the names of the parts. */

import { countsOf, toldOf } from "../document/breaches";
import { unitOf } from "../document/look";
import type { Breach, Constraints, Design, Finding, Report } from "../document/types";
import { isolated, listed } from "../language";
import { constraints as words } from "./english/constraints";
import { partName } from "./parts";
import { lengthWords } from "./quantities";
import { libraryWords } from "./refusals";
import type { Sentence } from "./report";

/** Digits of a bound. */
const DIGITS = 2;

/** The most parts of a group that are named; how many more there are is said. */
const MOST_NAMED = 4;

/** Codes of findings about two parts. */
const TOGETHER: readonly string[] = ["overlap", "same-place"];

/** One sentence: what is wrong with which parts, and what to do. */
export function breachWords(breach: Breach, design: Design): string {
  const [part, other] = [nameAt(breach.part, design), nameAt(breach.other, design)];
  const { distance } = breach;
  const away = () =>
    distance === null
      ? ""
      : words.away[breach.isProved ? "proved" : "measured"](lengthWords(distance, unitOf(design), DIGITS));
  switch (breach.code) {
    case "interference":
      return words.interference(part, other);
    case "within":
      return words.within(part, other);
    case "same-place":
      return words.samePlace(part, other);
    case "not-connected":
      return breach.group.length > 1
        ? words.groupNotConnected(groupWords(breach, design), other, part, away())
        : words.notConnected(part, other, away());
    case "contact":
      return words.contact(part, other);
    case "undecided-interference":
      return words.undecidedInterference(part, other);
    case "undecided-connection":
      return breach.group.length > 1
        ? words.undecidedGroup(groupWords(breach, design), other)
        : words.undecidedConnection(part, other);
    case "undecided-within":
      return words.undecidedWithin(part, other);
    default:
      return libraryWords(breach.message);
  }
}

/** Beside the witness on the stage: how far what is loose is away. How deep one place is in another part says little of how deep the parts are. */
export function witnessWords({ code, distance }: Breach, design: Design): string {
  return distance !== null && code === "not-connected" ? lengthWords(distance, unitOf(design), DIGITS) : words.here;
}

/** What is said of a scene that keeps its constraints. */
export function keptWords({ parts }: Design): string {
  const objects = new Set(parts.map(({ object }) => object ?? 0));
  if (objects.size === parts.length) return words.kept.separate;
  return objects.size === 1 ? words.kept.glued : words.kept.both;
}

/**
 * What checks say of files, with what is wrong between the parts before it. Nothing is called good of a scene that is broken, however closed its meshes are. Notes are left out: they are no matter of the file.
 * That glued parts run into each other, of which `report` is, is as it is meant to be, and said once.
 */
export function withScene(
  sentences: readonly Sentence[],
  found: Constraints,
  design: Design,
  report: Report | null = null,
): readonly Sentence[] {
  const told = toldOf(found).filter(({ severity }) => severity !== "note");
  const { broken } = countsOf(found);
  const isGlued = report?.findings.some((finding) => runsIntoGlued(finding, design)) ?? false;
  return [
    ...told.map((breach): Sentence => ({ severity: "warning", text: breachWords(breach, design) })),
    ...sentences.filter(({ severity }) => severity !== "good"),
    ...(isGlued ? [{ severity: "note", text: words.gluedInFile } as const] : []),
    ...sentences.filter(({ severity }) => broken === 0 && severity === "good"),
  ];
}

/** Whether a finding of the checks is that two parts run into each other that are glued. */
function runsIntoGlued({ code, part, args }: Finding, { parts }: Design): boolean {
  if (code !== "overlap" || args.what !== "touches" || part === null || typeof args.other !== "number") return false;
  const [one, other] = [parts[part], parts[args.other]];
  return one !== undefined && other !== undefined && (one.object ?? 0) === (other.object ?? 0);
}

/** The findings of checks but for those of two parts of which the scene tells, what runs into each other in space does so in the file, and of two that are glued. */
export function withoutPairs(report: Report, found: Constraints, design: Design): Report {
  const told = new Set(found.breaches.flatMap(({ part, other }) => [`${part} ${other}`, `${other} ${part}`]));
  const isTold = ({ code, part, args }: Finding) => TOGETHER.includes(code) && told.has(`${part} ${args.other}`);
  return {
    ...report,
    findings: report.findings.filter((finding) => !isTold(finding) && !runsIntoGlued(finding, design)),
  };
}

/** “Knob, Lid, and Ring”; of many the first, and how many more. */
function groupWords({ group }: Breach, design: Design): string {
  const named = group.length > MOST_NAMED ? group.slice(0, MOST_NAMED - 1) : group;
  const names = named.map((place) => nameAt(place, design));
  return listed(named.length < group.length ? [...names, words.more(group.length - named.length)] : names);
}

export function nameAt(place: number, design: Design): string {
  return isolated(partName(place, design.parts[place]?.name));
}
