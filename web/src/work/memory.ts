/** Undo survives a reload: the nearest steps are kept for as long as the tab is open, and come back when what is opened is the design that they lead from. */

import type { Design } from "../document/types";
import type { SolverClient } from "../solver/client";
import type { Identified } from "../state/part-ids";
import type { Step } from "../state/steps";
import { bounded } from "../state/steps";
import { keepSteps, readSteps, type Shelf } from "../state/storage";
import type { Store } from "../state/store";

export class Memory {
  readonly #shelf: Shelf | null;
  readonly #solver: SolverClient;
  /** Documents are frozen: each is written once. */
  readonly #texts = new WeakMap<Design, string>();

  constructor(tabShelf: Shelf | null, solver: SolverClient) {
    this.#shelf = tabShelf;
    this.#solver = solver;
  }

  /** Keeps the steps about the design of this link. */
  keep(link: string, { history, ids }: Store): void {
    const [past, future] = [history.past, history.future].map((all) => all.map((step) => this.#written(step)));
    keepSteps(this.#shelf, bounded({ link, ids, past: past ?? [], future: future ?? [] }));
  }

  /** Brings them back to where the design of this link was just opened. What the solver refuses is left out. */
  async recall(link: string, store: Store): Promise<void> {
    const steps = readSteps(this.#shelf);
    const { design, ids } = store;
    if (steps?.link !== link || steps.ids.length !== ids.length) return;
    const past = await this.#read(steps.past);
    const future = await this.#read(steps.future);
    store.recall({ past, future }, steps.ids, ids);
    // Meanwhile the page may have kept that there are none.
    if (store.design === design) this.keep(link, store);
  }

  async #read(steps: readonly Step[]): Promise<readonly Identified[]> {
    const read = await Promise.all(
      steps.map(async ({ text, ids }): Promise<readonly Identified[]> => {
        const outcome = await this.#solver.parse(text);
        if (outcome.state !== "done" || outcome.value.design.parts.length !== ids.length) return [];
        return [{ design: outcome.value.design, ids }];
      }),
    );
    return read.flat();
  }

  #written({ design, ids }: Identified): Step {
    const text = this.#texts.get(design) ?? JSON.stringify(design);
    this.#texts.set(design, text);
    return { text, ids };
  }
}
