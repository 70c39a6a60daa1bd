/** After the last movement a fine frame is drawn, this many milliseconds later. */
const DELAY = 120;

/** When all is quiet. A hand that moves slowly is not held up by fine frames that take long: each waits as long as the last one took. */
export class Rest {
  private held = false;
  private fine = 0;

  /** For how many milliseconds nothing has to have changed. */
  get delay(): number {
    return this.held ? Math.max(DELAY, this.fine) : DELAY;
  }

  /** Whether a hand changes what is on the stage; true where that is another answer than before. */
  hold(held: boolean): boolean {
    const other = held !== this.held;
    this.held = held;
    return other;
  }

  /** A fine frame took so many milliseconds. */
  took(milliseconds: number): void {
    this.fine = milliseconds;
  }
}
