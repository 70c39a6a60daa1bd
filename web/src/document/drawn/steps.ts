/** What was there before, to be gone back to: one step for whatever a hand did until it let go. */

const MOST = 100;

export class Steps<T> {
  readonly #past: T[] = [];
  #settled: T;

  constructor(first: T) {
    this.#settled = first;
  }

  get isFirst(): boolean {
    return this.#past.length === 0;
  }

  /** As it was when the hand last let go. */
  get settled(): T {
    return this.#settled;
  }

  /** The hand has let go: the next step begins here. */
  settle(now: T): void {
    if (now === this.#settled) return;
    this.#past.push(this.#settled);
    if (this.#past.length > MOST) this.#past.shift();
    this.#settled = now;
  }

  /** One step back; where there is none, what there is. */
  back(): T {
    this.#settled = this.#past.pop() ?? this.#settled;
    return this.#settled;
  }
}
