/** Sums of powers and of waves, term by term. */

import type { Amount } from "./amount";
import type { Harmonic, Problem, Round } from "./problem";
import type { Term, Writer } from "./writer";

/** A polynomial in ascending powers. */
export function polynomialTerms(polynomial: readonly Amount[], digits?: number): Term[] {
  return polynomial.map((amount, power) => ({
    amount,
    body: power === 0 ? "" : power === 1 ? "u" : `u^{${power}}`,
    ...(digits === undefined ? {} : { digits }),
  }));
}

/** What stands before a wave, `1` where it does not go round. */
export function waveBody(writer: Writer, { n, wave }: Pick<Harmonic, "n" | "wave">, span: Problem["span"]): string {
  return n.value === 0 && n.name === undefined ? "" : writer.wave(wave, n, span);
}

/** A sum of waves of which each is given an amount; of many the first. */
export function waves(
  writer: Writer,
  harmonics: readonly Harmonic[],
  span: Problem["span"],
  of: (harmonic: Harmonic) => Amount,
): string {
  const said = harmonics.filter((harmonic) => writer.says(of(harmonic)));
  const shown = said.slice(0, writer.hand.most);
  return writer.sum(
    shown.map((harmonic) => ({ amount: of(harmonic), body: waveBody(writer, harmonic, span) })),
    said.length > shown.length,
  );
}

/** A radius or a height round the pot. */
export function round(writer: Writer, { mean, waves: all }: Round): string {
  const parts = all.flatMap(({ n, cos, sin }) => [
    { n, wave: "cos" as const, amount: cos },
    { n, wave: "sin" as const, amount: sin },
  ]);
  const said = parts.filter(({ amount }) => amount.value !== 0);
  const shown = said.slice(0, writer.hand.most);
  const terms = shown.map(({ n, wave, amount }): Term => ({ amount, body: writer.wave(wave, n, "turn") }));
  return writer.sum([{ amount: mean, body: "" }, ...terms], said.length > shown.length);
}
