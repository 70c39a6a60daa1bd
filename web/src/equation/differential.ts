/** The differential equation of a shape. */

import { AXES, type Axis } from "../document/boundary-value";
import type { Amount } from "./amount";
import type { Component, Problem } from "./problem";
import { polynomialTerms } from "./series";
import { aligned, type Formula, type Hand, Writer } from "./writer";

/** One formula where all coordinates obey the same, else one for each: with symbols where it has some, then with numbers. */
export function differential(problem: Problem, hand: Hand): Formula[] {
  const { smoothing } = problem;
  if (smoothing) return [smoothed(problem, smoothing, hand)];
  return AXES.map((axis) => oneOf(problem, axis, hand));
}

function smoothed({ rings }: Problem, a: Amount, hand: Hand): Formula {
  const writer = new Writer(hand);
  const held = rings.length > 0 ? "\\sum_{i}\\mathbf{F}_{i}(v)\\,\\delta(u-u_{i})" : "0";
  const write = () =>
    `\\left(\\partial_{u}^{2}+${writer.power(a, 2)}\\,\\partial_{v}^{2}\\right)^{2}\\,\\mathbf{X}&=${held}`;
  const lines = [writer.symbols(write), write()];
  return writer.formula(aligned([...lines, "\\mathbf{X}&=(x,y,z)"]));
}

function oneOf(problem: Problem, axis: Axis, hand: Hand): Formula {
  const component = problem.components[axis];
  const writer = new Writer(hand);
  // A force is long: it has a line of its own.
  const write = (mark: string, isForced: boolean) =>
    `${mark}${left(writer, component, axis)}${isForced ? "\\\\&\\quad" : ""}=${right(writer, problem, component, axis)}`;
  const isNamed = component.s.name !== undefined;
  const force = component.harmonics.flatMap((harmonic) => harmonic.force);
  const [inSymbols, inNumbers] = [force.some(({ name }) => name !== undefined), force.some(({ value }) => value !== 0)];
  const numbers = write("&", inNumbers);
  return writer.formula(aligned(isNamed ? [writer.symbols(() => write("&", inSymbols)), numbers] : [numbers]));
}

function left(writer: Writer, { order, s, t, w }: Component, axis: Axis): string {
  const by = (u: number, v: number) => {
    const power = (n: number) => (n === 1 ? "" : `^{${n}}`);
    const below = [u > 0 ? `\\partial u${power(u)}` : "", v > 0 ? `\\partial v${power(v)}` : ""].join("\\,");
    return `\\frac{\\partial${power(u + v)}${axis}}{${below}}`;
  };
  const terms =
    order === 2
      ? [
          { amount: s, body: by(2, 0) },
          { amount: t, body: by(0, 2) },
        ]
      : [
          { amount: s, body: by(4, 0) },
          { amount: t, body: by(2, 2) },
          { amount: w, body: by(0, 4) },
        ];
  return writer.sum(terms);
}

function right(writer: Writer, { span, rings }: Problem, component: Component, axis: Axis): string {
  const forced = component.harmonics.filter(({ force }) => force.some((amount) => writer.says(amount)));
  const shown = forced.slice(0, writer.hand.most);
  const pieces = shown.map(({ n, wave, force }) => {
    const terms = polynomialTerms(force).filter(({ amount }) => writer.says(amount));
    const { most } = writer.hand;
    const polynomial = writer.sum(terms.slice(0, most), terms.length > most);
    if (n.value === 0 && n.name === undefined) return polynomial;
    return `\\left(${polynomial}\\right)\\,${writer.wave(wave, n, span)}`;
  });
  if (forced.length > shown.length) pieces.push("\\cdots");
  if (rings.length > 0) pieces.push(`\\sum_{i}F_{${axis},i}(v)\\,\\delta(u-u_{i})`);
  return pieces.length === 0 ? "0" : pieces.join("+");
}
