/** More device pixels than this per CSS pixel cost time and show nothing. */
const HIGHEST_RATIO = 2;

/** Coarsest picture while moving, in device pixels per CSS pixel. */
const LOWEST_RATIO = 0.5;

/** Frames longer than this feel like a jerk; those shorter leave room for more. In milliseconds. */
const SLOW = 42;
const QUICK = 20;

/** How many frames in a row it takes to go one step down, and up. */
const PATIENCE_DOWN = 2;
const PATIENCE_UP = 24;

/** Samples per pixel of a smooth picture. */
const SMOOTH = 4;

/** How finely a frame is drawn. */
export interface Fineness {
  /** Device pixels per CSS pixel. */
  ratio: number;
  /** Samples per pixel: 4 for smooth edges, 0 for plain ones. */
  samples: number;
}

/** What a picture in motion is drawn with, from best to cheapest: share of the full ratio, samples. */
const STEPS: readonly Fineness[] = [
  { ratio: 1, samples: SMOOTH },
  { ratio: 1, samples: 0 },
  { ratio: 0.72, samples: 0 },
  { ratio: 0.5, samples: 0 },
];

/**
 * How finely to draw: as finely as the screen can show at rest, and in motion as finely as frames stay quick. What one movement taught is
 * kept for the next. It begins in the middle, so that the first picture is never waited for.
 */
export class Resolution {
  private step = 1;
  private streak = 0;

  /** The fineness of the next frame, given the device's pixels per CSS pixel. */
  next(device: number, moving: boolean): Fineness {
    const full = Math.min(Math.max(device, LOWEST_RATIO), HIGHEST_RATIO);
    if (!moving) return { ratio: full, samples: SMOOTH };
    const { ratio, samples } = STEPS[this.step] as Fineness;
    return { ratio: Math.max(full * ratio, Math.min(LOWEST_RATIO, full)), samples };
  }

  /** Whether nothing coarser is left. */
  get coarsest(): boolean {
    return this.step === STEPS.length - 1;
  }

  /** Learns from the time between two frames of one movement, or from what one frame cost. */
  learn(milliseconds: number): void {
    if (milliseconds > SLOW) this.streak = Math.max(this.streak, 0) + 1;
    else if (milliseconds < QUICK) this.streak = Math.min(this.streak, 0) - 1;
    else this.streak = 0;
    if (this.streak >= PATIENCE_DOWN) this.change(1);
    else if (this.streak <= -PATIENCE_UP) this.change(-1);
  }

  private change(by: number): void {
    this.step = Math.min(Math.max(this.step + by, 0), STEPS.length - 1);
    this.streak = 0;
  }
}
