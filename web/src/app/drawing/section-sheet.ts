/** The sheet that a section is drawn on, from above: one stroke goes round it. */

import { css, html, LitElement, nothing, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Spot } from "../../document/drawn/knot";
import { base } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";

/** The side of the sheet, in its own units. */
export const SECTION_SHEET = 480;

/** A stroke came to its end. */
export class OutlineEvent extends Event {
  readonly line: readonly Spot[];
  constructor(line: readonly Spot[]) {
    super("outline-drawn");
    this.line = line;
  }
}

@customElement("pasu-section-sheet")
export class PasuSectionSheet extends LitElement {
  /** What was drawn, and what was made of it. */
  @property({ attribute: false }) line: readonly Spot[] = [];
  @property({ attribute: false }) curve: readonly Spot[] = [];
  /** The section as it is, to go by. */
  @property({ attribute: false }) ghost: readonly Spot[] = [];
  @state() private stroke: readonly Spot[] | null = null;
  @query("svg") private readonly picture!: SVGSVGElement;
  private pointer: number | null = null;

  override render() {
    const middle = SECTION_SHEET / 2;
    return html`<svg
      viewBox="0 0 ${SECTION_SHEET} ${SECTION_SHEET}"
      role="img"
      aria-label=${words.sheet}
      @pointerdown=${this.begin}
      @pointermove=${this.draw}
      @pointerup=${this.end}
      @pointercancel=${this.cancel}
      @lostpointercapture=${this.end}
    >
      <path class="axes" d="M${middle} 0v${SECTION_SHEET}M0 ${middle}h${SECTION_SHEET}" />
      ${this.ghost.length > 0 ? svg`<path class="ghost" d=${`${pathOf(this.ghost)}Z`} />` : nothing}
      ${this.stroke ? svg`<path class="stroke" d=${pathOf(this.stroke)} />` : nothing}
      ${!this.stroke && this.line.length > 0 ? svg`<path class="line" d=${`${pathOf(this.line)}Z`} />` : nothing}
      ${!this.stroke && this.curve.length > 0 ? svg`<path class="curve" d=${`${pathOf(this.curve)}Z`} />` : nothing}
    </svg>`;
  }

  private spotOf({ clientX, clientY }: MouseEvent): Spot {
    const { left, top, width } = this.picture.getBoundingClientRect();
    const scale = SECTION_SHEET / width;
    const within = (value: number) => Math.min(SECTION_SHEET, Math.max(0, value));
    return { x: within((clientX - left) * scale), y: within((clientY - top) * scale) };
  }

  private readonly begin = (event: PointerEvent): void => {
    if (event.button !== 0 || this.pointer !== null) return;
    event.preventDefault();
    this.pointer = event.pointerId;
    this.picture.setPointerCapture(event.pointerId);
    this.stroke = [this.spotOf(event)];
  };

  private readonly draw = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer || !this.stroke) return;
    // Some browsers have none where one was made by a program.
    const all = event.getCoalescedEvents?.() ?? [];
    this.stroke = [...this.stroke, ...(all.length > 0 ? all : [event]).map((each) => this.spotOf(each))];
  };

  private readonly end = (event: PointerEvent): void => {
    const { stroke } = this;
    if (event.pointerId !== this.pointer || !stroke) return;
    this.pointer = null;
    this.stroke = null;
    // A press that goes nowhere is none.
    if (stroke.length > 2) this.dispatchEvent(new OutlineEvent(stroke));
  };

  private readonly cancel = (): void => {
    this.pointer = null;
    this.stroke = null;
  };

  static override readonly styles = [
    base,
    css`
      :host {
        display: block;
        width: min(100%, max(10.5rem, 70dvh - 9rem));
        margin: 0 auto;
      }
      svg {
        display: block;
        width: 100%;
        aspect-ratio: 1;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
        touch-action: none;
        user-select: none;
        cursor: crosshair;
      }
      path {
        fill: none;
        stroke-linejoin: round;
        stroke-linecap: round;
        pointer-events: none;
      }
      .axes {
        stroke: var(--line);
        stroke-dasharray: 7 4 1.5 4;
      }
      .ghost {
        stroke: var(--edge);
        stroke-width: 1.2;
        stroke-dasharray: 4 4;
      }
      .line {
        stroke: var(--accent);
        stroke-width: 5;
        opacity: 0.4;
      }
      .stroke {
        stroke: var(--accent);
        stroke-width: 3;
      }
      .curve {
        stroke: var(--ink);
        stroke-width: 1.8;
      }
    `,
  ];
}

function pathOf(line: readonly Spot[]): string {
  return line.map(({ x, y }, i) => `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-section-sheet": PasuSectionSheet;
  }
}
