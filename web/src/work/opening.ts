/** Opens designs: from the address, from what this browser kept, from files and texts, and asks before work is lost. */

import { batch, effect, signal, untracked } from "@preact/signals-core";
import type { Design, Making, Refusal } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { SolverClient } from "../solver/client";
import type { Parsed } from "../solver/messages";
import { openDesign } from "../state/actions";
import type { Store } from "../state/store";
import type { Keeper } from "./keeper";
import type { Found } from "./open-file";
import type { Origin } from "./origin";
import type { Surface } from "./surface";

/** A link that waits for the person's decision because there is unsaved work. */
export interface Conflict {
  readonly theirs: Parsed;
}

/** A file that is being opened. */
export interface Underway {
  readonly name: string;
  /** How long it is. */
  readonly bytes: number;
  /** Its design, once that is read and waits to be drawn. */
  readonly design: Design | null;
}

export class Opening {
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #origin: Origin;
  readonly #keeper: Keeper;
  readonly #solver: SolverClient;
  readonly #maker: () => Promise<MakerClient | null>;
  readonly #problem = signal<Refusal | null>(null);
  readonly #conflict = signal<Conflict | null>(null);
  readonly #underway = signal<Underway | null>(null);
  /** How the opened file was made, and which design it took the place of. */
  readonly #opened = signal<{ readonly making: Making | null; readonly replaced: Design | null }>({
    making: null,
    replaced: null,
  });
  /** Ends what is read of the file under way. */
  #reading = new AbortController();
  #begun = false;
  /** The design that was followed last. */
  #last: Design;

  /** `maker` reads files that are no documents; null where it cannot be fetched. */
  constructor(
    store: Store,
    surface: Surface,
    origin: Origin,
    keeper: Keeper,
    solver: SolverClient,
    maker: () => Promise<MakerClient | null>,
  ) {
    this.#store = store;
    this.#surface = surface;
    this.#origin = origin;
    this.#keeper = keeper;
    this.#solver = solver;
    this.#maker = maker;
    this.#last = store.design;
    // The address holds what is asked about, and what is read about.
    keeper.holdWhile(() => this.#conflict.peek() !== null || this.#problem.peek() !== null);
  }

  /** Why a link or a file was not opened. */
  get problem(): Refusal | null {
    return this.#problem.value;
  }

  /** The file that is being opened: from when it is given until it is on the stage, or why it is not. */
  get underway(): Underway | null {
    return this.#underway.value;
  }

  /** Opens it no further: what was there before is there. */
  stop(): void {
    const underway = this.#underway.peek();
    if (!underway) return;
    this.#underway.value = null;
    this.#reading.abort();
    this.#solver.halt();
    if (underway.design && underway.design === this.#store.design) this.#store.undo();
  }

  get conflict(): Conflict | null {
    return this.#conflict.value;
  }

  /** How the file was made that this design was opened from; null for any other, and for the design before it, to which undo leads. */
  get making(): Making | null {
    const { making, replaced } = this.#opened.value;
    return this.#store.design === replaced ? null : making;
  }

  /** Follows the document until what comes back is called: who goes on working has read why a link or file was not opened, and the address may be written again. */
  connect(): () => void {
    const leaving = [
      effect(() => {
        const { design } = this.#store;
        const changed = design !== this.#last;
        this.#last = design;
        if (changed && untracked(() => this.#surface.shown) !== null) this.#problem.value = null;
      }),
      effect(() => {
        const read = this.#underway.value?.design;
        if (!read) return;
        const { shown, problem } = this.#surface;
        if (shown?.design === read || problem || this.#store.design !== read) this.#underway.value = null;
      }),
    ];
    return () => {
      for (const leave of leaving) leave();
    };
  }

  /** Opens what the address asks for, or the work that this browser kept, or leaves what is there. */
  async start(): Promise<void> {
    this.#solver.warm();
    const { foreignFragment: fragment } = this.#keeper;
    const arriving = this.#keeper.arrive();
    const linked = fragment === "" ? null : await this.#solver.parse(fragment);
    const work = await arriving;
    if (linked?.state === "refused") this.#problem.value = linked.refusal;
    const theirs = linked?.state === "done" ? linked.value : null;
    const differs = theirs && theirs.link !== work?.link;
    // A link has the parts in an order of its own: of one design the work goes on, in which they stand as a person put them.
    const mine = work && (work.unsaved || !differs) ? await this.#solver.parse(work.text) : null;
    if (mine?.state === "done") {
      await this.#begin(mine.value.design, !work?.unsaved, work?.origin);
      if (differs) this.#conflict.value = { theirs };
      await this.#keeper.recall(mine.value.link);
    } else {
      await this.#begin(theirs?.design ?? this.#store.design, true);
      if (theirs) await this.#keeper.recall(theirs.link);
    }
  }

  /** `origin` is the document that the design was opened as in an earlier visit. */
  async #begin(design: Design, saved: boolean, origin?: string): Promise<void> {
    const opened = origin === undefined ? null : await this.#solver.parse(origin);
    this.#origin.open(design, opened?.state === "done" ? opened.value.design : design);
    this.#begun = true;
    batch(() => {
      if (saved) this.#keeper.markSaved(design);
      this.#store.apply({ design, undo: "none" });
      this.#surface.begin();
    });
  }

  /** The address changed under the page: someone pasted a link, or went back. */
  async addressChanged(): Promise<void> {
    const fragment = this.#keeper.foreignFragment;
    if (!this.#begun) return;
    if (fragment !== "") await this.#openText(fragment, true);
    // Back to an address without a link: it says what is on the stage.
    else this.#keeper.renewAddress();
  }

  /** Opens JSON text or a link. */
  async openText(text: string): Promise<void> {
    await this.#openText(text, false);
  }

  /** Opens a document, or anything that Pasu made and that holds its link: what was found, or false where that was stopped, or another file was given. */
  async openFile(file: File): Promise<Found | false> {
    const { underway, stopped } = this.#take(file);
    const found = await import("./open-file").then(
      ({ readFile }) => readFile(file, { solver: this.#solver, maker: this.#maker }),
      () => null,
    );
    if (stopped.aborted) return false;
    if (found && "refusal" in found) this.#problem.value = found.refusal;
    else if (found) await this.#openText(found.text, false, found.made, underway);
    if (this.#underway.peek() === underway) this.#underway.value = null;
    return !stopped.aborted && found;
  }

  /** Opens the design that something else reads of a file, unless that finds none; whether it did. It is told when it is stopped, or another file is given. */
  async openRead(file: File, read: (stopped: AbortSignal) => Promise<Design | null>): Promise<boolean> {
    const { underway, stopped } = this.#take(file);
    const design = await read(stopped).catch(() => null);
    if (this.#underway.peek() !== underway) return false;
    if (design) this.open(design);
    this.#underway.value = design ? { ...underway, design: this.#store.design } : null;
    return design !== null;
  }

  /** A file is under way from now on, and none that was before. */
  #take({ name, size }: File): { readonly underway: Underway; readonly stopped: AbortSignal } {
    this.#reading.abort();
    this.#reading = new AbortController();
    const underway: Underway = { name, bytes: size, design: null };
    this.#underway.value = underway;
    return { underway, stopped: this.#reading.signal };
  }

  async #openText(
    text: string,
    asLink: boolean,
    making: Making | null = null,
    underway: Underway | null = null,
  ): Promise<void> {
    const outcome = await this.#solver.parse(text);
    if (outcome.state === "superseded" || (underway && this.#underway.peek() !== underway)) return;
    if (outcome.state === "refused") {
      this.#problem.value = outcome.refusal;
      return;
    }
    const theirs = outcome.value;
    if (asLink && this.#surface.shown?.solved.link === theirs.link) return;
    if (asLink && this.#keeper.unsaved) this.#conflict.value = { theirs };
    else {
      this.open(theirs.design, making);
      if (underway) this.#underway.value = { ...underway, design: this.#store.design };
    }
  }

  /** Replaces the design; undo brings the old one back. */
  open(design: Design, making: Making | null = null): void {
    batch(() => {
      const before = this.#store.design;
      this.#problem.value = null;
      this.#surface.reframe();
      this.#origin.open(design);
      this.#store.apply(openDesign(this.#store.state, design));
      this.#opened.value = { making, replaced: this.#store.design === before ? null : before };
      this.#keeper.markSaved(this.#store.design);
    });
  }

  settleConflict(take: "theirs" | "mine"): void {
    const conflict = this.#conflict.peek();
    this.#conflict.value = null;
    if (conflict && take === "theirs") this.open(conflict.theirs.design);
    else this.#keeper.writeAddress();
  }

  /** It was read: the address is again that of the pot on the stage, and not one that opens nothing. */
  dismissProblem(): void {
    this.#problem.value = null;
    this.#keeper.renewAddress();
  }
}
