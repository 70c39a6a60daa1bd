import { Leisure } from "./leisure";

/** Of all stages of a page. */
const leisure = new Leisure();

/**
 * Draws when something changed and only then: `invalidate` asks for one frame, `draw` says whether there is motion left,
 * and the loop stops itself when there is none.
 */
export class Loop {
  private request = 0;
  private last: number | null = null;
  private paused = false;
  private wanted = false;
  private waiting: (() => void)[] = [];

  /**
   * @param draw draws one frame; `seconds` have passed since the one before (0 for the first after a rest), `now` is
   *   the frame's time in milliseconds. True when another frame has to follow.
   */
  constructor(private readonly draw: (seconds: number, now: number) => boolean) {}

  /** Whether a frame is still to come. */
  get pending(): boolean {
    return this.wanted || leisure.has(this.ask);
  }

  invalidate(): void {
    this.wanted = true;
    if (this.request === 0 && !this.paused) this.request = requestAnimationFrame(this.frame);
  }

  /** Asks for one frame after a time without any, or when all other stages have had theirs; a call replaces the one before. */
  later(milliseconds: number): void {
    leisure.after(milliseconds, this.ask);
  }

  /** Holds frames back (a lost context, a stage without size); what was asked for is kept. */
  pause(): void {
    this.paused = true;
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.last = null;
  }

  resume(): void {
    if (!this.paused) return;
    this.paused = false;
    if (this.wanted) this.invalidate();
  }

  /** Resolves when nothing more is to be drawn: at once at rest, else after the last frame. */
  whenIdle(): Promise<void> {
    if (!this.pending) return Promise.resolve();
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  dispose(): void {
    this.pause();
    leisure.forget(this.ask);
    this.wanted = false;
    this.release();
  }

  private readonly ask = () => this.invalidate();

  private readonly frame = (now: number): void => {
    this.request = 0;
    this.wanted = false;
    const seconds = this.last === null ? 0 : Math.max(0, (now - this.last) / 1000);
    this.last = now;
    if (this.draw(seconds, now)) this.invalidate();
    if (this.wanted) return;
    this.last = null;
    if (!this.pending) this.release();
  };

  private release(): void {
    const waiting = this.waiting;
    this.waiting = [];
    for (const resolve of waiting) resolve();
  }
}
