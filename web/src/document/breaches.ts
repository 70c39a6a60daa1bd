/** What is told of the constraints of a scene, and what would mend it. */

import type { Breach, Constraints, Design } from "./types";

/** What could be done about a breach: glue both, put both apart, put both together, let what is loose be an object of its own, or take a part away. */
export type Mend = "glue" | "apart" | "together" | "separate" | "remove";

const ORDER: readonly Breach["severity"][] = ["error", "warning", "note"];

/** The worst first. Two objects of which one is wholly inside the other run into each other too, and it is enough to be told once. */
export function toldOf({ breaches }: Pick<Constraints, "breaches">): readonly Breach[] {
  const pair = ({ part, other }: Breach) => [part, other].sort((a, b) => a - b).join();
  const within = new Set(breaches.filter(({ code }) => code === "within").map(pair));
  return breaches
    .filter((breach) => breach.code !== "interference" || !within.has(pair(breach)))
    .toSorted((a, b) => ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity));
}

/** How many parts break a constraint, and of how many that could not be told. */
export function countsOf(constraints: Constraints): { readonly broken: number; readonly undecided: number } {
  const count = (severity: Breach["severity"]) =>
    constraints.breaches.filter((breach) => breach.severity === severity).length;
  // Of those that are left out nothing is known: they are taken for the worse.
  return { broken: count("error") + constraints.leftOut, undecided: count("warning") };
}

/** What would mend a breach. Nothing is proposed that would break something else by itself. */
export function mendsOf(breach: Breach, design: Design): readonly Mend[] {
  const isOneObject = objectAt(design, breach.part) === objectAt(design, breach.other);
  switch (breach.code) {
    case "interference":
      return ["apart", "glue"];
    case "undecided-interference":
      return ["apart"];
    case "within":
      return isOneObject ? ["remove"] : ["remove", "apart"];
    case "same-place":
      return ["remove"];
    case "not-connected":
      return ["together", "separate"];
    default:
      return [];
  }
}

function objectAt(design: Design, place: number): number {
  return design.parts[place]?.object ?? 0;
}
