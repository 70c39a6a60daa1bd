/** More device pixels than this per CSS pixel cost time and show nothing. */
const HIGHEST_RATIO = 2;

/** Frames longer than this feel like a jerk; those shorter leave room for more pixels. In milliseconds. */
const SLOW = 42;
const QUICK = 20;

/** Coarsest picture while moving, in device pixels per CSS pixel. */
const LOWEST_RATIO = 0.5;

/** A change of resolution costs a frame itself: it takes this many frames in a row to earn one. */
const PATIENCE = 3;

/**
 * How many device pixels to draw per CSS pixel: all of them at rest, fewer while something moves if frames turn out slow. What was
 * learnt in one movement is kept for the next.
 */
export class Resolution {
  private share = 1;
  private streak = 0;

  /** The ratio for the next frame, given the screen's own. */
  ratio(device: number, moving: boolean): number {
    const full = Math.min(Math.max(device, LOWEST_RATIO), HIGHEST_RATIO);
    return moving ? Math.max(full * this.share, Math.min(LOWEST_RATIO, full)) : full;
  }

  /** Learns from the time between two frames of one movement. */
  learn(milliseconds: number): void {
    if (milliseconds > SLOW) this.streak = Math.max(this.streak, 0) + 1;
    else if (milliseconds < QUICK) this.streak = Math.min(this.streak, 0) - 1;
    else this.streak = 0;
    if (this.streak >= PATIENCE) {
      this.share = Math.max(this.share * 0.72, 0.25);
      this.streak = 0;
    } else if (this.streak <= -30) {
      this.share = Math.min(this.share * 1.2, 1);
      this.streak = 0;
    }
  }
}
