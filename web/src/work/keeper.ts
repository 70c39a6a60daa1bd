/** Keeps the work: in the address and in this browser with every change, and as a file or a link when a person asks for that. */

import { computed, effect, type Signal, signal, untracked } from "@preact/signals-core";
import type { Design } from "../document/types";
import { isolated } from "../language";
import type { SolverClient } from "../solver/client";
import type { Session } from "../state/session";
import type { KeptWork, Shelf, Work } from "../state/storage";
import { keepSettings, keepWork } from "../state/storage";
import type { Store } from "../state/store";
import { page } from "../words/english/page";
import { fileName } from "./files";
import { Memory } from "./memory";
import type { Notices } from "./notices";
import type { Origin } from "./origin";
import { type Claim, Seat } from "./seat";
import type { Shown, Surface } from "./surface";

/** What the page itself provides, so that tests can do without one. */
export interface Surroundings {
  readonly shelf: Shelf | null;
  /** What only this tab sees. */
  readonly tabShelf: Shelf | null;
  readonly claim: Claim;
  /** The address of the page, without what follows `#`. */
  readonly address: () => string;
  readonly fragment: () => string;
  /** Nothing is left of the one before where the link is empty. */
  readonly writeFragment: (link: string) => void;
  /** Runs something once the page has nothing else to do, or is about to be left. */
  readonly whenIdle: (run: () => void) => void;
  /** Hands a file to the person. */
  readonly download: (file: Blob, name: string) => void;
}

/** A longer link, and the document that it is of, take longer to be written than a movement of a hand may wait. */
const LONG = 1024;

export class Keeper {
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #origin: Origin;
  readonly #solver: SolverClient;
  readonly #notices: Notices;
  readonly #around: Surroundings;
  readonly #seat: Seat;
  readonly #memory: Memory;
  readonly #saved: Signal<Design>;
  readonly #unsaved = computed(() => this.#store.design !== this.#saved.value);
  /** Whether the address holds something that a person has still to decide about, or to read about. */
  #held: () => boolean = () => false;
  #keptSettings: Session;
  #kept: Shown | null = null;
  /** What was last to be written down. */
  #due: Shown | null = null;
  #warned = false;
  #toldTooLarge = false;
  #lastWritten = "";
  /** What follows the address, when whoever opens links last asked for it. */
  #read = "";

  constructor(
    store: Store,
    surface: Surface,
    origin: Origin,
    solver: SolverClient,
    notices: Notices,
    around: Surroundings,
  ) {
    this.#store = store;
    this.#surface = surface;
    this.#origin = origin;
    this.#solver = solver;
    this.#notices = notices;
    this.#around = around;
    this.#memory = new Memory(around.tabShelf, solver);
    this.#seat = new Seat(around.shelf, around.tabShelf, around.claim);
    this.#saved = signal(store.design);
    this.#keptSettings = store.session;
  }

  /** Whether there is work that is neither in a file nor in anybody's hands. */
  get unsaved(): boolean {
    return this.#unsaved.value;
  }

  /** What follows the address and its `#`, where that was not written here. */
  get foreignFragment(): string {
    const fragment = this.#around.fragment();
    this.#read = fragment;
    return fragment === this.#lastWritten ? "" : fragment;
  }

  /** Finds the work that this tab goes on with, and the place where it keeps its own. A new tab that was opened by a link leaves the works of others where they are. */
  async arrive(): Promise<Work | null> {
    return await this.#seat.take(this.foreignFragment !== "");
  }

  /** The works of closed tabs that are nowhere else; nobody else goes on with them from now on. */
  left(): Promise<readonly KeptWork[]> {
    return this.#seat.left();
  }

  /** Where this browser keeps things. */
  get shelf(): Shelf | null {
    return this.#around.shelf;
  }

  /** Brings back what could be undone and redone before a reload, where the design of this link was left. */
  async recall(link: string): Promise<void> {
    await this.#memory.recall(link, this.#store);
  }

  /** Leaves the address alone while this holds. */
  holdWhile(held: () => boolean): void {
    this.#held = held;
  }

  /** Follows the document and what is on the stage until what comes back is called. */
  connect(): () => void {
    const leaveSettings = effect(() => this.#keepSettings(this.#store.session));
    const leaveWork = effect(() => {
      const { shown } = this.#surface;
      if (shown && shown !== this.#kept) untracked(() => this.#follow(shown));
    });
    return () => {
      leaveSettings();
      leaveWork();
    };
  }

  /** This design is what was opened or saved. */
  markSaved(design: Design): void {
    this.#saved.value = design;
  }

  /** The link is in the person's hands, or the design on the shelf: nothing would be lost any more. */
  markShared(): void {
    this.markSaved(this.#store.design);
    this.#keep();
  }

  /** Saves the canonical document under the name of its title. */
  async save(): Promise<void> {
    const said = await this.#save();
    if (said !== null) this.#notices.say(said);
  }

  /** What became of that; null where something newer is being saved. */
  async #save(): Promise<string | null> {
    const { design } = this.#store;
    const outcome = await this.#solver.parse(JSON.stringify(design));
    if (outcome.state === "superseded") return null;
    if (outcome.state === "refused") return page.notSaved;
    // What is too large for a link is not made three times as large by lines of its own for every number.
    const text = `${JSON.stringify(outcome.value.design, null, outcome.value.link === "" ? 0 : 2)}\n`;
    const name = fileName(design.title, "json");
    this.#around.download(new Blob([text], { type: "application/json" }), name);
    this.markSaved(design);
    this.#keep();
    return page.savedAs(isolated(name));
  }

  /** Whether the design on the stage is so large that no link holds it: it is kept as a file. */
  get tooLargeForLink(): boolean {
    return this.#surface.settled?.solved.link === "";
  }

  /** Says that there is no link of so large a design, and offers the file. */
  sayTooLarge(): void {
    const act = async () => (await this.#save()) ?? page.notSaved;
    this.#notices.say(page.tooLargeForLink, { label: page.commands.save, saves: true, act });
  }

  /** The address that opens this very design; null while the design is not one that the solver accepts, or one that is too large for a link. */
  async address(): Promise<string | null> {
    if (this.tooLargeForLink) return null;
    const settled = this.#surface.settled?.solved.link;
    if (settled) return `${this.#around.address()}#${settled}`;
    const outcome = await this.#solver.parse(JSON.stringify(this.#store.design));
    const link = outcome.state === "done" ? outcome.value.link : "";
    return link === "" ? null : `${this.#around.address()}#${link}`;
  }

  /** Writes the link of what is on the stage into the address; of what has none, nothing. */
  writeAddress(shown = this.#surface.shown): void {
    const link = shown?.solved.link ?? "";
    if (link === "" && !this.tooLargeForLink) return;
    const there = this.#around.fragment();
    // A link that somebody has just put there: the page hears of it in a moment, and would find its own.
    if (there !== this.#lastWritten && there !== this.#read) return;
    this.#around.writeFragment(link);
    // What is there now: a browser may have refused it.
    this.#lastWritten = this.#around.fragment();
  }

  /** Does so unless the page was only opened, without a link, or the address is held. */
  renewAddress(shown = this.#surface.shown): void {
    const written = this.#store.canUndo || this.#store.canRedo || this.#around.fragment() !== "";
    if (written && !this.#held()) this.writeAddress(shown);
  }

  #keepSettings(session: Session): void {
    if (session === this.#keptSettings) return;
    this.#keptSettings = session;
    keepSettings(this.#around.shelf, session);
  }

  #follow(shown: Shown): void {
    this.#kept = shown;
    if (this.#surface.settled !== shown) return;
    this.#due = shown;
    const long = shown.solved.link === "" || shown.solved.link.length > LONG;
    for (const write of [() => this.#keep(shown), () => this.renewAddress(shown)]) {
      // Each by itself: in between a hand may move on.
      if (long) this.#around.whenIdle(() => this.#due === shown && write());
      else write();
    }
    if (!this.tooLargeForLink) this.#toldTooLarge = false;
    else if (!this.#toldTooLarge) {
      this.#toldTooLarge = true;
      this.sayTooLarge();
    }
  }

  /** Keeps the last design that the solver accepted, so that what is restored can always be shown. */
  #keep(shown = this.#surface.shown): void {
    if (!shown?.settled) return;
    const text = JSON.stringify(shown.design);
    const unsaved = shown.design !== this.#saved.peek();
    const origin = JSON.stringify(this.#origin.of(shown.design));
    if (shown.design === this.#store.design) this.#memory.keep(shown.solved.link, this.#store);
    const kept = keepWork(this.#around.shelf, this.#seat.name, { text, link: shown.solved.link, unsaved, origin });
    if (kept || !unsaved || this.#warned || this.tooLargeForLink) return;
    this.#warned = true;
    this.#notices.say(page.notKept);
  }
}
