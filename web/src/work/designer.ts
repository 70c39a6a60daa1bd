/**
 * The designer behind the page: the store, the solver that follows it, the address, the browser's storage and the
 * files. Components read from it and are told when anything changed.
 */

import { describe, describeAccuracy } from "../document/describe";
import { designOf } from "../document/gallery/exhibit";
import { FIRST } from "../document/gallery/first";
import { looksOf, unitOf } from "../document/look";
import { convertible } from "../document/orders";
import { setPath } from "../document/path";
import type { Design, Look, Making, OrderKind, Refusal } from "../document/types";
import type { GridSize } from "../document/waves";
import type { SolverClient } from "../solver/client";
import type { MeshArrays, Parsed, Solved } from "../solver/messages";
import * as actions from "../state/actions";
import type { Shelf } from "../state/storage";
import { keepSettings, keepWork, readSettings, readWork } from "../state/storage";
import type { Change, State } from "../state/store";
import { Store } from "../state/store";
import { fileName, saveBlob } from "./files";
import { gridFor } from "./grid";
import { Pace } from "./pace";
import { trace } from "./trace";
import type { Workshop } from "./workshop";

/** What is on the stage: the last design that the solver accepted. */
export interface Shown {
  readonly design: Design;
  readonly solved: Solved;
  /** The number of the change that led here, counted from 1. */
  readonly change: number;
  /** Whether this is the fine mesh of a finished gesture. */
  readonly settled: boolean;
  /** Which opened design this is: the camera goes to each once, edits never move it. */
  readonly framing: number;
  /** Whether undo or redo led here. */
  readonly travelled: boolean;
}

/** The same design in another order, shown beside it. */
export interface Comparison {
  readonly order: OrderKind;
  readonly design: Design;
  readonly mesh: MeshArrays;
  readonly looks: readonly Required<Look>[];
}

/** A link that waits for the person's decision because there is unsaved work. */
export interface Conflict {
  readonly theirs: Parsed;
}

export interface Notice {
  readonly text: string;
  readonly id: number;
}

/** What a part of the page that is loaded late says when it cannot be. */
export const UNFETCHED = "This part of the page could not be fetched. Try again when there is a network.";

export type Status = "starting" | "solving" | "ready" | "error";

/** What the page itself provides, so that tests can do without one. */
export interface Surroundings {
  readonly shelf: Shelf | null;
  readonly address: () => string;
  readonly fragment: () => string;
  readonly writeFragment: (link: string) => void;
}

export class Designer {
  readonly store: Store;
  readonly solver: SolverClient;
  /** How fine the grid is during a gesture. */
  readonly pace = new Pace();
  /** The grid of a design now; measurements put their own here. */
  grid = (design: Design): GridSize => gridFor(design, this.store.inGesture ? this.pace.step : 0);
  readonly #around: Surroundings;
  readonly #listeners = new Set<() => void>();
  #told = false;
  #framing = 0;
  #changes = 0;
  #travelled = false;
  #warned = false;
  #saved: Design;
  #made: Making | null = null;
  #replaced: Design | null = null;
  #started = false;
  #noticeId = 0;
  #lastWritten = "";

  shown: Shown | null = null;
  status: Status = "starting";
  /** Why the design on the screen is not the one in the panel. */
  problem: Refusal | null = null;
  /** Why a link or a file was not opened. */
  openProblem: Refusal | null = null;
  comparison: Comparison | null = null;
  comparisonProblem: Refusal | null = null;
  conflict: Conflict | null = null;
  notice: Notice | null = null;
  newVersion = false;
  /** What is made of the design; null before anything of it was wanted. */
  workshop: Workshop | null = null;
  #workshop: Promise<Workshop | null> | null = null;

  constructor(solver: SolverClient, around: Surroundings) {
    const design = designOf(FIRST);
    this.solver = solver;
    this.#around = around;
    this.store = new Store(design, readSettings(around.shelf));
    this.#saved = this.store.state.design;
    this.store.subscribe((state, before) => this.#follow(state, before));
  }

  get state(): State {
    return this.store.state;
  }

  /** How the file was made that this design was opened from; null for any other, and for the design before it, to which undo leads. */
  get made(): Making | null {
    return this.state.design === this.#replaced ? null : this.#made;
  }

  get unsaved(): boolean {
    return this.state.design !== this.#saved;
  }

  /** The shape on the stage in words. */
  get description(): string {
    const facts = this.shown?.solved.facts;
    return this.shown && facts ? describe(facts, unitOf(this.shown.design)) : "";
  }

  /** How true the picture is, in words; empty while it is not known. */
  get accuracy(): string {
    const bound = this.shown?.solved.bound ?? null;
    return this.shown && bound !== null ? describeAccuracy(bound, unitOf(this.shown.design)) : "";
  }

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  apply(change: Change): void {
    this.store.apply(change);
  }

  undo(): void {
    this.#travelled = true;
    this.store.undo();
  }

  redo(): void {
    this.#travelled = true;
    this.store.redo();
  }

  /** Opens what the address asks for, or the work that this browser kept, or the first pot of the gallery. */
  async start(): Promise<void> {
    this.solver.warm();
    const work = readWork(this.#around.shelf);
    const fragment = this.#around.fragment();
    const linked = fragment === "" ? null : await this.solver.parse(fragment);
    if (linked?.state === "refused") this.openProblem = linked.refusal;
    const theirs = linked?.state === "done" ? linked.value : null;
    if (theirs && (!work?.unsaved || work.link === theirs.link)) {
      this.#begin(theirs.design, !(work?.unsaved ?? false));
      return;
    }
    const mine = work ? await this.solver.parse(work.text) : null;
    if (mine?.state === "done") {
      this.#begin(mine.value.design, !work?.unsaved);
      if (theirs) this.#ask({ theirs });
    } else {
      this.#begin(theirs?.design ?? this.state.design, true);
    }
  }

  #begin(design: Design, saved: boolean): void {
    this.#started = true;
    if (design === this.state.design) {
      this.#solve();
      return;
    }
    if (saved) this.#saved = design;
    this.apply({ design, undo: "none" });
  }

  /** The address changed under the page: someone pasted a link, or went back. */
  async addressChanged(): Promise<void> {
    const fragment = this.#around.fragment();
    if (!this.#started || fragment === "" || fragment === this.#lastWritten) return;
    await this.#openText(fragment, true);
  }

  /** Opens JSON text or a link. */
  async openText(text: string): Promise<void> {
    await this.#openText(text, false);
  }

  /** Opens a document, or anything that Pasu made and that holds its link. */
  async openFile(file: File): Promise<void> {
    const found = await import("./open-file").then(
      ({ readFile }) => readFile(file, () => this.openWorkshop()),
      () => null,
    );
    if (!found) return;
    if ("text" in found) return await this.#openText(found.text, false, found.made);
    this.openProblem = found.refusal;
    this.#tell();
  }

  /** What makes things of the design, fetched now if it was not yet; null without a network. */
  openWorkshop(): Promise<Workshop | null> {
    this.#workshop ??= import("./open-workshop").then(
      ({ openWorkshop }) => {
        this.workshop = openWorkshop(this);
        this.#tell();
        return this.workshop;
      },
      () => {
        this.#workshop = null;
        this.say(UNFETCHED);
        return null;
      },
    );
    return this.#workshop;
  }

  /** Something that is shown changed beside the design. */
  touched(): void {
    this.#tell();
  }

  async #openText(text: string, asLink: boolean, made: Making | null = null): Promise<void> {
    const outcome = await this.solver.parse(text);
    if (outcome.state === "superseded") return;
    if (outcome.state === "refused") {
      this.openProblem = outcome.refusal;
      this.#tell();
      return;
    }
    const theirs = outcome.value;
    if (asLink && this.shown?.solved.link === theirs.link) return;
    if (asLink && this.unsaved) this.#ask({ theirs });
    else this.open(theirs.design, made);
  }

  /** Replaces the design; undo brings the old one back. */
  open(design: Design, made: Making | null = null): void {
    const before = this.state.design;
    this.openProblem = null;
    this.#framing += 1;
    this.apply(actions.openDesign(this.state, design));
    this.#made = made;
    this.#replaced = this.state.design === before ? null : before;
    this.#saved = this.state.design;
    this.#tell();
  }

  #ask(conflict: Conflict): void {
    this.conflict = conflict;
    this.#tell();
  }

  settleConflict(take: "theirs" | "mine"): void {
    const conflict = this.conflict;
    this.conflict = null;
    if (conflict && take === "theirs") this.open(conflict.theirs.design);
    else if (this.shown?.solved.link) this.#writeAddress(this.shown.solved.link);
    this.#tell();
  }

  /** Saves the canonical document under the name of its title. */
  async save(): Promise<void> {
    const design = this.state.design;
    const outcome = await this.solver.parse(JSON.stringify(design));
    if (outcome.state === "refused") {
      this.problem = outcome.refusal;
      this.say("Not saved: the design has a value that the solver cannot use.");
      return;
    }
    if (outcome.state === "superseded") return;
    const text = `${JSON.stringify(outcome.value.design, null, 2)}\n`;
    const name = fileName(design.title, "json");
    saveBlob(new Blob([text], { type: "application/json" }), name);
    this.#saved = design;
    this.say(`Saved as “${name}”.`);
    this.#keep();
  }

  /** The address that opens this very design; null while the design is not one that the solver accepts. */
  async address(): Promise<string | null> {
    const design = this.state.design;
    const settled = this.shown?.settled && this.shown.design === design ? this.shown.solved.link : null;
    if (settled !== null && settled !== "") return `${this.#around.address()}#${settled}`;
    const outcome = await this.solver.parse(JSON.stringify(design));
    return outcome.state === "done" ? `${this.#around.address()}#${outcome.value.link}` : null;
  }

  /** The link is in the person's hands: nothing would be lost any more. */
  markShared(): void {
    this.#saved = this.state.design;
    this.#keep();
    this.#tell();
  }

  say(text: string): void {
    this.#noticeId += 1;
    this.notice = { text, id: this.#noticeId };
    this.#tell();
  }

  dismissNotice(id: number): void {
    if (this.notice?.id !== id) return;
    this.notice = null;
    this.#tell();
  }

  dismissOpenProblem(): void {
    this.openProblem = null;
    this.#tell();
  }

  announceNewVersion(): void {
    this.newVersion = true;
    this.#tell();
  }

  #follow(state: State, before: State): void {
    const { design, session } = state;
    const redesigned = design !== before.design;
    // Who goes on working has read why a link or file was not opened; the address may be written again.
    if (redesigned && this.shown !== null) this.openProblem = null;
    const gestureEnded = !this.store.inGesture && !(this.shown?.settled && this.shown.design === design);
    const solved = this.shown?.solved;
    const missing = solved !== undefined && this.#wants().some((name) => solved[name] === null);
    const otherPart = session.part !== before.session.part;
    if (this.#started && (redesigned || gestureEnded || missing || otherPart)) this.#solve();
    if (session !== before.session) keepSettings(this.#around.shelf, state);
    if (session.compare !== before.session.compare || redesigned) void this.#compare();
    this.#tell();
  }

  /** What is computed besides the mesh, even while a gesture has no time for more. */
  #wants(): readonly ("lines" | "section")[] {
    const { overlays, tab } = this.state.session;
    const lines = overlays.isoU || overlays.isoV || overlays.boundary;
    return [...(lines ? (["lines"] as const) : []), ...(tab === "profile" ? (["section"] as const) : [])];
  }

  #solve(): void {
    if (this.workshop?.inStep.waits(() => this.#solve())) return;
    const { design, session } = this.state;
    const inGesture = this.store.inGesture;
    const wants = this.#wants();
    this.#changes += 1;
    const change = this.#changes;
    this.status = this.status === "starting" ? "starting" : "solving";
    const options = {
      ...this.grid(design),
      lines: wants.includes("lines"),
      section: !inGesture || wants.includes("section") ? session.part : null,
      settle: !inGesture,
    };
    trace("asked", change);
    const framing = this.#framing;
    const travelled = this.#travelled;
    const solving = this.solver.solve(design, options);
    void (this.workshop?.inStep.join(design, solving) ?? solving).then((outcome) => {
      if (outcome.state === "superseded") return;
      const current = design === this.state.design;
      if (outcome.state === "refused") {
        if (!current) return;
        this.problem = outcome.refusal;
        this.status = "error";
        this.#tell();
        return;
      }
      trace("solved", change, outcome.value.times);
      this.shown = { design, solved: outcome.value, change, settled: options.settle, framing, travelled };
      if (current) {
        this.#travelled = false;
        this.problem = null;
        if (options.settle) {
          this.status = "ready";
          this.#keep();
          if (this.store.canUndo || this.store.canRedo || this.#around.fragment() !== "") {
            if (!this.conflict && !this.openProblem) this.#writeAddress(outcome.value.link);
          }
        }
      }
      this.#tell();
    });
  }

  async #compare(): Promise<void> {
    const { design, session } = this.state;
    const order = session.compare;
    const part = design.parts[session.part];
    if (!order || !part || !convertible(part.shape.kind)) {
      this.comparison = null;
      this.comparisonProblem = null;
      this.#tell();
      return;
    }
    const made = await this.solver.convert("compare", part.shape, order);
    if (this.state.session.compare !== order || this.state.design !== design || made.state === "superseded") return;
    if (made.state === "refused") {
      this.comparisonProblem = made.refusal;
      this.#tell();
      return;
    }
    const other = setPath(design, ["parts", session.part, "shape"], made.value.shape);
    const { rows, columns } = this.grid(other);
    const outcome = await this.solver.mesh("compare", other, rows, columns);
    if (outcome.state === "superseded" || this.state.session.compare !== order) return;
    this.comparisonProblem = outcome.state === "refused" ? outcome.refusal : null;
    if (outcome.state === "done") {
      this.comparison = { order, design: other, mesh: outcome.value, looks: looksOf(other) };
    }
    this.#tell();
  }

  #writeAddress(link: string): void {
    if (link === "") return;
    this.#lastWritten = `#${link}`;
    this.#around.writeFragment(link);
  }

  /** Keeps the last design that the solver accepted, so that what is restored can always be shown. */
  #keep(): void {
    const shown = this.shown;
    if (!shown?.settled) return;
    const text = JSON.stringify(shown.design);
    const unsaved = shown.design !== this.#saved;
    const kept = keepWork(this.#around.shelf, { text, link: shown.solved.link, unsaved });
    if (kept || !unsaved || this.#warned) return;
    this.#warned = true;
    this.say("This browser keeps no copy of your work. Save it, or copy its link, before you leave.");
  }

  /** Tells the components once, however many things changed in this turn. */
  #tell(): void {
    if (this.#told) return;
    this.#told = true;
    queueMicrotask(() => {
      this.#told = false;
      for (const listener of [...this.#listeners]) listener();
    });
  }
}
