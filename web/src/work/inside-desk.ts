/** How a person looks into a blend, and what is seen there. Fetched with the panel, and kept as long as the page is open. */

import { batch, signal } from "@preact/signals-core";
import { type Look, type SeenInside, USUAL } from "../document/blend/looking";
import type { Blend, Refusal } from "../document/types";
import type { Designer } from "./designer";

const LANE = "inside";

/** What is seen, of which blend and how. */
export interface Seen {
  readonly blend: Blend;
  readonly look: Look;
  readonly inside: SeenInside;
}

export class InsideDesk {
  readonly #look = signal<Look>(USUAL);
  readonly #seen = signal<Seen | null>(null);
  readonly #problem = signal<Refusal | null>(null);
  /** What was asked for last. */
  #asked: { readonly blend: Blend; readonly look: Look } | null = null;

  get look(): Look {
    return this.#look.value;
  }

  set(change: Partial<Look>): void {
    this.#look.value = { ...this.#look.peek(), ...change };
  }

  get seen(): Seen | null {
    return this.#seen.value;
  }

  /** Why there is nothing to see. */
  get problem(): Refusal | null {
    return this.#problem.value;
  }

  /** Asks for what is not known or under way yet; the latest wins. */
  async follow(designer: Designer, part: number): Promise<void> {
    const { design } = designer.store;
    const blend = design.parts[part]?.shape;
    const look = this.#look.value;
    if (blend?.kind !== "blend" || (this.#asked?.blend === blend && this.#asked.look === look)) return;
    this.#asked = { blend, look };
    const made = await designer.openMade();
    if (!made) {
      this.#asked = null;
      return;
    }
    const outcome = await made.maker.ask({ kind: "inside", design, part, look }, LANE);
    if (outcome.state === "superseded") return;
    batch(() => {
      this.#problem.value = outcome.state === "refused" ? outcome.refusal : null;
      this.#seen.value = outcome.state === "done" ? { blend, look, inside: outcome.value } : null;
    });
  }

  leave(): void {
    this.#asked = null;
    batch(() => {
      this.#seen.value = null;
      this.#problem.value = null;
    });
  }
}

const desks = new WeakMap<Designer, InsideDesk>();

export function insideDesk(designer: Designer): InsideDesk {
  const known = desks.get(designer) ?? new InsideDesk();
  desks.set(designer, known);
  return known;
}
