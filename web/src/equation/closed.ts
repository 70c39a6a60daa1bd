/**
 * The closed form of a shape: its coordinates as sums of waves, what stands before each wave as a function of `u`, and what those functions are made of. Every number in it is given, or is a root of the equation, or a slope
 * that the rings decide: rounding one moves the surface by no more than that.
 */

import { AXES, type Axis } from "../document/boundary-value";
import type { Amount } from "./amount";
import { modeFormula, type Written } from "./mode-formula";
import { isHeldAtEndsAlone, type Modes, modesOf } from "./modes";
import type { Problem } from "./problem";
import { type Roots, rootsOf } from "./roots";
import { waveBody } from "./series";
import { systemFormulas, systemOf } from "./systems";
import { type Formula, type Hand, Writer } from "./writer";

/** One function of `u`, and the roots that it is made of. */
export interface Solved extends Written {
  /** It is `q` with this index, from 1. */
  readonly index: number;
  readonly roots: Roots;
}

export interface Closed {
  /** `x`, `y` and `z`. */
  readonly sums: readonly Formula[];
  readonly solved: readonly Solved[];
  /** How many functions there are that are not written. */
  readonly hidden: number;
  /** What the functions of order 4 are made of. */
  readonly systems: readonly Formula[];
}

export function closed(problem: Problem, hand: Hand): Closed {
  const modes = modesOf(problem);
  const endsAlone = isHeldAtEndsAlone(problem);
  const shown = modes.list.slice(0, hand.most);
  const systems = new Map<string, { readonly index: number; readonly roots: Roots; readonly by: Amount[] }>();
  const solved = shown.map((mode): Solved => {
    const { component, harmonic, index, k } = mode;
    const roots = rootsOf(component, k);
    const key = systemOf(roots, endsAlone);
    const known = systems.get(key) ?? { index: systems.size + 1, roots, by: [] };
    known.by.push(component.s, component.t, component.w, harmonic.n);
    if (key !== "") systems.set(key, known);
    return { index, roots, ...modeFormula(problem, mode, roots, known.index, hand) };
  });
  return {
    sums: AXES.map((axis) => sum(problem, axis, modes, hand)),
    solved,
    hidden: modes.list.length - shown.length,
    systems: systemFormulas([...systems.values()], endsAlone, hand),
  };
}

function sum({ components, span }: Problem, axis: Axis, { indexOf }: Modes, hand: Hand): Formula {
  const writer = new Writer(hand);
  const terms = components[axis].harmonics.flatMap((harmonic) => {
    const index = indexOf.get(harmonic);
    return index === undefined ? [] : [{ harmonic, index }];
  });
  const shown = terms.slice(0, hand.most).map(({ harmonic, index }) => {
    const body = waveBody(writer, harmonic, span);
    return `q_{${index}}(u)${body === "" ? "" : `\\,${body}`}`;
  });
  if (shown.length < terms.length) shown.push("\\cdots");
  return writer.formula(`${axis}(u,v)=${shown.length === 0 ? "0" : shown.join("+")}`);
}
