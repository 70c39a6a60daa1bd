/** What pointers over the stage mean while the tool that pulls is taken up: one finger or the first button on the pot pulls, and beside it turns; the second button turns, two fingers side by side on the pot squeeze it and elsewhere turn and pinch, the wheel zooms. */

/** A point of the window, in CSS pixels. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Which way a hand goes by the keys that are held with it; null for the one that is chosen. */
export type Modifier = "up" | "round" | null;

export interface PullTarget {
  /** Takes hold of what is there; false where there is nothing to take hold of. `adds` with the shift key, which elsewhere selects besides. */
  take(at: Point, adds: boolean): boolean;
  /** The hand that holds has come so far. `otherwise` with the control key. */
  pull(by: Point, modifier: Modifier, otherwise: boolean): void;
  /** Takes hold between two fingers; false where they do not hold the pot from both sides. */
  pinch(one: Point, other: Point): boolean;
  /** Each of the two has gone so far away from the other. */
  squeeze(by: number): void;
  /** Lets go, or did not mean it. */
  release(): void;
  cancel(): void;
  /** A mouse or pen is over this point and holds nothing; null where it left. */
  hover(at: Point | null): void;
  turn(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number): void;
  /** So many notches of the wheel wider. */
  widen(notches: number): void;
}

type Doing = "pull" | "squeeze" | "turn" | "pan" | "pinch";

/** A hand that moves no farther than this did not mean to. */
const STILL = 3;
/** As everywhere on the stage. */
const WHEEL_RATE = 0.0015;
const PINCH_WHEEL_RATE = 0.01;
const PIXELS_PER_NOTCH = 100;
const PIXELS_PER_LINE = 16;
const PIXELS_PER_PAGE = 400;

export class PullGesture {
  readonly #target: PullTarget;
  readonly #pointers = new Map<number, { x: number; y: number }>();
  #doing: Doing | null = null;
  #from: Point = { x: 0, y: 0 };
  /** How far two fingers were apart across the window when they took hold. */
  #apart = 0;
  /** Whether the hand that holds has moved since. */
  #moved = false;

  constructor(target: PullTarget) {
    this.#target = target;
  }

  /** Whether the pot is held. */
  get pulling(): boolean {
    return this.#doing === "pull" || this.#doing === "squeeze";
  }

  readonly down = (event: PointerEvent): void => {
    const at = { x: event.clientX, y: event.clientY };
    if (this.#pointers.size >= 2 || this.#pointers.has(event.pointerId)) return;
    this.#pointers.set(event.pointerId, { ...at });
    if (this.#pointers.size === 2) {
      // The first finger was on its way to a pinch.
      if (this.#doing === "pull") this.#target.cancel();
      this.#doing = this.#holds() ? "squeeze" : "pinch";
    } else this.#begin(event, at);
    capture(event);
  };

  /** Takes hold by something that stands over the pot. */
  readonly hold = (event: PointerEvent, take: () => boolean): void => {
    if (this.#pointers.size > 0 || event.button !== 0 || !take()) return;
    const at = { x: event.clientX, y: event.clientY };
    this.#pointers.set(event.pointerId, { ...at });
    this.#doing = "pull";
    this.#from = at;
    this.#moved = false;
    capture(event);
  };

  readonly move = (event: PointerEvent): void => {
    const at = { x: event.clientX, y: event.clientY };
    const pointer = this.#pointers.get(event.pointerId);
    if (!pointer) {
      if (this.#doing === null && event.pointerType !== "touch") this.#target.hover(at);
      return;
    }
    const before = this.#spread();
    const [dx, dy] = [at.x - pointer.x, at.y - pointer.y];
    Object.assign(pointer, at);
    switch (this.#doing) {
      case "pull": {
        const by = { x: at.x - this.#from.x, y: at.y - this.#from.y };
        this.#moved ||= Math.hypot(by.x, by.y) > STILL;
        if (this.#moved) this.#target.pull(by, modifierOf(event), event.ctrlKey || event.metaKey);
        return;
      }
      case "squeeze": {
        const by = (this.#across() - this.#apart) / 2;
        this.#moved ||= Math.abs(by) > STILL / 2;
        if (this.#moved) this.#target.squeeze(by);
        return;
      }
      case "turn":
        this.#target.turn(dx, dy);
        return;
      case "pan":
        this.#target.pan(dx, dy);
        return;
      case "pinch": {
        const after = this.#spread();
        // The middle of two fingers moves by half of what one of them does.
        this.#target.turn(dx / 2, dy / 2);
        if (before !== null && after !== null && before > 1 && after > 1) this.#target.zoom(after / before);
      }
    }
  };

  readonly up = (event: PointerEvent): void => {
    if (!this.#pointers.delete(event.pointerId)) return;
    const { pulling } = this;
    // The finger that stays of two goes on turning, but not where they held the pot.
    this.#doing = this.#pointers.size > 0 && !pulling ? "turn" : null;
    if (!pulling) return;
    if (event.type === "pointercancel") this.#target.cancel();
    else this.#target.release();
  };

  readonly leave = (): void => {
    if (this.#doing === null) this.#target.hover(null);
  };

  readonly wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const unit = [1, PIXELS_PER_LINE, PIXELS_PER_PAGE][event.deltaMode] ?? 1;
    // With the shift key some browsers scroll sideways.
    const raw = (event.deltaY || event.deltaX) * unit;
    const pixels = Math.min(Math.max(raw, -PIXELS_PER_PAGE), PIXELS_PER_PAGE);
    if (this.pulling || event.shiftKey || event.altKey) this.#target.widen(-pixels / PIXELS_PER_NOTCH);
    else this.#target.zoom(Math.exp(-pixels * (event.ctrlKey ? PINCH_WHEEL_RATE : WHEEL_RATE)));
  };

  /** Nothing is held any more, though the pointers are still down. */
  drop(): void {
    this.#doing = null;
    this.#pointers.clear();
  }

  #begin(event: PointerEvent, at: Point): void {
    this.#from = at;
    this.#moved = false;
    if (event.button === 2) this.#doing = "turn";
    else if (event.button !== 0 || event.ctrlKey || event.metaKey) this.#doing = "pan";
    else if (this.#target.take(at, event.shiftKey)) this.#doing = "pull";
    else this.#doing = event.shiftKey ? "pan" : "turn";
  }

  /** Whether the two fingers that are down hold the pot between them from now on. */
  #holds(): boolean {
    const [a, b] = [...this.#pointers.values()];
    this.#moved = false;
    this.#apart = this.#across();
    return a !== undefined && b !== undefined && this.#target.pinch(a, b);
  }

  /** How far two fingers are apart across the window. */
  #across(): number {
    const [a, b] = [...this.#pointers.values()];
    return a && b ? Math.abs(a.x - b.x) : 0;
  }

  /** The distance of two fingers, or null while there are not two. */
  #spread(): number | null {
    const [a, b] = [...this.#pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : null;
  }
}

function modifierOf(event: PointerEvent): Modifier {
  if (event.altKey) return "round";
  return event.shiftKey ? "up" : null;
}

function capture(event: PointerEvent): void {
  try {
    (event.currentTarget as Element | null)?.setPointerCapture(event.pointerId);
  } catch {
    // The pointer may be gone already; the gesture then ends with the next event.
  }
}
