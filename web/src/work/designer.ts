/**
 * The designer behind the page, put together: the document, what follows it, and how they are connected. Whoever looks at one of them
 * from an effect or a template hears of its changes, and of nothing else.
 */

import { effect, signal } from "@preact/signals-core";
import { designOf } from "../document/gallery/exhibit";
import { FIRST } from "../document/gallery/first";
import type { SolverClient } from "../solver/client";
import { readSettings } from "../state/storage";
import type { Change, State } from "../state/store";
import { Store } from "../state/store";
import { Comparison } from "./comparison";
import { Keeper, type Surroundings } from "./keeper";
import type { Made } from "./made";
import { Notices, UNFETCHED } from "./notices";
import { Opening } from "./opening";
import { Surface } from "./surface";

export class Designer {
  readonly store: Store;
  readonly solver: SolverClient;
  readonly notices = new Notices();
  readonly surface: Surface;
  readonly comparison: Comparison;
  readonly keeper: Keeper;
  readonly opening: Opening;
  readonly #made = signal<Made | null>(null);
  #fetching: Promise<Made | null> | null = null;

  constructor(solver: SolverClient, around: Surroundings) {
    this.solver = solver;
    this.store = new Store(designOf(FIRST), readSettings(around.shelf));
    this.surface = new Surface(this.store, solver);
    this.comparison = new Comparison(this.store, this.surface, solver);
    this.keeper = new Keeper(this.store, this.surface, solver, this.notices, around);
    const maker = async () => (await this.openMade())?.maker ?? null;
    this.opening = new Opening(this.store, this.surface, this.keeper, solver, maker);
  }

  /** Lets everything follow the document until what comes back is called; may be called again after that. */
  connect(): () => void {
    const leaving = [
      this.surface.connect(),
      this.opening.connect(),
      this.keeper.connect(),
      this.comparison.connect(),
      effect(() => this.#made.value?.connect()),
    ];
    return () => {
      for (const leave of leaving) leave();
    };
  }

  get state(): State {
    return this.store.state;
  }

  apply(change: Change): void {
    this.store.apply(change);
  }

  /** What is made of the design; null before anything of it was wanted. */
  get made(): Made | null {
    return this.#made.value;
  }

  /** What makes things of the design, fetched now if it was not yet; null without a network. */
  openMade(): Promise<Made | null> {
    this.#fetching ??= import("./open-made").then(
      ({ openMade }) => {
        const made = openMade(this.store, this.surface);
        this.#made.value = made;
        return made;
      },
      () => {
        this.#fetching = null;
        this.notices.say(UNFETCHED);
        return null;
      },
    );
    return this.#fetching;
  }
}
