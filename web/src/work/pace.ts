/** Which grid the hand gets: as fine as frames stay quick. */

import { COARSEST } from "./grid";

/** Milliseconds from asking the solver to the end of the frame, without the waiting in between. */
const SLOW = 42;
const QUICK = 14;

/** How many changes in a row it takes to go one step down, and up. */
const PATIENCE_DOWN = 2;
const PATIENCE_UP = 12;
/** A finer grid that proved too slow is tried again later and later, up to this many quick changes. */
const MOST_PATIENCE = 400;

/** Where a first drag begins: in the middle, so that it neither stutters nor looks coarse anywhere. */
export const FIRST = 2;

/**
 * The fineness of the grid during gestures, learnt from what changes cost and kept from one gesture to the next. Pixels are
 * the cheaper thing to save, so the grid gets coarser only when the picture cannot.
 */
export class Pace {
  #step: number;
  #streak = 0;
  #patience = PATIENCE_UP;
  #risen = false;

  readonly #coarsest: number;

  /** Steps go from 0, the finest, to `coarsest`. */
  constructor(coarsest = COARSEST, first = FIRST) {
    this.#coarsest = coarsest;
    this.#step = first;
  }

  /** The step for {@link gridFor}. */
  get step(): number {
    return this.#step;
  }

  /** Learns what a change cost; `coarsest` says that the picture could not have been coarser. */
  learn(milliseconds: number, coarsest: boolean): void {
    if (milliseconds > SLOW && coarsest) this.#streak = Math.max(this.#streak, 0) + 1;
    else if (milliseconds < QUICK) this.#streak = Math.min(this.#streak, 0) - 1;
    else this.#streak = 0;
    if (this.#streak >= PATIENCE_DOWN) this.#coarser();
    else if (this.#streak <= -this.#patience) this.#finer();
  }

  #coarser(): void {
    if (this.#risen) this.#patience = Math.min(2 * this.#patience, MOST_PATIENCE);
    this.#risen = false;
    this.#step = Math.min(this.#step + 1, this.#coarsest);
    this.#streak = 0;
  }

  #finer(): void {
    this.#risen = this.#step > 0;
    this.#step = Math.max(this.#step - 1, 0);
    this.#streak = 0;
  }
}
