/** What lies over the stage while whole parts are moved: handles for the selected ones, for pointers and keys, and a hand on the parts themselves. */

import { css, html, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { longestOf } from "../../document/boxes";
import { AXES, type Axis, ownAxis, scaledBy, sum, unit } from "../../document/moving";
import type { Triple } from "../../document/types";
import { isClear } from "../../render/overlay/cover";
import { across } from "../../render/place/onto";
import { Watch } from "../../render/place/watch";
import type { See, Spot } from "../../render/pull/reach";
import type { Stage } from "../../render/stage";
import { placeParts, standingOf } from "../../state/place-actions";
import { alsoSelect, selectedIds, selectParts } from "../../state/seen-actions";
import { looseIds } from "../../state/several-actions";
import { base } from "../../ui/styles";
import { handling as words } from "../../words/english/handling";
import { motionWords, readingOf } from "../../words/handling";
import { type Held, heldBy, type Manner, mannerOf } from "../../work/held";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";
import { type Modifier, type Point, PullGesture } from "../pull/pull-gesture";
import { UnderEvent } from "../under/ask";
import "./place-bar";
import { gripKey, keyMotion } from "./grip-keys";
import { type Grip, type Hold, type Motion, motionOf, onRing, placesAfter, type Steps } from "./motion";

/** How far handles stand from the middle, in CSS pixels and as a share of the stage. */
const LEAST_REACH = 70;
const MOST_REACH = 0.34;
/** They stand a little outside what they move. */
const OUTSIDE = 0.62;
/** Handles that something lies over are drawn in, in such steps, to this share of how far they stand, and then tried on the other side. */
const DRAWN_IN = 0.05;
const NEAREST = 0.3;
/** Angles (in degrees) and factors where a hand goes in steps. */
const STEPS = { angle: 15, factor: 0.1 };
/** Points of a ring. */
const ROUND = 72;
/** Where on the screen the handles of the three rings are to be, so that none covers another: upper left, upper right, below. */
const LEANING: readonly Spot[] = [
  { x: -0.7, y: -0.7 },
  { x: 0.7, y: -0.7 },
  { x: 0, y: 1 },
];

@customElement("pasu-place-handles")
export class PasuPlaceHandles extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @state() private said = "";
  @state() private spoken = "";
  @query(".surface") private readonly surface!: HTMLElement;
  private readonly lent = new Lent(
    this,
    (bench) => new Watch(bench),
    (tool) => {
      tool.onFrame = () => this.follow();
    },
  );
  private hold: Hold | null = null;
  /** How far handles stood from the middle when a hand took hold of one. */
  private outer = 0;
  /** What keys move, from the first press to the last release: the middle stays the same meanwhile. */
  private keyed: Manner | null = null;
  private feeling = 0;
  private readonly placed = new WeakMap<Element, string>();
  private readonly gesture = new PullGesture({
    take: (at, adds) => this.takePart(at, adds),
    pull: (by, modifier, otherwise) => this.move(by, modifier, otherwise),
    // Two fingers turn and pinch, wherever they are.
    pinch: () => false,
    squeeze: () => {},
    release: () => this.release(),
    cancel: () => this.cancel(),
    hover: (at) => this.hover(at),
    turn: (dx, dy) => this.stage?.turnByPixels(dx, dy),
    pan: (dx, dy) => this.stage?.pan(dx, dy),
    zoom: (factor) => this.stage?.zoom(factor),
    widen: () => {},
  });

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.escape, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.escape, { capture: true });
    cancelAnimationFrame(this.feeling);
    this.gesture.drop();
    if (this.hold) this.designer.store.endGesture();
    this.hold = null;
  }

  override render() {
    const grips = this.grips();
    return html`
      <div
        class="surface"
        @pointerdown=${this.down}
        @pointermove=${this.gesture.move}
        @pointerup=${this.gesture.up}
        @pointercancel=${this.gesture.up}
        @lostpointercapture=${this.gesture.up}
        @pointerleave=${this.gesture.leave}
        @contextmenu=${(event: Event) => event.preventDefault()}
      ></div>
      <svg aria-hidden="true">
        ${grips.map((grip) =>
          grip.kind === "turn"
            ? svg`<path class="back" data-line=${nameOf(grip)} data-axis=${grip.axis} /><path class="line" data-line=${nameOf(grip)} data-axis=${grip.axis} /><path
                class="catch" data-line=${nameOf(grip)} data-axis=${grip.axis}
                @pointerdown=${(event: PointerEvent) => this.gesture.hold(event, () => this.take(grip, this.here(event)))}
                @pointermove=${this.gesture.move} @pointerup=${this.gesture.up} @pointercancel=${this.gesture.up} @lostpointercapture=${this.gesture.up} />`
            : svg`<path class="line" data-line=${nameOf(grip)} data-axis=${"axis" in grip && grip.axis !== null ? grip.axis : "all"} />`,
        )}
      </svg>
      <div class="handles" role="group" aria-label=${words.handles} aria-describedby="keys">
        ${grips.map((grip) => this.handle(grip))}
      </div>
      <output aria-hidden="true" ?hidden=${this.said === ""}>${this.said}</output>
      <p id="keys" class="spoken">${words.keys}</p>
      <p class="spoken" role="status">${this.spoken}</p>
    `;
  }

  override firstUpdated(): void {
    // Lit's own listeners of the wheel are passive in some browsers.
    this.addEventListener("wheel", this.gesture.wheel, { passive: false });
  }

  override updated(): void {
    // Where what is shown stands, and what of it is hidden, moves the handles.
    void this.designer.surface.shown;
    this.follow();
  }

  /** The handles that there are, by what a hand does: one part is scaled along its own axes too. */
  private grips(): readonly Grip[] {
    const { state } = this.designer;
    const loose = looseIds(state);
    const { handling } = state.session;
    const of = (kind: "move" | "turn" | "scale") => AXES.map((axis): Grip => ({ kind, axis }));
    if (loose.length === 0) return [];
    if (handling === "turn") return of("turn");
    if (handling === "move") return [...of("move"), { kind: "free" }];
    return [...(loose.length === 1 ? of("scale") : []), { kind: "scale", axis: null }];
  }

  private handle(grip: Grip) {
    const letter = "axis" in grip && grip.axis !== null ? words.letters[grip.axis] : "";
    const key = nameOf(grip);
    return html`<button
      type="button"
      class=${grip.kind}
      data-grip=${key}
      data-axis=${"axis" in grip && grip.axis !== null ? grip.axis : "all"}
      aria-roledescription=${words.handle}
      aria-label=${this.reading(grip)}
      @pointerdown=${(event: PointerEvent) => this.gesture.hold(event, () => this.takeHandle(event, grip))}
      @pointermove=${this.gesture.move}
      @pointerup=${this.gesture.up}
      @pointercancel=${this.gesture.up}
      @lostpointercapture=${this.gesture.up}
      @keydown=${(event: KeyboardEvent) => this.key(event, grip)}
      @keyup=${this.endKeys}
      @blur=${this.endKeys}
    >
      <span aria-hidden="true">${letter}</span>
    </button>`;
  }

  private reading(grip: Grip): string {
    const manner = this.hold ? null : this.manner();
    return readingOf(grip, manner, this.designer.store.design);
  }

  // What is held

  private manner(): Manner | null {
    return mannerOf(this.designer);
  }

  /** How far handles stand from the middle, in model units. */
  private reachOf(see: See, { pivot, box }: Manner): number {
    const [width, height] = this.lent.tool?.screen ?? [0, 0];
    const size = longestOf(box) || 1;
    const pixels = across(see, pivot, size) / size;
    if (!(pixels > 0)) return size;
    const wanted = Math.max(LEAST_REACH, OUTSIDE * size * pixels);
    return Math.min(wanted, Math.max(LEAST_REACH, MOST_REACH * Math.min(width, height))) / pixels;
  }

  /** How far a handle stands from the middle so that nothing lies over it, less than 0 on the other side; as far as the others where that is nowhere so. */
  private drawnIn(see: See, pivot: Triple, reach: number, grip: Grip): number {
    const cover = this.stage?.cover;
    const { hold } = this;
    // What is held stays in the hand.
    if (hold && nameOf(hold.grip) === nameOf(grip)) return hold.isBehind ? -hold.reach : hold.reach;
    if (!cover || grip.kind === "free" || grip.kind === "turn") return reach;
    for (const side of [reach, -reach]) {
      for (let share = 1; share >= NEAREST; share -= DRAWN_IN) {
        const spot = this.atEnd(see, pivot, share * side, grip);
        if (spot && isClear(spot, cover)) return share * side;
      }
    }
    return reach;
  }

  private take(grip: Grip, spot: Spot | null): boolean {
    const manner = this.manner();
    const see = this.lent.tool?.sight();
    const loose = looseIds(this.designer.state);
    if (!manner || !see || loose.length === 0) return false;
    this.outer = this.reachOf(see, manner);
    const stands = this.drawnIn(see, manner.pivot, this.outer, grip);
    this.hold = {
      ...heldBy(this.designer.state, manner, loose),
      grip,
      see,
      reach: Math.abs(stands),
      isBehind: stands < 0,
      spot: spot ?? see(manner.pivot) ?? { x: 0, y: 0 },
      along: grip.kind === "scale" && grip.axis !== null ? this.ownAxis(grip.axis) : null,
    };
    this.surface.classList.add("held");
    return true;
  }

  private readonly down = (event: PointerEvent): void => {
    if (event.altKey && event.button === 0) this.dispatchEvent(new UnderEvent({ x: event.clientX, y: event.clientY }));
    else this.gesture.down(event);
  };

  private takeHandle(event: PointerEvent, grip: Grip): boolean {
    event.preventDefault();
    (event.currentTarget as HTMLElement).focus({ preventScroll: true });
    return this.take(grip, this.here(event));
  }

  /** A part itself is taken hold of to be moved; one that was not selected is selected by that. */
  private takePart(at: Point, adds: boolean): boolean {
    const { designer, stage } = this;
    const { left, top } = this.surface.getBoundingClientRect();
    const spot = { x: at.x - left, y: at.y - top };
    const id = stage?.pick(spot.x, spot.y);
    if (id === null || id === undefined) return false;
    const part = Number(id);
    if (adds) {
      designer.apply(alsoSelect(designer.state, part));
      return false;
    }
    if (!selectedIds(designer.state).includes(part)) designer.apply(selectParts(part));
    const { session } = designer.state;
    return session.handling === "move" && !session.locked.includes(part) && this.take({ kind: "free" }, spot);
  }

  private ownAxis(axis: Axis): Triple {
    const { state } = this.designer;
    const [id] = looseIds(state);
    return id === undefined ? unit(axis) : ownAxis(standingOf(state, id), axis);
  }

  private here({ clientX, clientY }: PointerEvent): Spot {
    const { left, top } = this.surface.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  private move(by: Point, modifier: Modifier, otherwise: boolean): void {
    const { hold, designer } = this;
    if (!hold) return;
    const { session } = designer.state;
    const steps = session.snapping !== otherwise ? this.steps(hold) : null;
    const upwards = hold.grip.kind === "free" && modifier === "up";
    const motion = motionOf(upwards ? { ...hold, grip: { kind: "move", axis: 2 } } : hold, by, steps);
    if (!motion) return;
    this.change(hold, motion);
    this.said = motionWords(motion, designer.store.design);
  }

  private steps({ step }: Hold): Steps {
    return { length: step, ...STEPS };
  }

  private change(hold: Held, motion: Motion): void {
    this.designer.apply(placeParts(this.designer.state, placesAfter(hold, motion), "hand"));
  }

  private release(): void {
    this.letGo();
    this.designer.store.endGesture();
  }

  private cancel(): void {
    this.letGo();
    this.designer.store.cancelGesture();
  }

  private letGo(): void {
    this.hold = null;
    this.said = "";
    this.surface.classList.remove("held");
    this.requestUpdate();
  }

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !(this.hold || this.keyed)) return;
    event.preventDefault();
    event.stopPropagation();
    this.gesture.drop();
    this.keyed = null;
    this.cancel();
  };

  /** A hand that could take hold is shown as one. */
  private hover(at: Point | null): void {
    cancelAnimationFrame(this.feeling);
    this.feeling = requestAnimationFrame(() => {
      if (this.hold || !this.isConnected) return;
      const { left, top } = this.surface.getBoundingClientRect();
      const over = at !== null && (this.stage?.pick(at.x - left, at.y - top) ?? null) !== null;
      this.surface.classList.toggle("over", over);
    });
  }

  // Keys

  private key(event: KeyboardEvent, grip: Grip): void {
    if (event.ctrlKey || event.metaKey || event.altKey || this.hold) return;
    const { designer } = this;
    const loose = looseIds(designer.state);
    const way = gripKey(event.key);
    this.keyed ??= this.manner();
    const manner = this.keyed;
    if (!way || !manner || loose.length === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const held = heldBy(designer.state, manner, loose);
    const motion = keyMotion(grip, way, held.step, event.shiftKey);
    if (!motion) return;
    this.change(held, motion);
    this.spoken = readingOf(grip, this.manner(), designer.store.design);
  }

  private readonly endKeys = (): void => {
    this.keyed = null;
    if (!this.hold) this.designer.store.endGesture();
  };

  // What is seen

  /** Moves the handles to where they are seen. */
  private follow(): void {
    const see = this.lent.tool?.sight();
    const manner = this.hold ? this.following(this.hold) : this.manner();
    const middle = manner && see?.(manner.pivot);
    this.toggleAttribute("away", !middle);
    if (!see || !manner || !middle) return;
    const reach = this.hold?.grip.kind === "scale" ? this.outer : this.reachOf(see, manner);
    for (const grip of this.grips()) {
      const spot =
        grip.kind === "turn"
          ? this.drawRing(see, manner.pivot, reach, grip)
          : this.drawAxis(see, manner.pivot, this.drawnIn(see, manner.pivot, reach, grip), grip, middle);
      const handle = this.renderRoot.querySelector<HTMLElement>(`[data-grip="${nameOf(grip)}"]`);
      if (!handle) continue;
      handle.hidden = !spot;
      if (spot) this.put(handle, spot);
    }
    const output = this.renderRoot.querySelector("output");
    if (output) this.put(output, { x: middle.x, y: middle.y + 24 });
  }

  /** What is where it was is not touched: the browser would lay it out again. */
  private put(element: HTMLElement, { x, y }: Spot): void {
    const where = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    if (this.placed.get(element) === where) return;
    this.placed.set(element, where);
    element.style.setProperty("transform", where);
  }

  /** What is held turns and grows about where it was, and its handles go with it where it moves. */
  private following({ grip, pivot }: Hold): Manner | null {
    const now = this.manner();
    return now && (grip.kind === "free" || grip.kind === "move" ? now : { ...now, pivot });
  }

  private drawAxis(see: See, pivot: Triple, reach: number, grip: Grip, middle: Spot): Spot | null {
    if (grip.kind === "free") return middle;
    const spot = this.atEnd(see, pivot, reach, grip);
    this.draw(nameOf(grip), "line", spot ? [middle, spot] : []);
    return spot;
  }

  /** Where the end of a line so long is seen along which something is moved or scaled; with less than 0, on the other side. */
  private atEnd(see: See, pivot: Triple, reach: number, grip: Grip): Spot | null {
    if (grip.kind === "free" || grip.kind === "turn") return null;
    if (grip.axis !== null) {
      const way = grip.kind === "move" ? unit(grip.axis) : this.ownAxis(grip.axis);
      return see(sum(pivot, scaledBy(reach, way)));
    }
    const middle = see(pivot);
    const far = Math.SQRT1_2 * Math.sign(reach) * across(see, pivot, Math.abs(reach));
    return middle && { x: middle.x + far, y: middle.y - far };
  }

  /** The half of the ring that is before the middle is plain, the other faint. */
  private drawRing(
    see: See,
    pivot: Triple,
    reach: number,
    grip: { readonly kind: "turn"; readonly axis: Axis },
  ): Spot | null {
    const middle = see(pivot);
    const points = Array.from({ length: ROUND + 1 }, (_, i) =>
      see(onRing(pivot, reach, grip.axis, (2 * Math.PI * i) / ROUND)),
    );
    if (!middle || points.some((point) => point === null)) {
      for (const what of ["line", "back", "catch"]) this.draw(nameOf(grip), what, []);
      return null;
    }
    const ring = points as Spot[];
    const nearer = (spot: Spot) => (spot.depth ?? 0) <= (middle.depth ?? 0);
    this.draw(nameOf(grip), "back", ring);
    this.draw(nameOf(grip), "catch", ring);
    this.draws(nameOf(grip), "line", runs(ring, nearer));
    const lean = LEANING[grip.axis] as Spot;
    const along = ({ x, y }: Spot) => (x - middle.x) * lean.x + (y - middle.y) * lean.y;
    const cover = this.stage?.cover;
    const clear = cover ? ring.filter((spot) => isClear(spot, cover)) : ring;
    return (clear.length > 0 ? clear : ring).reduce((best, spot) => (along(spot) > along(best) ? spot : best));
  }

  private draw(name: string, what: string, spots: readonly Spot[]): void {
    this.draws(name, what, [spots]);
  }

  private draws(name: string, what: string, lines: readonly (readonly Spot[])[]): void {
    const path = lines
      .map((spots) => spots.map(({ x, y }, at) => `${at === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`).join(""))
      .join("");
    const line = this.renderRoot.querySelector(`path.${what}[data-line="${name}"]`);
    if (line?.getAttribute("d") !== path) line?.setAttribute("d", path);
  }

  static override readonly styles = [
    base,
    css`
      :host {
        position: absolute;
        z-index: 1;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
        --x: #c8402f;
        --y: #2c7d3f;
        --z: #2f62c8;
      }
      .surface {
        position: absolute;
        inset: 0;
        touch-action: none;
        pointer-events: auto;
      }
      .surface.over {
        cursor: grab;
      }
      .surface.held {
        cursor: grabbing;
      }
      svg {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      path {
        fill: none;
        stroke: var(--own);
        stroke-width: 2.5;
        stroke-linecap: round;
        stroke-linejoin: round;
        paint-order: stroke;
      }
      .back {
        stroke-width: 1.6;
        opacity: 0.4;
      }
      .catch {
        stroke-width: 16;
        opacity: 0;
        cursor: grab;
        pointer-events: stroke;
        touch-action: none;
      }
      [data-axis="0"] {
        --own: var(--x);
      }
      [data-axis="1"] {
        --own: var(--y);
      }
      [data-axis="2"] {
        --own: var(--z);
      }
      [data-axis="all"] {
        --own: var(--accent);
      }
      .handles {
        position: absolute;
        inset: 0;
      }
      :host([away]) .handles,
      :host([away]) svg {
        visibility: hidden;
      }
      button {
        position: absolute;
        top: -16px;
        left: -16px;
        display: grid;
        place-items: center;
        width: 32px;
        height: 32px;
        padding: 0;
        border: 0;
        border-radius: 50%;
        background: none;
        color: #fff;
        font: inherit;
        font-size: 0.8rem;
        font-weight: 650;
        line-height: 1;
        cursor: grab;
        touch-action: none;
        pointer-events: auto;
      }
      button[hidden] {
        display: none;
      }
      button span {
        display: grid;
        place-items: center;
        width: 22px;
        height: 22px;
        border: 2px solid #fff;
        border-radius: 50%;
        background: var(--own);
        box-shadow: 0 1px 5px var(--shadow);
      }
      .scale span {
        border-radius: 5px;
      }
      .free span {
        width: 18px;
        height: 18px;
        border-radius: 4px;
      }
      button:hover span {
        filter: brightness(1.15);
      }
      button:active {
        cursor: grabbing;
      }
      button:focus-visible {
        outline-offset: -2px;
      }
      @media (pointer: coarse) {
        button {
          top: -22px;
          left: -22px;
          width: 44px;
          height: 44px;
        }
        button span {
          width: 26px;
          height: 26px;
        }
      }
      output {
        position: absolute;
        top: 0;
        left: 0;
        padding: 3px 9px;
        border: 1px solid var(--line);
        border-radius: 8px;
        background: var(--sheet);
        color: var(--ink);
        font-size: 0.9rem;
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
      }
      output[hidden] {
        display: none;
      }
      @media (forced-colors: active) {
        button span {
          border-color: ButtonText;
          forced-color-adjust: none;
        }
      }
    `,
  ];
}

/** The name of a handle, which the page and tests find it by. */
export function nameOf(grip: Grip): string {
  if (grip.kind === "free") return "free";
  return `${grip.kind}-${grip.axis === null ? "all" : "xyz"[grip.axis]}`;
}

/** The stretches of a line that are so. */
function runs(line: readonly Spot[], is: (spot: Spot) => boolean): readonly (readonly Spot[])[] {
  const found: Spot[][] = [];
  let open = false;
  for (const spot of line) {
    if (is(spot)) {
      if (!open) found.push([]);
      found.at(-1)?.push(spot);
    }
    open = is(spot);
  }
  return found;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-place-handles": PasuPlaceHandles;
  }
}
