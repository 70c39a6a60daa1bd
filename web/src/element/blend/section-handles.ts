/** What lies over the stage while the tool that pulls is taken up and the selected part is a blend: handles for both sections and their tangents, for pointers and keys. */

import { css, html, nothing, svg } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { type Grip, gripNumbers, gripped, gripsOf } from "../../document/blend/grips";
import { borderOf, ENDS, type End, sizeFactor } from "../../document/blend/section";
import { SECTION } from "../../document/blend/tables.gen";
import { unitOf } from "../../document/look";
import type { Blend, Section, Triple } from "../../document/types";
import { besideCover } from "../../render/overlay/cover";
import { Hand } from "../../render/pull/hand";
import type { See, Spot } from "../../render/pull/reach";
import type { Stage } from "../../render/stage";
import { changeSection } from "../../state/blend-actions";
import { ARROWS } from "../../ui/arrows";
import { gripStyles } from "../../ui/grip";
import { base } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { pull } from "../../words/english/pull";
import { spokenLength } from "../../words/quantities";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";
import { followed } from "./grip-pull";

interface Held {
  readonly pointer: number;
  readonly grip: Grip;
  readonly section: Section;
  readonly see: See;
  readonly from: Spot;
}

const COARSE = 10;
const TURN = 1;
/** Every so many of the points of a border are enough to be drawn over the stage. */
const EVERY = 3;

@customElement("pasu-section-handles")
export class PasuSectionHandles extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @state() private spoken = "";
  private readonly lent = new Lent(
    this,
    (bench) => new Hand(bench),
    (tool) => {
      tool.onFrame = () => this.follow();
    },
  );
  private held: Held | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.escape, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.escape, { capture: true });
    if (this.held) this.designer.store.endGesture();
    this.held = null;
  }

  override render() {
    const { blend } = this;
    if (!blend) return nothing;
    return html`
      <svg aria-hidden="true">
        ${ENDS.map((end) => svg`<path class="border" data-end=${end} /><path class="tangent" data-end=${end} />`)}
      </svg>
      <div class="handles" role="group" aria-label=${words.handles} aria-describedby="keys">
        ${gripsOf(blend).map((grip) => this.handle(blend, grip))}
      </div>
      <p id="keys" class="spoken">${words.handleKeys}</p>
      <p class="spoken" role="status">${this.spoken}</p>
    `;
  }

  override updated(): void {
    this.follow();
  }

  private get blend(): Blend | null {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    return shape?.kind === "blend" ? shape : null;
  }

  private handle(blend: Blend, grip: Grip) {
    const reading = this.reading(blend, grip);
    return html`<button
      type="button"
      class="grip ${grip.name}"
      data-grip="${grip.end} ${grip.name}"
      aria-roledescription=${pull.handle}
      aria-label=${reading}
      title=${reading}
      @pointerdown=${(event: PointerEvent) => this.take(event, grip)}
      @pointermove=${this.move}
      @pointerup=${this.release}
      @pointercancel=${this.release}
      @lostpointercapture=${this.release}
      @keydown=${(event: KeyboardEvent) => this.key(event, grip)}
      @keyup=${() => this.designer.store.endGesture()}
      @blur=${() => this.designer.store.endGesture()}
    ></button>`;
  }

  private reading(blend: Blend, { end, name }: Grip): string {
    const unit = unitOf(this.designer.store.design);
    const [first = 0, second = 0] = gripNumbers(blend[end], name);
    const at =
      name === "turn"
        ? words.degrees(first)
        : name === "tangent"
          ? words.leaves(first, spokenLength(second, unit))
          : spokenLength(first, unit);
    return words.grip(words.grips[name], nameOf(blend, end), at);
  }

  // Pointers

  private take(event: PointerEvent, grip: Grip): void {
    const see = this.lent.tool?.sight(this.designer.store.part);
    const { blend } = this;
    if (!see || !blend || event.button !== 0 || this.held) return;
    event.preventDefault();
    const target = event.currentTarget as HTMLElement;
    target.setPointerCapture(event.pointerId);
    target.focus({ preventScroll: true });
    const from = { x: event.clientX, y: event.clientY };
    this.held = { pointer: event.pointerId, grip, section: blend[grip.end], see, from };
  }

  private readonly move = (event: PointerEvent): void => {
    const { held } = this;
    if (held?.pointer !== event.pointerId) return;
    const { grip, section, see, from } = held;
    const by = { x: event.clientX - from.x, y: event.clientY - from.y };
    const amounts = followed(see, grip.at, grip.along, by);
    this.change(grip, () => gripped(section, grip.name, amounts));
  };

  private readonly release = (event: PointerEvent): void => {
    if (this.held?.pointer !== event.pointerId) return;
    this.held = null;
    this.designer.store.endGesture();
  };

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.held) return;
    event.preventDefault();
    event.stopPropagation();
    this.held = null;
    this.designer.store.cancelGesture();
  };

  // Keys

  private key(event: KeyboardEvent, grip: Grip): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    const { blend } = this;
    if (!arrow || !blend) return;
    event.preventDefault();
    event.stopPropagation();
    const times = event.shiftKey ? COARSE : 1;
    const [right, up] = arrow;
    const amounts =
      grip.name === "tangent"
        ? [times * right * stepOf(blend, "taper"), times * up * stepOf(blend, "dz")]
        : [
            times *
              (right + up) *
              (grip.name === "turn" ? TURN : stepOf(blend, grip.name === "height" ? "z" : "radius-0")),
          ];
    this.change(grip, (section) => gripped(section, grip.name, amounts));
    const now = this.blend;
    if (now) this.spoken = this.reading(now, grip);
  }

  private change(grip: Grip, edit: (section: Section) => Section): void {
    this.designer.apply(changeSection(this.designer.state, grip.end, edit, `grip ${grip.name}`));
  }

  /** Moves the handles to where their sections are seen. */
  private follow(): void {
    const { blend } = this;
    const { tool: hand } = this.lent;
    if (!hand || !blend) return;
    const see = hand.sight(this.designer.store.part);
    const grips = gripsOf(blend);
    for (const grip of grips) {
      const handle = this.renderRoot.querySelector<HTMLElement>(`[data-grip="${grip.end} ${grip.name}"]`);
      const at = see?.(grip.at);
      const spot = at && see && this.clear(at, grip, grips, see);
      if (!handle) continue;
      handle.hidden = !spot;
      if (spot) handle.style.setProperty("transform", `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`);
      const from = grip.from && see?.(grip.from);
      if (from && spot) this.draw("tangent", grip.end, [from, spot], "");
    }
    for (const end of ENDS) {
      const { z } = blend[end];
      const border = borderOf(blend[end]);
      const points = border.filter((_, at) => border.length < 2 * EVERY || at % EVERY === 0);
      const spots = points.flatMap(([x, y]) => see?.([x, y, z] as Triple) ?? []);
      this.draw("border", end, spots, "Z");
    }
  }

  /** Where a handle can be taken hold of: nearer to what it stands on, or to the middle of the stage. */
  private clear(spot: Spot, { end, from }: Grip, grips: readonly Grip[], see: See): Spot {
    const cover = this.stage?.cover;
    if (!cover) return spot;
    const base = from ?? grips.find((grip) => grip.end === end && grip.name === "height")?.at;
    const stood = base && see(base);
    const middle = { x: cover.width / 2, y: cover.height / 2 };
    return besideCover(spot, stood ? [stood, middle] : [middle], cover);
  }

  private draw(what: string, end: End, spots: readonly Spot[], close: string): void {
    const path = spots.map(({ x, y }, at) => `${at === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
    this.renderRoot
      .querySelector(`path.${what}[data-end="${end}"]`)
      ?.setAttribute("d", path === "" ? "" : path + close);
  }

  static override readonly styles = [
    base,
    gripStyles,
    css`
      :host {
        position: absolute;
        z-index: 1;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
      }
      svg {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      path {
        fill: none;
        stroke: var(--accent);
        stroke-width: 1.6;
        stroke-linejoin: round;
      }
      .border {
        stroke-dasharray: 5 4;
      }
      .handles {
        position: absolute;
        inset: 0;
      }
      .height::before {
        border-radius: 2px;
      }
      .turn::before {
        border-style: double;
        border-width: 5px;
      }
      .tangent::before {
        background: var(--accent);
      }
      .grip:active {
        cursor: grabbing;
      }
    `,
  ];
}

/** The upper or the lower one. */
function nameOf(blend: Blend, end: End): string {
  const upper: End = blend.start.z > blend.end.z ? "start" : "end";
  return end === upper ? words.upper : words.lower;
}

function stepOf(blend: Blend, key: (typeof SECTION)[number]["key"]): number {
  const field = SECTION.find((each) => each.key === key);
  return (field?.step ?? 1) * (field?.dimension === "length" ? sizeFactor(blend) : 1);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-section-handles": PasuSectionHandles;
  }
}
