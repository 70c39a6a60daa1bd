/** The one place that holds what the page knows: a frozen document with its history, beside a session that is not undone. */

import { batch, computed, type Signal, signal } from "@preact/signals-core";
import { isAlike } from "../document/alike";
import { filled } from "../document/kinds";
import { frozen } from "../document/path";
import { UNMOVED } from "../document/placement";
import type { Design } from "../document/types";
import type { History, Left, Trip } from "./history";
import { cancelMerge, canRedo, canUndo, EMPTY, endMerge, recall, record, redo, undo } from "./history";
import { freshIds, type Identified, type PartId, placeOf } from "./part-ids";
import type { Session } from "./session";

export interface State extends Identified {
  readonly session: Session;
  /** The place of the part that panels are about. */
  readonly part: number;
  /** The least identity that no part ever had. */
  readonly fresh: PartId;
}

/**
 * What an action asks for. `step` is one undo step; `merge` joins the step before when that has the same `key` and no
 * gesture ended in between; `none` leaves the history alone.
 */
export interface Change {
  readonly design?: Design;
  /** Who the parts of the design are, where it has not the same ones in the same order. */
  readonly ids?: readonly PartId[];
  readonly session?: Partial<Session>;
  readonly undo: "step" | "merge" | "none";
  readonly key?: string;
  /** Where all numbers of the design are converted at once (to another unit or size): how what it was opened as is converted along. */
  readonly convert?: (design: Design) => Design;
}

export class Store {
  readonly #design: Signal<Design>;
  readonly #ids: Signal<readonly PartId[]>;
  readonly #session: Signal<Session>;
  readonly #history = signal(EMPTY);
  readonly #title = computed(() => this.#design.value.title ?? "");
  readonly #canUndo = computed(() => canUndo(this.#history.value));
  readonly #canRedo = computed(() => canRedo(this.#history.value));
  readonly #inGesture = computed(() => this.#history.value.merging !== null);
  readonly #part = computed(() => placeOf(this.#session.value.selection, this.#ids.value));
  #fresh: PartId = 0;
  #travelled = false;

  constructor(design: Design, session: Session) {
    this.#design = signal(frozen(design));
    this.#ids = signal(this.#newIds(design.parts.length));
    this.#session = signal(frozen(session));
  }

  // Everything here is a signal behind its name: who reads it in an effect or in a component's template hears of its next change.

  get design(): Design {
    return this.#design.value;
  }

  /** Who the parts are, in the order of the design. */
  get ids(): readonly PartId[] {
    return this.#ids.value;
  }

  /** The place of the part that panels are about. */
  get part(): number {
    return this.#part.value;
  }

  get session(): Session {
    return this.#session.value;
  }

  get title(): string {
    return this.#title.value;
  }

  /** Everything, as actions take it; who looks at some of it alone had better ask for that. */
  get state(): State {
    const { design, ids, part, session } = this;
    return { design, ids, part, session, fresh: this.#fresh };
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
    const before = this.#left;
    const design = frozen(change.design ?? before.design);
    batch(() => {
      if (change.session) this.#session.value = frozen({ ...this.#session.peek(), ...change.session });
      if (design === before.design) return;
      this.#travelled = false;
      this.#history.value = record(this.#history.peek(), before, change);
      this.#design.value = design;
      this.#ids.value = this.#idsOf(design, change.ids);
    });
  }

  /** Ends the gesture: the next change is a step of its own. Who follows {@link inGesture} can settle. */
  endGesture(): void {
    // What ended where it began is no step, though what may be left out be written out now: undo would do nothing.
    const before = this.inGesture && this.#history.peek().past.at(-1);
    if (before && isAlike(meant(before.design), meant(this.#design.peek()))) this.cancelGesture();
    this.#history.value = endMerge(this.#history.peek());
  }

  /** The gesture was not meant (the page scrolled instead): nothing happened. */
  cancelGesture(): void {
    this.#travel(cancelMerge(this.#history.peek()));
  }

  /** What could be undone and redone. */
  get history(): Pick<History, "past" | "future"> {
    return this.#history.value;
  }

  /**
   * Steps of before a reload, whose identities were given then. `now` are those that the parts of the design at `ids` had: they are the same parts still, and
   * all others are parts that this page does not know.
   */
  recall(steps: Pick<History, "past" | "future">, now: readonly PartId[], ids: readonly PartId[]): void {
    const known = new Map(now.map((id, place) => [id, ids[place] ?? id]));
    const translated = ({ design, ids: before }: Identified): Identified => ({
      design: frozen(design),
      ids: before.map((id) => {
        const same = known.get(id) ?? this.#newIds(1)[0] ?? 0;
        known.set(id, same);
        return same;
      }),
    });
    const [past, future] = [steps.past.map(translated), steps.future.map(translated)];
    this.#history.value = recall(this.#history.peek(), { past, future });
  }

  undo(): void {
    this.#travel(undo(this.#history.peek(), this.#left), true);
  }

  redo(): void {
    this.#travel(redo(this.#history.peek(), this.#left), true);
  }

  get #left(): Left {
    return { design: this.#design.peek(), ids: this.#ids.peek(), selection: this.#session.peek().selection };
  }

  /** Those that the change tells, or the same as before; a design of other parts of which nothing is told has new ones. */
  #idsOf(design: Design, told: readonly PartId[] | undefined): readonly PartId[] {
    const ids = told ?? this.#ids.peek();
    if (ids.length !== design.parts.length) return this.#newIds(design.parts.length);
    this.#fresh = Math.max(this.#fresh, ...ids.map((id) => id + 1));
    return ids;
  }

  #newIds(count: number): readonly PartId[] {
    const ids = freshIds(count, this.#fresh);
    this.#fresh += count;
    return ids;
  }

  #travel(trip: Trip | null, travelled = false): void {
    if (trip === null) return;
    const { design, ids, selection } = trip.now;
    const before = this.#ids.peek();
    batch(() => {
      this.#travelled = travelled;
      this.#history.value = trip.history;
      this.#design.value = design;
      this.#ids.value = ids;
      // Where parts come or go, so does what was selected with them; what is only changed back leaves the hand where it is.
      if (selection && (ids.length !== before.length || ids.some((id) => !before.includes(id))))
        this.#session.value = frozen({ ...this.#session.peek(), selection });
    });
  }
}

/** The design with all that its shapes and placements may leave out. */
function meant(design: Design): unknown {
  const parts = design.parts.map((part) => ({
    ...part,
    shape: filled(part.shape),
    place: { ...UNMOVED, ...part.place },
  }));
  return { ...design, parts };
}
