/**
 * A hand on the pot: what it took hold of, and the document following it. The maker that answers is one of its own, so that a pull waits for no wall; of many movements the latest wins, and all of
 * one grip are one step of undo.
 */

import { signal } from "@preact/signals-core";
import { type Brush, NEW_BRUSH } from "../document/brush";
import { keptBy, type Lock, makingUp } from "../document/locks";
import { setPath } from "../document/path";
import type { Design, Pair, Refusal, Shape } from "../document/types";
import type { MakerClient } from "../maker/client";
import type { Move, PulledShape } from "../maker/messages";
import type { PartId } from "../state/part-ids";
import type { Store } from "../state/store";

/** Where a hand took hold. */
export interface Grip {
  readonly part: PartId;
  readonly at: Pair;
  /** How far the point is from the middle of the foot: what the way that it stays behind is measured by. */
  readonly size: number;
}

/** What became of the last movement. */
export interface Followed {
  readonly refusal: Refusal | null;
  /** The point that followed; null before there is one. */
  readonly at: Pair | null;
  /** How far the point is from the hand, as a share of the size that was told. */
  readonly behind: number;
  /** Whether the pot holds something else now, though that was locked: nothing that is free could make up for it. */
  readonly spilt: boolean;
}

const FOLLOWED: Followed = { refusal: null, at: null, behind: 0, spilt: false };

const STILL: Move = { out: 0, up: 0, round: 0 };

interface Held extends Grip {
  readonly key: string;
  /** The shape as it was when the first movement was asked; null before that. */
  from: Shape | null;
  /** The document as the last movement left it: where another one stands there, somebody else changed it. */
  left: Design | null;
  over: boolean;
  /** How many movements have no answer yet, and who waits for the last of them. */
  under: number;
  readonly waiting: (() => void)[];
}

export class Pull {
  readonly #store: Store;
  readonly #maker: MakerClient;
  readonly #followed = signal(FOLLOWED);
  readonly #brush = signal<Brush>(NEW_BRUSH);
  readonly #locked = signal<readonly Lock[]>([]);
  readonly #grip = signal<Held | null>(null);
  /** Over when the grip before has brought home what it was asked for. */
  #before: Promise<void> = Promise.resolve();
  #grips = 0;

  constructor(store: Store, maker: MakerClient) {
    this.#store = store;
    this.#maker = maker;
  }

  /** How it pulls; kept while the page is open. */
  get brush(): Brush {
    return this.#brush.value;
  }

  set brush(brush: Brush) {
    this.#brush.value = brush;
  }

  /** What of a named family stays as it is; kept while the page is open. */
  get locked(): readonly Lock[] {
    return this.#locked.value;
  }

  set locked(locked: readonly Lock[]) {
    this.#locked.value = locked;
  }

  /** What became of the last movement. */
  get followed(): Followed {
    return this.#followed.value;
  }

  /** What is held, if anything. */
  get grip(): Grip | null {
    return this.#grip.value;
  }

  /** Over when what was asked by the last grip that was let go has arrived. */
  get settled(): Promise<void> {
    return this.#before;
  }

  /** Takes hold of a point. What was held before is let go. */
  take(grip: Grip): void {
    void this.release();
    this.#grips += 1;
    this.#followed.value = FOLLOWED;
    this.#grip.value = {
      ...grip,
      key: `pull:${this.#grips}`,
      from: null,
      left: null,
      over: false,
      under: 0,
      waiting: [],
    };
  }

  /** The hand has come so far from where it took hold. */
  move(by: Move, brush = this.brush): void {
    const held = this.#grip.peek();
    if (held) void this.#ask(held, by, brush, this.#locked.peek());
  }

  /** Puts a ring where the surface of a part is, which changes nothing until it is moved. */
  async putRing(part: PartId, u: number): Promise<void> {
    this.take({ part, at: [u, 0], size: 1 });
    const held = this.#grip.peek();
    if (held) void this.#ask(held, STILL, { ...NEW_BRUSH, spread: "all" }, []);
    await this.release();
  }

  /** Lets go: what was asked last still arrives, and the step is over then. */
  async release(): Promise<void> {
    const held = this.#grip.peek();
    if (!held) return;
    this.#grip.value = null;
    const over = rest(held).then(async () => {
      if (this.#locked.peek().includes("capacity")) await this.#hold(held);
      held.over = true;
      if (held.left !== null && held.left === this.#store.design) this.#store.endGesture();
    });
    this.#before = over;
    await over;
  }

  /** It was not meant: everything is as before the hand took hold. */
  cancel(): void {
    const held = this.#grip.peek();
    if (!held) return;
    this.#grip.value = null;
    held.over = true;
    this.#followed.value = FOLLOWED;
    if (held.left !== null && held.left === this.#store.design) this.#store.cancelGesture();
  }

  async #ask(held: Held, by: Move, brush: Brush, locked: readonly Lock[]): Promise<void> {
    held.under += 1;
    try {
      await this.#before;
      const from = this.#begin(held);
      if (!from) return;
      const keep = keptBy(from, locked, held.at[0]);
      const wall = this.#store.design.parts[this.#place(held)]?.wall;
      const hold = wall && locked.includes("capacity") ? { hold: { wall, locked } } : {};
      const outcome = await this.#maker.ask({ kind: "pull", shape: from, at: held.at, by, brush, keep, ...hold });
      if (outcome.state === "superseded") return;
      if (outcome.state === "refused") this.#followed.value = { ...FOLLOWED, refusal: outcome.refusal };
      else this.#follow(held, outcome.value);
    } finally {
      held.under -= 1;
      if (held.under === 0) for (const each of held.waiting.splice(0)) each();
    }
  }

  /** Once the hand has let go, the rest of the pot sees to it that it holds to the last digit what it held, which it did nearly before: that takes measuring, for which no hand waits. */
  async #hold(held: Held): Promise<void> {
    const { design } = this.#store;
    const place = this.#place(held);
    const part = design.parts[place];
    if (!held.from || held.left === null || held.left !== design || !part?.wall || part.shape.kind !== "rings") return;
    const alone = (shape: Shape): Design => ({
      pasu: 1,
      ...(design.unit && { unit: design.unit }),
      parts: [{ ...part, shape }],
    });
    const up = makingUp(part.shape, this.#locked.peek(), held.at[0]);
    const [before, after] = [alone(held.from), alone(part.shape)];
    const outcome = await this.#maker.ask({ kind: "hold", before, after, ...up });
    if (held.left !== this.#store.design) return;
    if (outcome.state === "refused") this.#followed.value = { ...FOLLOWED, refusal: outcome.refusal };
    else if (outcome.state === "done" && outcome.value === null) this.#followed.value = { ...FOLLOWED, spilt: true };
    else if (outcome.state === "done" && outcome.value) this.#put(held, place, outcome.value.shape);
  }

  /** The shape that the hand took hold of. */
  #begin(held: Held): Shape | null {
    held.from ??= this.#store.design.parts[this.#place(held)]?.shape ?? null;
    return held.over ? null : held.from;
  }

  #place({ part }: Grip): number {
    return this.#store.ids.indexOf(part);
  }

  #follow(held: Held, { shape, at, behind }: PulledShape): void {
    const { design } = this.#store;
    const place = this.#place(held);
    // Undone, or opened anew, under the hand: that is what counts.
    if (held.over || place < 0 || (held.left !== null && held.left !== design)) return;
    this.#followed.value = { ...FOLLOWED, at, behind: behind / held.size };
    this.#put(held, place, shape);
  }

  #put(held: Held, place: number, shape: Shape): void {
    const next = setPath(this.#store.design, ["parts", place, "shape"], shape);
    this.#store.apply({ design: next, undo: "merge", key: held.key });
    held.left = this.#store.design;
  }
}

function rest({ under, waiting }: Held): Promise<void> {
  return under === 0 ? Promise.resolve() : new Promise((resolve) => waiting.push(resolve));
}
