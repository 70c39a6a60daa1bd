/** The sheet that a pot is drawn on: strokes become lines, points of lines are dragged or moved by keys, and so is the axis. */

import { css, html, LitElement, nothing, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Knot, Spot } from "../../document/drawn/knot";
import {
  addKnot,
  gapAt,
  knotsOn,
  lineOn,
  measured,
  moveAxis,
  moveKnot,
  removeKnot,
  SHEET,
  type Sheet,
  type Side,
  sharpenKnot,
  sidesDrawn,
} from "../../document/drawn/sheet";
import { mirrored } from "../../document/drawn/sides";
import type { Unit } from "../../document/types";
import { arrowOf, handleStyles, reachOf } from "../../ui/handles";
import { base } from "../../ui/styles";
import { drawing as words } from "../../words/english/drawing";
import { spokenLength } from "../../words/quantities";

/** A finger's reach round a point. */
const REACH = 15;
const LEAST_REACH = 7;
/** A double click this near a line puts a point there. */
const NEAR = 14;

/** The sheet is another one; `settled` once the hand has let go. */
export class SheetEvent extends Event {
  readonly sheet: Sheet;
  readonly settled: boolean;
  constructor(sheet: Sheet, settled: boolean) {
    super("sheet-changed");
    this.sheet = sheet;
    this.settled = settled;
  }
}

/** A line was drawn by hand. */
export class StrokeEvent extends Event {
  readonly line: readonly Spot[];
  constructor(line: readonly Spot[]) {
    super("stroke-drawn");
    this.line = line;
  }
}

/** The rings that were found, on the sheet. */
export interface Overlay {
  readonly lines: readonly (readonly Spot[])[];
  readonly rings: readonly (readonly [Spot, Spot])[];
}

interface Held {
  readonly id: number;
  readonly sheet: Sheet;
  readonly from: Spot;
  readonly move: (sheet: Sheet, by: Spot) => Sheet;
}

@customElement("pasu-drawing-board")
export class PasuDrawingBoard extends LitElement {
  @property({ attribute: false }) sheet!: Sheet;
  @property({ attribute: false }) photo: HTMLCanvasElement | null = null;
  /** What else there is to trace: other lines of the file, the pot as it is. */
  @property({ attribute: false }) ghosts: readonly (readonly Spot[])[] = [];
  @property({ attribute: false }) overlay: Overlay | null = null;
  @property() unit: Unit = "cm";
  /** What is being drawn. */
  @state() private stroke: readonly Spot[] | null = null;
  @state() private spoken = "";
  @query("svg") private readonly picture!: SVGSVGElement;
  private pointer: number | null = null;
  private held: Held | null = null;

  override render() {
    const { sheet, overlay } = this;
    const sides = sidesDrawn(sheet);
    const lines = sides.map((side) => lineOn(sheet, side));
    const alike = sheet.left === null && lines[0] ? mirrored(lines[0], sheet.axis) : null;
    const spots = sides.flatMap((side) => [...knotsOn(sheet, side)]);
    return html`
      <div class="sheet">
        ${this.photo}
        <svg
          viewBox="0 0 ${SHEET} ${SHEET}"
          role="group"
          aria-label=${words.board}
          aria-describedby="keys"
          @pointerdown=${this.begin}
          @pointermove=${this.draw}
          @pointerup=${this.end}
          @pointercancel=${this.cancel}
          @lostpointercapture=${this.end}
          @dblclick=${this.put}
        >
          ${this.ghosts.map((line) => svg`<path class="ghost" d=${pathOf(line)} />`)}
          ${alike && !overlay ? svg`<path class="alike" d=${pathOf(alike)} />` : nothing}
          ${lines.map((line) => svg`<path class="line" d=${pathOf(line)} />`)}
          ${(overlay?.lines ?? []).map((line) => svg`<path class="fitted" d=${pathOf(line)} />`)}
          ${(overlay?.rings ?? []).map(([a, b]) => svg`<line class="hoop" x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`)}
          ${this.stroke ? svg`<path class="stroke" d=${pathOf(this.stroke)} />` : nothing}
          ${this.axis()}
          ${sides.flatMap((side) => knotsOn(sheet, side).map((knot, index) => this.knot(side, knot, index, spots)))}
        </svg>
      </div>
      <p id="keys" class="spoken">${words.keys}</p>
      <p class="spoken" role="status">${this.spoken}</p>
    `;
  }

  private axis() {
    const { axis } = this.sheet;
    return svg`<line class="axis" x1=${axis} y1="0" x2=${axis} y2=${SHEET} />
      <g
        class="handle across axle"
        tabindex="0"
        role="button"
        aria-roledescription=${words.handle}
        aria-label=${words.axisName}
        data-knot="axis"
        transform="translate(${axis} ${SHEET - 16})"
        @pointerdown=${(event: PointerEvent) => this.hold(event, (sheet, by) => moveAxis(sheet, within(this.held?.sheet.axis ?? 0, by.x)))}
        @keydown=${(event: KeyboardEvent) => this.key(event, (sheet, by) => moveAxis(sheet, within(sheet.axis, by.x)))}
      >
        <circle class="reach" r=${REACH} />
        <circle class="ring" r="11" />
        <path class="knob" d="M-8 0L-3 -5V5ZM8 0L3 -5V5Z" />
      </g>`;
  }

  private knot(side: Side, knot: Knot, index: number, spots: readonly Spot[]) {
    const others = spots.filter((spot) => spot !== knot);
    const move = (sheet: Sheet, by: Spot) => {
      const from = knotsOn(sheet, side)[index];
      return from ? moveKnot(sheet, side, index, { x: inSheet(from.x + by.x), y: inSheet(from.y + by.y) }) : sheet;
    };
    return svg`<g
      class="handle"
      tabindex="0"
      role="button"
      aria-roledescription=${words.handle}
      aria-label=${this.reading(side, knot, index)}
      data-knot="${side} ${index}"
      transform="translate(${knot.x} ${knot.y})"
      @pointerdown=${(event: PointerEvent) => this.hold(event, move)}
      @dblclick=${(event: Event) => event.stopPropagation()}
      @keydown=${(event: KeyboardEvent) => this.key(event, move, side, index)}
    >
      <circle class="reach" r=${reachOf(knot, others, LEAST_REACH, REACH)} />
      <circle class="ring" r="10" />
      ${
        knot.sharp
          ? svg`<rect class="knob" x="-4.5" y="-4.5" width="9" height="9" transform="rotate(45)" />`
          : svg`<circle class="knob" r="4.6" />`
      }
    </g>`;
  }

  private reading(side: Side, knot: Spot, index: number): string {
    const { radius, height } = measured(this.sheet, knot);
    const name = pointName(this.sheet, side, index);
    return words.at(name, spokenLength(radius, this.unit, 3), spokenLength(height, this.unit, 3));
  }

  /** Where a pointer is on the sheet. */
  private spotOf({ clientX, clientY }: MouseEvent): Spot {
    const { left, top, width } = this.picture.getBoundingClientRect();
    const scale = SHEET / width;
    return { x: inSheet((clientX - left) * scale), y: inSheet((clientY - top) * scale) };
  }

  // Strokes

  private readonly begin = (event: PointerEvent): void => {
    if (event.button !== 0 || this.pointer !== null || this.held) return;
    event.preventDefault();
    this.pointer = event.pointerId;
    this.picture.setPointerCapture(event.pointerId);
    this.stroke = [this.spotOf(event)];
  };

  private readonly draw = (event: PointerEvent): void => {
    const { held } = this;
    if (held?.id === event.pointerId) {
      const at = this.spotOf(event);
      this.tell(held.move(held.sheet, { x: at.x - held.from.x, y: at.y - held.from.y }), false);
      return;
    }
    if (event.pointerId !== this.pointer || !this.stroke) return;
    // Some browsers have none where one was made by a program.
    const all = event.getCoalescedEvents?.() ?? [];
    this.stroke = [...this.stroke, ...(all.length > 0 ? all : [event]).map((each) => this.spotOf(each))];
  };

  private readonly end = (event: PointerEvent): void => {
    if (this.held?.id === event.pointerId) {
      this.held = null;
      this.tell(this.sheet, true);
      return;
    }
    const { stroke } = this;
    if (event.pointerId !== this.pointer || !stroke) return;
    this.pointer = null;
    this.stroke = null;
    // A press that goes nowhere is none.
    if (stroke.length > 2) this.dispatchEvent(new StrokeEvent(stroke));
  };

  private readonly cancel = (event: PointerEvent): void => {
    if (this.held?.id === event.pointerId) {
      const { sheet } = this.held;
      this.held = null;
      this.tell(sheet, true);
    }
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    this.stroke = null;
  };

  // Points

  private hold(event: PointerEvent, move: Held["move"]): void {
    if (event.button !== 0 || this.pointer !== null || this.held) return;
    event.preventDefault();
    event.stopPropagation();
    (event.currentTarget as SVGGElement).focus({ preventScroll: true });
    this.picture.setPointerCapture(event.pointerId);
    this.held = { id: event.pointerId, sheet: this.sheet, from: this.spotOf(event), move };
  }

  private key(event: KeyboardEvent, move: Held["move"], side?: Side, index?: number): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = arrowOf(event);
    const { sheet } = this;
    let next: Sheet | null = null;
    if (arrow) next = move(sheet, { x: arrow.right, y: -arrow.up });
    else if (side !== undefined && index !== undefined) next = edited(sheet, side, index, event.key);
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    this.tell(next, true);
    const name = (event.currentTarget as Element).getAttribute("data-knot");
    void this.follow(name, sheet, side, index);
  }

  /** What was said of the point stays true, and the focus stays on what there is of it. */
  private async follow(name: string | null, before: Sheet, side?: Side, index?: number): Promise<void> {
    await this.updateComplete;
    if (side !== undefined && index !== undefined) {
      const at = Math.min(index, knotsOn(this.sheet, side).length - 1);
      const knot = knotsOn(this.sheet, side)[at];
      const change = changeOf(knotsOn(before, side), knotsOn(this.sheet, side), index);
      if (knot) this.spoken = change(this.reading(side, knot, at));
    }
    const still = this.renderRoot.querySelector<SVGGElement>(`[data-knot="${name}"]`);
    const last = [...this.renderRoot.querySelectorAll<SVGGElement>(`[data-knot^="${side}"]`)].at(-1);
    (still ?? last)?.focus({ preventScroll: true });
  }

  /** Puts a point where a line is clicked on twice. */
  private readonly put = (event: MouseEvent): void => {
    const spot = this.spotOf(event);
    for (const side of sidesDrawn(this.sheet)) {
      const gap = gapAt(this.sheet, side, spot, NEAR);
      if (gap === null) continue;
      this.tell(addKnot(this.sheet, side, gap), true);
      return;
    }
  };

  private tell(sheet: Sheet, settled: boolean): void {
    this.dispatchEvent(new SheetEvent(sheet, settled));
  }

  static override readonly styles = [
    base,
    handleStyles,
    css`
      :host {
        display: block;
      }
      .sheet {
        position: relative;
        /* All of it is seen at once, with what stands above and below it in a dialogue. */
        width: min(100%, max(10.5rem, 86dvh - 13.5rem));
        aspect-ratio: 1;
        margin: 0 auto;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
        overflow: hidden;
      }
      canvas {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      svg {
        position: absolute;
        inset: 0;
        display: block;
        width: 100%;
        height: 100%;
        touch-action: none;
        user-select: none;
        cursor: crosshair;
        outline-offset: -4px;
      }
      path,
      .axis,
      .hoop {
        fill: none;
        pointer-events: none;
      }
      .axis {
        stroke: var(--edge);
        stroke-dasharray: 7 4 1.5 4;
      }
      .ghost {
        stroke: var(--edge);
        stroke-width: 1.2;
      }
      .line {
        stroke: var(--accent);
        stroke-width: 5;
        stroke-linejoin: round;
        stroke-linecap: round;
        opacity: 0.4;
      }
      .alike {
        stroke: var(--accent);
        stroke-width: 2;
        stroke-dasharray: 3 4;
        opacity: 0.7;
      }
      .stroke {
        stroke: var(--accent);
        stroke-width: 3;
        stroke-linejoin: round;
        stroke-linecap: round;
      }
      .fitted {
        stroke: var(--ink);
        stroke-width: 1.8;
      }
      .hoop {
        stroke: var(--ink);
        stroke-width: 1;
        opacity: 0.35;
      }
      .axle .knob {
        fill: var(--soft);
        stroke: none;
      }
    `,
  ];
}

/** What a point is called: of two sides with the name of its own. */
export function pointName(sheet: Sheet, side: Side, index: number): string {
  return sheet.left === null ? words.point(index + 1) : words.pointOn(index + 1, words.sides[side]);
}

/** What a key other than an arrow does to a point. */
function edited(sheet: Sheet, side: Side, index: number, key: string): Sheet | null {
  switch (key) {
    case "+":
    case "=":
      return addKnot(sheet, side, Math.min(index, knotsOn(sheet, side).length - 2));
    case "Delete":
    case "Backspace":
      return removeKnot(sheet, side, index);
    case "s":
    case "S":
      return sharpenKnot(sheet, side, index, !(knotsOn(sheet, side)[index]?.sharp ?? false));
    default:
      return null;
  }
}

/** What is said of a point of a line that was another one before a key. */
function changeOf(before: readonly Knot[], after: readonly Knot[], index: number): (reading: string) => string {
  const all = after.length;
  if (all > before.length) return (reading) => words.added(all, reading);
  if (all < before.length) return (reading) => words.removed(all, reading);
  if (after === before) return () => words.fewest;
  const [was, is] = [before[index]?.sharp ?? false, after[index]?.sharp ?? false];
  if (was === is) return (reading) => reading;
  return is ? words.sharpened : words.smoothed;
}

function inSheet(value: number): number {
  return Math.min(SHEET, Math.max(0, value));
}

function within(axis: number, by: number): number {
  return inSheet(axis + by);
}

function pathOf(line: readonly Spot[]): string {
  return line.map(({ x, y }, i) => `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-drawing-board": PasuDrawingBoard;
  }
}
