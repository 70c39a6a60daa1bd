/** The surface on the stage: asks the solver for the mesh of what the document says, as finely as the hand allows. */

import { batch, computed, effect, signal, untracked } from "@preact/signals-core";
import { unitOf } from "../document/look";
import type { Design, Part, Refusal } from "../document/types";
import type { GridSize } from "../document/waves";
import type { SolverClient } from "../solver/client";
import type { Desk } from "../solver/desk";
import type { Used } from "../solver/messages";
import { isLarge } from "../solver/moved";
import type { Solved } from "../solver/solved";
import type { Identified } from "../state/part-ids";
import type { Store } from "../state/store";
import { describeAccuracy } from "../words/description";
import type { Outcome } from "../worker/port";
import { gridFor } from "./grid";
import { FIRST, Pace } from "./pace";
import { trace } from "./trace";

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

export type Status = "starting" | "solving" | "ready" | "error";

/** What a surface is not to be shown without: its wall. */
export interface Companion {
  /** Whether the next surface has to wait for the pair that is under way; `run` is called after it. */
  waits(run: () => void): boolean;
  /** The solved surface once its companion is there too; null where it comes alone. */
  join(design: Design, solving: Promise<Outcome<Solved>>): Promise<Outcome<Solved>> | null;
}

/** What the stage needs now. */
interface Wanted extends Identified {
  /** Whether the gesture is over. */
  readonly settle: boolean;
  readonly lines: boolean;
  /** The part whose section is wanted. */
  readonly section: number | null;
}

export class Surface {
  /** How fine the grid is during a gesture. */
  readonly pace = new Pace();
  /** The grid of a design now; measurements put their own here. */
  grid = (design: Design): GridSize => gridFor(design, this.#store.inGesture ? this.#step(design) : 0);
  readonly #store: Store;
  readonly #desk: Desk;
  readonly #begun = signal(false);
  readonly #shown = signal<Shown | null>(null);
  readonly #status = signal<Status>("starting");
  readonly #problem = signal<Refusal | null>(null);
  readonly #wanted = computed(() => this.#want());
  readonly #accuracy = computed(() => {
    const shown = this.#shown.value;
    return shown && shown.solved.bound !== null ? describeAccuracy(shown.solved.bound, unitOf(shown.design)) : "";
  });
  #companion: Companion | null = null;
  /** What the solver was asked for last. */
  #asked: Wanted | null = null;
  #changes = 0;
  #framing = 0;
  #travelled = false;

  constructor(store: Store, solver: SolverClient) {
    this.#store = store;
    this.#desk = solver.desk();
  }

  get shown(): Shown | null {
    return this.#shown.value;
  }

  get status(): Status {
    return this.#status.value;
  }

  /** Why the design on the screen is not the one in the panel. */
  get problem(): Refusal | null {
    return this.#problem.value;
  }

  /** What is shown where that is what the document says, finely; null while it is not. */
  get settled(): Shown | null {
    const shown = this.#shown.value;
    return shown?.settled && shown.design === this.#store.design ? shown : null;
  }

  /** How true the picture is, in words; empty while it is not known. */
  get accuracy(): string {
    return this.#accuracy.value;
  }

  /** How coarse the grid is under the hand. Of a large network only what moves is sampled: it stays as fine as at rest, unless drawing it takes too long. */
  #step({ parts }: Design): number {
    const { step } = this.pace;
    return step <= FIRST && parts.every(({ shape }) => isLarge(shape)) ? 0 : step;
  }

  /** Follows the document until what comes back is called. */
  connect(): () => void {
    return effect(() => {
      const wanted = this.#wanted.value;
      if (wanted) untracked(() => this.#follow(wanted));
    });
  }

  /** The document holds what is to be shown: nothing is solved before that is decided. */
  begin(): void {
    this.#begun.value = true;
  }

  /** The next design is one that was just opened. */
  reframe(): void {
    this.#framing += 1;
  }

  /** Shows surfaces together with this from now on; alone at null. */
  accompany(companion: Companion | null): void {
    this.#companion = companion;
  }

  /** Takes back meshes that nobody shows any more; what is on the stage all the same stays there. */
  recycle(meshes: readonly Used[]): void {
    const shown = new Set<Used>(this.#shown.peek()?.solved.parts.map(({ mesh }) => mesh));
    for (const mesh of meshes) if (!shown.has(mesh)) this.#desk.recycle(mesh);
  }

  #want(): Wanted | null {
    if (!this.#begun.value) return null;
    const { design, ids, inGesture, part, session } = this.#store;
    const { overlays, tab } = session;
    return {
      design,
      ids,
      settle: !inGesture,
      lines: overlays.isoU || overlays.isoV || overlays.boundary,
      // Even while a gesture has no time for more.
      section: !inGesture || tab === "profile" ? part : null,
    };
  }

  #follow(wanted: Wanted): void {
    const asked = this.#asked;
    const enough =
      asked?.design === wanted.design &&
      asked.ids === wanted.ids &&
      asked.settle >= wanted.settle &&
      asked.lines >= wanted.lines &&
      (wanted.section === null || asked.section === wanted.section);
    if (enough || this.#companion?.waits(() => this.#again())) return;
    // Link and fingerprint take longer than parts that were only moved, and points of a large network: these are shown first.
    const { parts: before = [] } = this.#shown.peek()?.design ?? {};
    const { parts } = wanted.design;
    const quick = ({ shape }: Part, at: number) => isLarge(shape) || shape === before[at]?.shape;
    const another = ({ shape, place }: Part, at: number) => shape !== before[at]?.shape || place !== before[at]?.place;
    const settle = wanted.settle && !(parts.every(quick) && parts.some(another));
    this.#asked = { ...wanted, settle };
    this.#solve(this.#asked);
  }

  /** What had to wait may have become something else meanwhile. */
  #again(): void {
    const wanted = this.#wanted.peek();
    if (wanted) this.#follow(wanted);
  }

  #solve({ design, ids, settle, lines, section }: Wanted): void {
    this.#changes += 1;
    const change = this.#changes;
    const framing = this.#framing;
    this.#travelled ||= this.#store.travelled;
    const travelled = this.#travelled;
    if (this.#status.value !== "starting") this.#status.value = "solving";
    trace("asked", change);
    const solving = this.#desk.solve({ design, ids }, { ...this.grid(design), lines, section, settle });
    void (this.#companion?.join(design, solving) ?? solving).then((outcome) => {
      if (outcome.state === "superseded") return;
      // One that waited for its wall may come after one that did not.
      if (change < (this.#shown.peek()?.change ?? 0)) {
        if (outcome.state === "done") this.recycle(outcome.value.parts.map(({ mesh }) => mesh));
        return;
      }
      const current = design === this.#store.design;
      if (outcome.state === "done") trace("solved", change, outcome.value.times ?? undefined);
      batch(() => {
        if (outcome.state === "refused") {
          if (!current) return;
          this.#problem.value = outcome.refusal;
          this.#status.value = "error";
          return;
        }
        this.#shown.value = { design, solved: outcome.value, change, settled: settle, framing, travelled };
        if (!current) return;
        this.#travelled = false;
        this.#problem.value = null;
        if (settle) this.#status.value = "ready";
        else this.#again();
      });
    });
  }
}
