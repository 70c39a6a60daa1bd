/** What a gesture asks of the camera; lengths in CSS pixels, right and down. */
export interface GestureTarget {
  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number): void;
  /** The first button, a pen or one finger came down and went up again at about the same place of the window; `adds` with the shift or the control key. */
  tap(x: number, y: number, adds: boolean): void;
  /** The same with the alt key, by the second button, or by a finger that stays where it is: what lies there is asked for. */
  under(x: number, y: number): void;
  /** A gesture has begun or ended: pictures may be coarser in between. */
  gesture(active: boolean): void;
}

/** A stage inside a page that scrolls: one finger and the wheel are the page's, two fingers turn and pinch. */
export interface PageManners {
  /** Whether the wheel zooms without the control key too. */
  takesWheel(): boolean;
}

/** One notch of a wheel (100 pixels in most browsers) comes closer by a sixth. */
const WHEEL_RATE = 0.0015;
/** A pinch on a trackpad arrives as a wheel with the control key and in much smaller numbers. */
const PINCH_WHEEL_RATE = 0.01;
/** A hand that moves no farther than this did not mean to. */
const STILL = 6;
/** A finger that stays so many milliseconds asks. */
const LONG = 550;
const PIXELS_PER_LINE = 16;
const PIXELS_PER_PAGE = 400;

/**
 * Mouse, pen and touch on the stage: one finger or the first button turns, two fingers pinch and move, another button or a modifier
 * key moves, the wheel zooms, and only over the stage. The keyboard belongs to the page, which calls the stage's methods. Inside a page that
 * scrolls it has {@link PageManners}.
 */
export class Gesture {
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private moves = false;
  private active = false;
  /** How many pointers make a gesture. */
  private needed = 1;
  /** Where a touch came down that may turn out to be a tap, or to ask what lies there. */
  private tapped: { readonly x: number; readonly y: number; readonly adds: boolean; readonly asks: boolean } | null =
    null;
  private readonly listeners = new AbortController();

  constructor(
    private readonly surface: HTMLElement,
    private readonly target: GestureTarget,
    private readonly page: PageManners | null = null,
  ) {
    surface.style.touchAction = page ? "pan-x pan-y" : "none";
    const { signal } = this.listeners;
    surface.addEventListener("pointerdown", this.down, { signal });
    surface.addEventListener("pointermove", this.move, { signal });
    surface.addEventListener("pointerup", this.up, { signal });
    surface.addEventListener("pointercancel", this.up, { signal });
    surface.addEventListener("lostpointercapture", this.up, { signal });
    surface.addEventListener("wheel", this.wheel, { signal, passive: false });
    if (page) {
      surface.addEventListener("touchstart", this.claim, { signal, passive: false });
      surface.addEventListener("touchmove", this.claim, { signal, passive: false });
    } else surface.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  }

  dispose(): void {
    this.listeners.abort();
    this.pointers.clear();
    this.tapped = null;
  }

  private readonly down = (event: PointerEvent): void => {
    // A third finger has no meaning; a second mouse button during a drag does not restart it.
    if (this.pointers.size >= 2 || this.pointers.has(event.pointerId)) return;
    // The other buttons have their meaning in a page: its menu, scrolling by itself.
    if (this.page && event.button !== 0) return;
    if (this.pointers.size === 0) {
      this.moves = event.button !== 0 || event.shiftKey || event.ctrlKey || event.metaKey;
      this.needed = this.page && event.pointerType !== "mouse" ? 2 : 1;
      const adds = event.shiftKey || event.ctrlKey || event.metaKey;
      const asks = event.button === 2 || event.altKey;
      const tapped = event.button === 0 || asks ? { x: event.clientX, y: event.clientY, adds, asks } : null;
      this.tapped = tapped;
      if (tapped && event.pointerType !== "mouse" && !this.page) setTimeout(() => this.stay(tapped), LONG);
    } else this.tapped = null;
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.tell();
    if (!this.active) return;
    try {
      this.surface.setPointerCapture(event.pointerId);
    } catch {
      // The pointer may be gone already (a synthetic or cancelled one); the gesture then ends with the next event.
    }
  };

  private readonly move = (event: PointerEvent): void => {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    if (this.tapped && Math.hypot(event.clientX - this.tapped.x, event.clientY - this.tapped.y) > STILL) {
      this.tapped = null;
    }
    const before = this.spread();
    const dx = event.clientX - pointer.x;
    const dy = event.clientY - pointer.y;
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    const after = this.spread();
    if (before !== null && after !== null) {
      // The middle of two fingers moves by half of what one of them does.
      if (this.page) this.target.orbit(dx / 2, dy / 2);
      else this.target.pan(dx / 2, dy / 2);
      if (before > 1 && after > 1) this.target.zoom(after / before);
    } else if (!this.active) {
      // The page scrolls.
    } else if (this.moves) {
      this.target.pan(dx, dy);
    } else {
      this.target.orbit(dx, dy);
    }
  };

  private readonly up = (event: PointerEvent): void => {
    if (!this.pointers.delete(event.pointerId)) return;
    // The finger that stays goes on turning, not moving.
    this.moves = false;
    this.tell();
    if (this.pointers.size > 0) return;
    const { tapped } = this;
    this.tapped = null;
    if (!tapped || event.type !== "pointerup") return;
    if (tapped.asks) this.target.under(event.clientX, event.clientY);
    else this.target.tap(event.clientX, event.clientY, tapped.adds);
  };

  /** A finger is still where it came down, and neither moved nor was joined by another. */
  private stay(tapped: NonNullable<Gesture["tapped"]>): void {
    if (this.tapped !== tapped) return;
    this.tapped = null;
    this.target.under(tapped.x, tapped.y);
  }

  /** Says when a gesture begins and ends. */
  private tell(): void {
    const active = this.pointers.size >= this.needed;
    if (active === this.active) return;
    this.active = active;
    this.target.gesture(active);
  }

  /** Two fingers are for the pot: the page neither scrolls nor grows. */
  private readonly claim = (event: TouchEvent): void => {
    if (event.touches.length >= 2 && event.cancelable) event.preventDefault();
  };

  private readonly wheel = (event: WheelEvent): void => {
    if (this.page && !event.ctrlKey && !this.page.takesWheel()) return;
    event.preventDefault();
    const unit =
      event.deltaMode === WheelEvent.DOM_DELTA_LINE
        ? PIXELS_PER_LINE
        : event.deltaMode === WheelEvent.DOM_DELTA_PAGE
          ? PIXELS_PER_PAGE
          : 1;
    const pixels = Math.min(Math.max(event.deltaY * unit, -PIXELS_PER_PAGE), PIXELS_PER_PAGE);
    this.target.zoom(Math.exp(-pixels * (event.ctrlKey ? PINCH_WHEEL_RATE : WHEEL_RATE)));
  };

  /** The distance of two fingers, or null while there are not two. */
  private spread(): number | null {
    if (this.pointers.size !== 2) return null;
    const [a, b] = [...this.pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : null;
  }
}
