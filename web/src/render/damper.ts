/** Below this much time a step is taken as no time at all (a clock that stood still or went back). */
const LEAST_STEP_SECONDS = 1e-6;

/** A tab that slept must not make the motion leap to its end in one frame, nor overflow the exponential. */
const LONGEST_STEP_SECONDS = 0.1;

/**
 * One number that follows its goal as a critically damped spring does: no overshoot from rest, the same motion at any
 * frame rate (each step is the exact solution, `x(t) = goal + (a + b t) e^(-t / lag)`), and an end. A damped
 * motion never arrives by itself; this one does, as soon as what is left is smaller than `settle`.
 */
export class Damper {
  value: number;
  goal: number;
  private velocity = 0;

  /**
   * @param settle what counts as arrived, in the unit of the value
   * @param lag the time constant in seconds; about five of them pass before the goal is reached
   */
  constructor(
    value: number,
    public settle: number,
    public lag: number,
  ) {
    this.value = value;
    this.goal = value;
  }

  get moving(): boolean {
    return this.value !== this.goal || this.velocity !== 0;
  }

  /** Goes to a value at once. */
  jump(value: number): void {
    this.value = value;
    this.goal = value;
    this.velocity = 0;
  }

  /** Moves the value and its goal together, keeping the motion (a change of origin). */
  shift(by: number): void {
    this.value += by;
    this.goal += by;
  }

  /** Advances by a time; true while there is motion left. */
  step(seconds: number): boolean {
    if (!this.moving) return false;
    if (!(seconds > LEAST_STEP_SECONDS)) return true;
    const time = Math.min(seconds, LONGEST_STEP_SECONDS);
    const rate = 1 / this.lag;
    const decay = Math.exp(-rate * time);
    const a = this.value - this.goal;
    const b = this.velocity + rate * a;
    const left = (a + b * time) * decay;
    this.velocity = (b - rate * (a + b * time)) * decay;
    this.value = this.goal + left;
    if (Math.abs(left) <= this.settle && Math.abs(this.velocity) * this.lag <= this.settle) this.jump(this.goal);
    return this.moving;
  }
}
