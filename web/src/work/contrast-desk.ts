/** What is known of how the design on the stage differs from another: it follows the document, once that rests. */

import { batch, signal } from "@preact/signals-core";
import type { Design, Difference, Refusal } from "../document/types";
import type { SolvedParts } from "../solver/solved";
import type { Designer } from "./designer";

/** How this design differs from that one. */
export interface Told {
  readonly here: Design;
  readonly there: Design;
  readonly difference: Difference;
}

/** What the other scene looks like. */
export interface Seen {
  readonly there: Design;
  readonly solved: SolvedParts;
}

const LANE = "contrast";

export class ContrastDesk {
  readonly #designer: Designer;
  readonly #told = signal<Told | null>(null);
  readonly #seen = signal<Seen | null>(null);
  readonly #problem = signal<Refusal | null>(null);
  /** What was asked for last. */
  #solving: Design | null = null;
  #comparing: { readonly here: Design; readonly there: Design } | null = null;

  constructor(designer: Designer) {
    this.#designer = designer;
  }

  /** Of the design as it is now; null until it is known. */
  get told(): Told | null {
    const told = this.#told.value;
    const { contrast, store } = this.#designer;
    return told?.here === store.design && told.there === contrast.there ? told : null;
  }

  get seen(): Seen | null {
    const seen = this.#seen.value;
    return seen?.there === this.#designer.contrast.there ? seen : null;
  }

  /** Why there is nothing to tell. */
  get problem(): Refusal | null {
    return this.#problem.value;
  }

  /** Asks for what is not known or under way yet; the latest wins. */
  follow(): void {
    const { contrast, surface } = this.#designer;
    const { there } = contrast;
    const here = surface.settled?.design;
    if (!there) return;
    if (this.#solving !== there) void this.#solve(there);
    if (here && (this.#comparing?.here !== here || this.#comparing.there !== there)) void this.#compare(here, there);
  }

  async #solve(there: Design): Promise<void> {
    this.#solving = there;
    if (this.#problem.peek()) this.#problem.value = null;
    const { solver, surface } = this.#designer;
    const { rows, columns } = surface.grid(there);
    const outcome = await solver.mesh(LANE, there, rows, columns);
    if (this.#solving !== there || outcome.state === "superseded") return;
    batch(() => {
      if (outcome.state === "refused") this.#problem.value = outcome.refusal;
      else this.#seen.value = { there, solved: outcome.value };
    });
  }

  async #compare(here: Design, there: Design): Promise<void> {
    const mine = { here, there };
    this.#comparing = mine;
    const made = await this.#designer.openMade();
    const outcome = await made?.maker.ask({ kind: "compare", before: there, after: here }, LANE);
    if (this.#comparing !== mine) return;
    if (!outcome || outcome.state === "superseded") {
      this.#comparing = null;
      return;
    }
    batch(() => {
      this.#problem.value = outcome.state === "refused" ? outcome.refusal : null;
      if (outcome.state === "done") this.#told.value = { here, there, difference: outcome.value };
    });
  }
}

const desks = new WeakMap<Designer, ContrastDesk>();

export function contrastDesk(designer: Designer): ContrastDesk {
  const known = desks.get(designer) ?? new ContrastDesk(designer);
  desks.set(designer, known);
  return known;
}
