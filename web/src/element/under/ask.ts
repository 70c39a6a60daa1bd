/** Asks what lies under a point of the stage. */

/** In CSS pixels from the upper left. */
export interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Sent by what lies over the stage and takes its pointers. */
export class UnderEvent extends Event {
  /** A point of the window. */
  readonly at: Spot;

  constructor(at: Spot) {
    super("under-asked", { bubbles: true, composed: true });
    this.at = at;
  }
}
