/** So much time is left for what somebody waits for between two of these, in milliseconds. */
const BETWEEN = 20;

/** Frames that nobody waits for come one at a time, the longest due first: of many stages none has its first picture behind others that are only made smoother. */
export class Leisure {
  private readonly due = new Map<() => void, number>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Runs once after a time; a call replaces the one before. */
  after(milliseconds: number, run: () => void): void {
    this.due.set(run, performance.now() + milliseconds);
    this.wait(0);
  }

  forget(run: () => void): void {
    this.due.delete(run);
    this.wait(0);
  }

  has(run: () => void): boolean {
    return this.due.has(run);
  }

  private wait(least: number): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    if (this.due.size === 0) return;
    const left = Math.min(...this.due.values()) - performance.now();
    this.timer = setTimeout(() => this.next(), Math.max(left, least));
  }

  private next(): void {
    const [first] = [...this.due].sort(([, one], [, other]) => one - other);
    if (first) {
      const [run] = first;
      this.due.delete(run);
      run();
    }
    this.wait(BETWEEN);
  }
}
