/** The one place that holds what the page knows: a frozen document with its history, beside a session that is not undone. */

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
  /** Where all numbers of the design are converted at once (to another unit or size): how what it was opened as is converted along. */
  readonly convert?: (design: Design) => Design;
}

export type Listener = (state: State, before: State) => void;

export class Store {
  #state: State;
  #history: History = EMPTY;
  readonly #listeners = new Set<Listener>();

  constructor(design: Design, session: Session) {
    this.#state = { design: frozen(design), session: frozen(session) };
  }

  get state(): State {
    return this.#state;
  }

  get canUndo(): boolean {
    return canUndo(this.#history);
  }

  get canRedo(): boolean {
    return canRedo(this.#history);
  }

  /** Whether a gesture (a drag, a held key) is under way. */
  get inGesture(): boolean {
    return this.#history.merging !== null;
  }

  apply(change: Change): void {
    const before = this.#state;
    const design = frozen(change.design ?? before.design);
    const session = change.session ? frozen({ ...before.session, ...change.session }) : before.session;
    if (design === before.design && session === before.session) return;
    if (design !== before.design) this.#history = record(this.#history, before.design, change);
    this.#set({ design, session });
  }

  /** Ends the gesture: the next change is a step of its own. Listeners hear of it so that they can settle. */
  endGesture(): void {
    if (!this.inGesture) return;
    this.#history = endMerge(this.#history);
    this.#tell(this.#state);
  }

  /** The gesture was not meant (the page scrolled instead): nothing happened. */
  cancelGesture(): void {
    this.#travel(cancelMerge(this.#history));
  }

  undo(): void {
    this.#travel(undo(this.#history, this.#state.design));
  }

  redo(): void {
    this.#travel(redo(this.#history, this.#state.design));
  }

  subscribe(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #travel(trip: { readonly history: History; readonly design: Design } | null): void {
    if (trip === null) return;
    this.#history = trip.history;
    const parts = trip.design.parts.length;
    const session = this.#state.session;
    const part = Math.min(session.part, parts - 1);
    this.#set({ design: trip.design, session: part === session.part ? session : frozen({ ...session, part }) });
  }

  #set(state: State): void {
    const before = this.#state;
    this.#state = state;
    this.#tell(before);
  }

  #tell(before: State): void {
    for (const listener of [...this.#listeners]) listener(this.#state, before);
  }
}
