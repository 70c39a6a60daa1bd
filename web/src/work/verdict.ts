/** Whether the pot on the stage can be made. */

import { unitOf } from "../document/look";
import { withoutPairs, withScene } from "../words/constraints";
import { refusalWords } from "../words/refusals";
import { type Sentence, verdict } from "../words/report";
import type { Designer } from "./designer";

/** What stands in the way of the design as it is now, and what speaks for it, the worst first; empty before that is known: of an earlier one nothing is said. */
export function verdictNow({ made, state: { design }, surface }: Designer): readonly Sentence[] {
  if (!made) return [];
  const pieces = [made.solid, made.report, made.measures, made.constraints];
  const problem = pieces.find((piece) => piece.problem && made.isOfNow(piece))?.problem;
  if (problem) return [{ severity: "error", text: refusalWords(problem, design) }];
  const known = made.isOfNow(made.measures) && made.isOfNow(made.report) ? made : null;
  // A scene is not said to be good before that is known of its parts together.
  const scene = design.parts.length > 1 && made.isOfNow(made.constraints) ? made.constraints.value : null;
  const report = known?.report.value ?? null;
  const outline = surface.shown?.solved.facts?.outline ?? [];
  const measures = known?.measures.value ?? null;
  const own = verdict(
    measures,
    report && scene ? withoutPairs(report, scene, design) : report,
    outline,
    unitOf(design),
  );
  if (design.parts.length === 1) return own;
  return scene && own.length > 0 ? withScene(own, scene, design, report) : [];
}
