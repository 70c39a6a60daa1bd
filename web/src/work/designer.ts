/**
 * The designer behind the page, put together: the document, what follows it, and how they are connected. Whoever looks at one of them
 * from an effect or a template hears of its changes, and of nothing else.
 */

import { computed, effect, signal } from "@preact/signals-core";
import { type Extents, extentsTogether } from "../document/extents";
import { designOf } from "../document/gallery/exhibit";
import { FIRST } from "../document/gallery/first";
import { unitOf } from "../document/look";
import type { SolverClient } from "../solver/client";
import { readSettings } from "../state/storage";
import type { Change, State } from "../state/store";
import { Store } from "../state/store";
import { describe, describeBodies } from "../words/description";
import { page } from "../words/english/page";
import { Comparison } from "./comparison";
import { Contrast } from "./contrast";
import { Keeper, type Surroundings } from "./keeper";
import type { Made } from "./made";
import { Notices } from "./notices";
import { Opening } from "./opening";
import { Origin } from "./origin";
import { Pointed } from "./pointed";
import type { Pull } from "./pull";
import { Surface } from "./surface";
import { Witness } from "./witness";

export class Designer {
  readonly store: Store;
  readonly solver: SolverClient;
  readonly notices = new Notices();
  readonly pointed = new Pointed();
  readonly surface: Surface;
  readonly witness: Witness;
  readonly origin: Origin;
  readonly comparison: Comparison;
  readonly contrast = new Contrast();
  readonly keeper: Keeper;
  readonly opening: Opening;
  readonly #made = signal<Made | null>(null);
  readonly #extents = computed(() => this.#measureExtents());
  readonly #description = computed(() => {
    const [{ shown }, extents] = [this.surface, this.extents];
    if (!shown || !extents) return "";
    const [{ facts, parts }, unit] = [shown.solved, unitOf(shown.design)];
    return facts ? describe(facts, unit, extents) : describeBodies(parts.length, unit, extents);
  });
  readonly #pull = signal<Pull | null>(null);
  #fetching: Promise<Made | null> | null = null;

  constructor(solver: SolverClient, around: Surroundings) {
    this.solver = solver;
    this.store = new Store(designOf(FIRST, page.firstPot), readSettings(around.shelf));
    this.surface = new Surface(this.store, solver);
    this.witness = new Witness(this.store);
    this.origin = new Origin(this.store, this.surface);
    this.comparison = new Comparison(this.store, this.surface, solver);
    this.keeper = new Keeper(this.store, this.surface, this.origin, solver, this.notices, around);
    const maker = async () => (await this.openMade())?.maker ?? null;
    this.opening = new Opening(this.store, this.surface, this.origin, this.keeper, solver, maker);
  }

  /** Lets everything follow the document until what comes back is called; may be called again after that. */
  connect(): () => void {
    const leaving = [
      this.origin.connect(),
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

  /** How high and wide the pot on the stage is: with its wall where it has one, and as it was measured where that is known. */
  get extents(): Extents | null {
    return this.#extents.value;
  }

  /** The pot on the stage in words. */
  get description(): string {
    return this.#description.value;
  }

  apply(change: Change): void {
    if (change.design && change.convert) {
      this.origin.convert(change.design, change.convert);
      this.surface.reframe();
    }
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
        this.notices.say(page.unfetched);
        return null;
      },
    );
    return this.#fetching;
  }

  /** What pulls at the pot; null before it was wanted. */
  get pull(): Pull | null {
    return this.#pull.value;
  }

  /** The same, fetched now if it was not yet; null without a network. */
  async openPull(): Promise<Pull | null> {
    try {
      const { openPull } = await import("./open-pull");
      this.#pull.value ??= openPull(this.store);
    } catch {
      this.notices.say(page.unfetched);
    }
    return this.#pull.value;
  }

  #measureExtents(): Extents | null {
    const { shown } = this.surface;
    if (!shown) return null;
    const { facts, parts } = shown.solved;
    // Of what is no pot there are no facts, but how far it reaches.
    const extents = facts?.extents ?? extentsTogether(parts.map(({ farthest }) => farthest));
    return extents && (this.made?.extentsOf(shown.design, extents) ?? extents);
  }
}
