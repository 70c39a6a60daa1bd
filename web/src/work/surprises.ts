/** Pots that nobody has thought of, one after the other: each of a seed of its own, and each such that it can be made. */

import { surprise } from "../document/surprise";
import type { Design } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { Outcome } from "../worker/port";

/** Seeds are whole numbers below this. */
const SEEDS = 2 ** 32;
/** So many seeds in a row may be refused; by what the tests find, one is too many. */
const PATIENCE = 20;

/** Judges a design; null where nobody can, for want of a network. */
type Judge = (design: Design) => Promise<Outcome<{ readonly ok: boolean }> | null>;

export class Surprises {
  readonly #judge: Judge;
  readonly #seed: () => number;
  #last: number | null = null;
  #asked = 0;

  constructor(judge: Judge, seed: () => number = anySeed) {
    this.#judge = judge;
    this.#seed = seed;
  }

  /** Another pot than the last; null where a newer one was asked for meanwhile, or none can be made. */
  async next(): Promise<Design | null> {
    this.#asked += 1;
    const mine = this.#asked;
    const first = this.#seed();
    for (let tried = 0; tried < PATIENCE; tried += 1) {
      const seed = (first + tried) % SEEDS;
      if (seed === this.#last) continue;
      const design = surprise(seed);
      const judged = await this.#judge(design);
      if (mine !== this.#asked) return null;
      if (judged?.state === "superseded") return null;
      if (judged === null || (judged.state === "done" && judged.value.ok)) {
        this.#last = seed;
        return design;
      }
    }
    return null;
  }
}

/** Has a maker judge, where there is one, in a lane of its own. */
export function judgedBy(maker: () => Promise<MakerClient | null>): Judge {
  return async (design) => (await maker())?.ask({ kind: "check", design, making: {} }, "surprise") ?? null;
}

function anySeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0] ?? 0;
}
