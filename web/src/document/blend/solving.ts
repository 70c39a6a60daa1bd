/** How the equation of a blend is solved: by which method, with how many terms, with which weights. What holds where nothing is given is left out of the document. */

import { LIMITS } from "../tables.gen";
import type { Blend, Section, Triple } from "../types";
import { isClosed } from "./section";
import { METHODS, TERMS } from "./tables.gen";

export type Method = (typeof METHODS)[number];

const EVEN: Triple = [1, 1, 1];

/** The method that holds where none is given. */
function usualMethod({ start, end }: Blend): Method {
  return isClosed(start.form) && isClosed(end.form) ? "exact" : "modal";
}

export function methodOf(blend: Blend): Method {
  return blend.method ?? usualMethod(blend);
}

/** The methods that solve a blend between these sections. */
export function methodsFor({ start, end }: Blend): readonly Method[] {
  // What is no polynomial across has no closed form.
  const isRooted = start.form === "disc-in-square" || end.form === "disc-in-square";
  return METHODS.filter((method) => method !== "exact" || !isRooted);
}

export function withMethod(blend: Blend, method: Method): Blend {
  const { method: _before, ...rest } = blend;
  return method === usualMethod(blend) ? rest : { ...rest, method };
}

/** The blend without a method that does not solve these sections, or that holds anyway. */
export function settled(blend: Blend): Blend {
  const { method, ...rest } = blend;
  if (method === undefined) return blend;
  return methodsFor(blend).includes(method) && method !== usualMethod(blend) ? blend : rest;
}

export function weightsOf({ weights }: Blend): Triple {
  return weights ?? EVEN;
}

export function withWeight(blend: Blend, index: number, value: number): Blend {
  const before = weightsOf(blend);
  if (before[index] === value) return blend;
  const [a, b, c] = before.map((each, at) => (at === index ? value : each)) as unknown as Triple;
  const { weights: _before, ...rest } = blend;
  return a === 1 && b === 1 && c === 1 ? rest : { ...rest, weights: [a, b, c] };
}

export function termsOf({ terms }: Blend): Triple {
  return terms ?? TERMS.usual;
}

/** Whole, and no more than there can be. */
export function withTerm(blend: Blend, index: number, value: number): Blend {
  const before = termsOf(blend);
  const count = Math.min(Math.max(Math.round(value), 1), TERMS.most[index] ?? 1);
  if (before[index] === count) return blend;
  const terms = before.map((each, at) => (at === index ? count : each)) as unknown as Triple;
  const { terms: _before, ...rest } = blend;
  return terms.every((each, at) => each === TERMS.usual[at]) ? rest : { ...rest, terms };
}

/** Of the terms along `u`, `v` and `w` those that a method uses. */
export function termsUsed(method: Method): number {
  return { exact: 0, modal: 2, collocation: 3 }[method];
}

/** A wave that goes round more often than the sines of a method can tell. */
export interface Unseen {
  readonly waves: number;
  readonly terms: number;
}

/** The fastest wave of both sections, where the method takes sines and fewer along `v` than two for each of its turns: the inside may be carried far off then. Where it is, the solver says so when the solid is made. */
export function unseenOf(blend: Blend): Unseen | null {
  const [, terms] = termsOf(blend);
  const waves = Math.max(0, ...[blend.start, blend.end].map(fastestOf));
  return termsUsed(methodOf(blend)) > 0 && 2 * waves > terms ? { waves, terms } : null;
}

function fastestOf(section: Section): number {
  if (section.form !== "outline") return 0;
  return [...section.x, ...section.y].reduce((most, { n }) => Math.max(most, n), 0);
}

/** The blend with as many terms as see every wave of its sections; null where there cannot be so many. */
export function withEnoughTerms(blend: Blend): Blend | null {
  const unseen = unseenOf(blend);
  if (!unseen) return null;
  const [across] = termsOf(blend);
  const least = 2 * unseen.waves;
  const fits = least <= (TERMS.most[1] ?? 0) && across * least <= LIMITS.modes;
  return fits ? withTerm(blend, 1, least) : null;
}
