/** The way of a change to the screen, for whoever measures it; nobody does in use, and it then costs nothing. */

/** A change was asked of the solver, solved, given to the stage, drawn (as far as the page's thread is concerned). */
export type Moment = "asked" | "solved" | "shown" | "drawn";

type Listener = (moment: Moment, change: number, detail?: object) => void;

/** Tells the listener that a test or the bench put in `globalThis.pasuTrace`. `change` is {@link Shown.change}. */
export function trace(moment: Moment, change: number, detail?: object): void {
  (globalThis as { pasuTrace?: Listener }).pasuTrace?.(moment, change, detail);
}
