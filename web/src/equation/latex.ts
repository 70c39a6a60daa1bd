/** The whole of a shape's equation as LaTeX, for papers: every wave, with all digits. */

import type { TwoSided } from "../document/types";
import { closed } from "./closed";
import { differential } from "./differential";
import { edges } from "./edges";
import { problemOf } from "./posed";
import type { Formula } from "./writer";
import { WHOLE } from "./writer";

/** What stands before each part, as a comment. */
export interface Titles {
  readonly pde: string;
  readonly edges: string;
  readonly closed: string;
  readonly where: string;
}

export function latexOf(shape: TwoSided, titles: Titles): string {
  const problem = problemOf(shape);
  const form = closed(problem, WHOLE);
  const part = (title: string, formulas: readonly Formula[]) =>
    formulas.length === 0 ? [] : [`% ${title}`, ...formulas.map(({ tex }) => `\\[ ${tex} \\]`), ""];
  return [
    ...part(titles.pde, differential(problem, WHOLE)),
    ...part(
      titles.edges,
      edges(problem, WHOLE).map(({ formula }) => formula),
    ),
    ...part(titles.closed, [...form.sums, ...form.solved.map(({ formula }) => formula)]),
    ...part(titles.where, form.systems),
  ].join("\n");
}
