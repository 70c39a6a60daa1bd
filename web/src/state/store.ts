/** The one place that holds what the page knows: a frozen document with its history, beside a session that is not undone. */

import { batch, computed, type Signal, signal } from "@preact/signals-core";
import { frozen } from "../document/path";
import type { Design } from "../document/types";
import type { History } from "./history";
import { cancelMerge, canRedo, canUndo, EMPTY, endMerge, record, redo, undo } from "./history";
import type { Session } from "./session";

export interface State {
  readonly design: Design;
  readonly session: Session;
}

/**
 * What an action asks for. `step` is one undo step; `merge` joins the step before when that has the same `key` and no
 * gesture ended in between; `none` leaves the history alone.
 */
export interface Change {
  readonly design?: Design;
  readonly session?: Partial<Session>;
  readonly undo: "step" | "merge" | "none";
  readonly key?: string;
}

export class Store {
  readonly #design: Signal<Design>;
  readonly #session: Signal<Session>;
  readonly #history = signal(EMPTY);
  readonly #title = computed(() => this.#design.value.title ?? "");
  readonly #canUndo = computed(() => canUndo(this.#history.value));
  readonly #canRedo = computed(() => canRedo(this.#history.value));
  readonly #inGesture = computed(() => this.#history.value.merging !== null);
  #travelled = false;

  constructor(design: Design, session: Session) {
    this.#design = signal(frozen(design));
    this.#session = signal(frozen(session));
  }

  // Everything here is a signal behind its name: who reads it in an effect or in a component's template hears of its next change.

  get design(): Design {
    return this.#design.value;
  }

  get session(): Session {
    return this.#session.value;
  }

  get title(): string {
    return this.#title.value;
  }

  /** Both, as actions take them; who looks at one of them alone had better ask for that. */
  get state(): State {
    return { design: this.design, session: this.session };
  }

  get canUndo(): boolean {
    return this.#canUndo.value;
  }

  get canRedo(): boolean {
    return this.#canRedo.value;
  }

  /** Whether a gesture (a drag, a held key) is under way. */
  get inGesture(): boolean {
    return this.#inGesture.value;
  }

  /** Whether undo or redo led to this design. */
  get travelled(): boolean {
    return this.#travelled;
  }

  apply(change: Change): void {
    const before = this.#design.peek();
    const design = frozen(change.design ?? before);
    batch(() => {
      if (change.session) this.#session.value = frozen({ ...this.#session.peek(), ...change.session });
      if (design === before) return;
      this.#travelled = false;
      this.#history.value = record(this.#history.peek(), before, change);
      this.#design.value = design;
    });
  }

  /** Ends the gesture: the next change is a step of its own. Who follows {@link inGesture} can settle. */
  endGesture(): void {
    this.#history.value = endMerge(this.#history.peek());
  }

  /** The gesture was not meant (the page scrolled instead): nothing happened. */
  cancelGesture(): void {
    this.#travel(cancelMerge(this.#history.peek()));
  }

  undo(): void {
    this.#travel(undo(this.#history.peek(), this.#design.peek()), true);
  }

  redo(): void {
    this.#travel(redo(this.#history.peek(), this.#design.peek()), true);
  }

  #travel(trip: { readonly history: History; readonly design: Design } | null, travelled = false): void {
    if (trip === null) return;
    const session = this.#session.peek();
    const part = Math.min(session.part, trip.design.parts.length - 1);
    batch(() => {
      this.#travelled = travelled;
      this.#history.value = trip.history;
      this.#design.value = trip.design;
      if (part !== session.part) this.#session.value = frozen({ ...session, part });
    });
  }
}
