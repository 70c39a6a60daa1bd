/** The section of the pot through its axis, with the four boundary data as handles to drag or to move by arrow keys. */

import { css, html, nothing, svg } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { curveUnder, pointOn } from "../../document/curves";
import { unitOf } from "../../document/look";
import { isFree, sharesHandles } from "../../document/profile";
import { nearestOn, type RingHandle, ringHandles } from "../../document/ring-handles";
import type { End, Handle, HandleId, Shape, Unit } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import type { Section } from "../../solver/messages";
import { removeRing } from "../../state/ring-actions";
import { dragHandle } from "../../state/shape-actions";
import { arrowOf, handleStyles, reachOf } from "../../ui/handles";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";
import { profile } from "../../words/english/profile";
import { spokenLength } from "../../words/quantities";
import { CommandEvent } from "../command";

const WIDTH = 360;
const HEIGHT = 400;
const MARGIN = 40;
/** How much of a slope is drawn: the arrow is `X_u` shortened to this. */
const SLOPE_SHARE = 0.2;
/** A finger's reach round a handle; handles that stand close share what is between them. */
const REACH = 22;
const LEAST_REACH = 9;
const DUST = 1e-9;
/** A double click within this of the wall puts a ring there, in the units of the drawing. */
const NEAR_WALL = 24;

/** What is dragged: a datum of an end, or a ring between the ends. */
type Grip = Handle | RingHandle;

interface Point {
  readonly x: number;
  readonly z: number;
}

interface Marks {
  readonly rim: Point;
  readonly foot: Point;
  /** Tips of the slopes, into the wall from either end. */
  readonly rimTip: Point;
  readonly footTip: Point;
}

interface Frame {
  readonly x: number;
  readonly z: number;
  readonly scale: number;
}

@customElement("pasu-profile")
export class PasuProfile extends DesignerElement {
  /** The frame stands still under the hand. */
  @state() private held: Frame | null = null;
  private spoken = "";
  @query("svg") private readonly picture!: SVGSVGElement;
  /** What is under the hand, as it was when it was grabbed: its steps are good for the whole drag. */
  private last: { readonly handle: Grip; readonly rim: End; readonly x: number; readonly y: number } | null = null;

  override render() {
    const { designer } = this;
    const { design, part } = designer.state;
    const shape = design.parts[part]?.shape;
    const shown = designer.surface.shown?.design.parts[part]?.shape;
    const section = designer.surface.shown?.solved.section;
    if (shape?.kind === "vertex-frame") return html`<p class="lead">${profile.network}</p>`;
    if (shape?.kind === "blend") return html`<p class="lead">${profile.blend}</p>`;
    if (shape?.kind === "octant") return html`<p class="lead">${profile.octant}</p>`;
    if (!shape || !shown || !section) return html`<p class="lead">${profile.coming}</p>`;
    const all = section.handles.list;
    const marks = marksOf(section);
    // Of a pot that is not the one on the screen, and cannot be shown, there is nothing to drag.
    const rings = sharesHandles(shown, shape) ? ringHandles(shown) : [];
    const moving: readonly Grip[] = sharesHandles(shown, shape) ? [...all.filter(isFree), ...rings] : [];
    const spots = moving.map((handle) => spotOf(handle, marks, shown));
    const frame = this.held ?? frameOf(section, spots);
    const unit = unitOf(design);
    return html`
      <p class="lead">${profile.lead}${shape.kind === "rings" ? html` ${profile.rings}` : nothing}</p>
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label=${profile.section} @dblclick=${(event: MouseEvent) => this.put(event, section, frame)}>
        ${this.drawing(section, frame)}
        ${this.slope(frame, marks.rim, marks.rimTip)} ${this.slope(frame, marks.foot, marks.footTip)}
        ${moving.map((handle, index) => this.handle(handle, index, spots, section, frame))}
      </svg>
      <p class="spoken" role="status">${this.spoken}</p>
      <button class="button outlined" type="button" @click=${() => this.dispatchEvent(new CommandEvent("redraw"))}>
        ${icon("paper")}<span>${profile.draw}</span>
      </button>
      <dl>
        ${all.map(
          (handle) => html`<div>
            <dt>${profile.handles[handle.id]}</dt>
            <dd>
              ${reading(handle.id, section, unit)}
              ${handle.restraints.length === 0 ? nothing : html`<span class="why">${whyHeld(handle.restraints)}</span>`}
            </dd>
          </div>`,
        )}
        ${rings.map(
          (handle) => html`<div>
            <dt>${profile.ring(handle.index)}</dt>
            <dd>${pointWords(spotOf(handle, marks, shown), section, unit)}</dd>
          </div>`,
        )}
      </dl>
    `;
  }

  private drawing(section: Section, frame: Frame) {
    const right = pathOf(section.right, frame);
    const left = pathOf(section.left, frame);
    const axis = toView({ x: 0, z: 0 }, frame).x;
    return svg`
      <line class="axis" x1=${axis} y1="0" x2=${axis} y2=${HEIGHT} />
      <path class="inside" d=${outlineOf(section, frame)} />
      <path class="wall" d=${left} />
      <path class="wall" d=${right} />
    `;
  }

  private slope(frame: Frame, from: Point, tip: Point) {
    const a = toView(from, frame);
    const b = toView(tip, frame);
    return svg`<line class="slope" x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`;
  }

  private handle(handle: Grip, index: number, spots: readonly Point[], section: Section, frame: Frame) {
    const at = toView(spots[index] ?? { x: 0, z: 0 }, frame);
    const ways = handle.axial.length === 0 ? "across" : handle.radial.length === 0 ? "along" : "move";
    const slope = handle.id.endsWith("slope");
    const { rim } = section.handles;
    const name = isRing(handle) ? profile.ring(handle.index) : profile.handles[handle.id];
    const others = spots.filter((_, other) => other !== index).map((spot) => toView(spot, frame));
    return svg`<g
      class="handle ${ways}"
      tabindex="0"
      role="button"
      aria-roledescription=${profile.handle}
      aria-label=${profile.named(name, profile.ways[ways])}
      data-handle=${handle.id}
      transform="translate(${at.x} ${at.y})"
      @pointerdown=${(event: PointerEvent) => this.grab(event, handle, rim, frame)}
      @pointermove=${this.drag}
      @pointerup=${this.drop}
      @pointercancel=${this.drop}
      @keydown=${(event: KeyboardEvent) => this.key(event, handle, rim, frame)}
      @keyup=${() => this.designer.store.endGesture()}
      @blur=${() => this.designer.store.endGesture()}
    >
      <circle class="reach" r=${reachOf(at, others, LEAST_REACH, REACH)} />
      <circle class="ring" r="13" />
      ${slope ? svg`<rect class="knob" x="-5.5" y="-5.5" width="11" height="11" rx="2" transform="rotate(45)" />` : svg`<circle class="knob" r="7.5" />`}
    </g>`;
  }

  private grab(event: PointerEvent, handle: Grip, rim: End, frame: Frame): void {
    if (event.button !== 0) return;
    event.preventDefault();
    const target = event.currentTarget as SVGGElement;
    target.setPointerCapture(event.pointerId);
    target.focus({ preventScroll: true });
    this.held = frame;
    this.last = { handle, rim, x: event.clientX, y: event.clientY };
  }

  private readonly drag = (event: PointerEvent): void => {
    const { last, held } = this;
    if (!last || !held) return;
    const pixels = this.picture.getBoundingClientRect().width / WIDTH;
    const scale = pixels * held.scale;
    this.move(last.handle, last.rim, (event.clientX - last.x) / scale, (last.y - event.clientY) / scale);
    this.last = { ...last, x: event.clientX, y: event.clientY };
  };

  private readonly drop = (): void => {
    this.last = null;
    this.held = null;
    this.designer.store.endGesture();
  };

  /** Moves a handle by a distance in the section. */
  private move(handle: Grip, rim: End, x: number, z: number): void {
    const slope = !isRing(handle) && handle.id.endsWith("slope");
    const factor = slope ? towards(handle.id, rim) / SLOPE_SHARE : 1;
    this.designer.apply(dragHandle(this.designer.state, handle, factor * x, factor * z));
  }

  private key(event: KeyboardEvent, handle: Grip, rim: End, frame: Frame): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.ringKey(event.key, handle)) {
      event.preventDefault();
      return;
    }
    const arrow = arrowOf(event);
    if (!arrow) return;
    event.preventDefault();
    const pixel = 1 / frame.scale;
    const step = 10 ** Math.floor(Math.log10(3 * pixel));
    this.move(handle, rim, arrow.right * step, arrow.up * step);
  }

  /** Plus puts a ring above, Delete takes one away; whether the key meant that. */
  private ringKey(key: string, handle: Grip): boolean {
    const { designer } = this;
    const shape = designer.state.design.parts[designer.state.part]?.shape;
    if (shape?.kind !== "rings") return false;
    const last = shape.rings.length - 1;
    const index = isRing(handle) ? handle.index : handle.id === "foot" ? 0 : last;
    if (key === "+" || key === "=") {
      const above = Math.min(index, last - 1);
      void this.add(((shape.rings[above]?.u ?? 0) + (shape.rings[above + 1]?.u ?? 1)) / 2);
    } else if (key === "Delete" || key === "Backspace") designer.apply(removeRing(designer.state, index));
    else return false;
    return true;
  }

  /** Puts a ring where the wall is clicked on twice. */
  private put(event: MouseEvent, section: Section, frame: Frame): void {
    const box = this.picture.getBoundingClientRect();
    const pixels = box.width / WIDTH;
    const x = frame.x + ((event.clientX - box.left) / pixels - WIDTH / 2) / frame.scale;
    const z = frame.z - ((event.clientY - box.top) / pixels - HEIGHT / 2) / frame.scale;
    const { u, away } = [section.right, section.left]
      .map((line) => nearestOn(line, x, z))
      .reduce((best, each) => (each.away < best.away ? each : best));
    if (away * frame.scale < NEAR_WALL) void this.add(u);
  }

  private async add(u: number): Promise<void> {
    const { designer } = this;
    const { design, part, ids } = designer.state;
    const shape = design.parts[part]?.shape;
    const id = ids[part];
    if (shape?.kind !== "rings" || id === undefined || curveUnder(shape, u)) return;
    await (await designer.openPull())?.putRing(id, Number(u.toPrecision(3)));
  }

  /** What a screen reader says after a key moved the handle that has the focus. */
  override willUpdate(): void {
    const section = this.designer.surface.shown?.solved.section;
    const active = this.shadowRoot?.activeElement?.getAttribute("data-handle");
    if (!section || !active || this.last) return;
    const { design, part } = this.designer.state;
    const shown = this.designer.surface.shown?.design.parts[part]?.shape;
    const ring = shown && ringHandles(shown).find(({ id }) => id === active);
    const unit = unitOf(design);
    this.spoken = ring
      ? pointWords(ringPoint(shown, ring), section, unit)
      : active in profile.handles
        ? reading(active as HandleId, section, unit)
        : "";
  }

  static override readonly styles = [
    base,
    buttons,
    handleStyles,
    css`
      :host {
        display: block;
      }
      .lead {
        color: var(--soft);
        padding-bottom: 10px;
        text-wrap: pretty;
      }
      svg[role] {
        display: block;
        width: 100%;
        max-width: 460px;
        margin: 0 auto;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
        touch-action: pan-y;
        user-select: none;
        overflow: hidden;
      }
      .axis {
        stroke: var(--edge);
        stroke-dasharray: 7 4 1.5 4;
      }
      .inside {
        fill: var(--accent-wash);
      }
      .wall {
        fill: none;
        stroke: var(--ink);
        stroke-width: 2.4;
        stroke-linejoin: round;
        stroke-linecap: round;
      }
      .slope {
        stroke: var(--accent);
        stroke-width: 1.6;
        stroke-dasharray: 4 3;
      }
      .handle {
        touch-action: none;
      }
      .button {
        margin-top: 12px;
      }
      dl {
        display: grid;
        gap: 8px;
        margin: 14px 0 0;
      }
      dl div {
        display: grid;
        grid-template-columns: 118px 1fr;
        gap: 10px;
      }
      dt {
        font-weight: 600;
        font-size: 0.92rem;
      }
      dd {
        margin: 0;
        font-size: 0.92rem;
        font-variant-numeric: tabular-nums;
      }
      .why {
        display: block;
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
    `,
  ];
}

/** The `u` of the end that a handle belongs to. */
function endAt(id: HandleId, rim: End): 0 | 1 {
  return id.startsWith("rim") === (rim === "start") ? 0 : 1;
}

/** From either end into the wall: along `u` at `u = 0`, against it at `u = 1`. */
function towards(id: HandleId, rim: End): 1 | -1 {
  return endAt(id, rim) === 0 ? 1 : -1;
}

function endOf(section: Section, end: number): Point {
  const i = end === 0 ? 0 : section.right.length - 2;
  return { x: section.right[i] ?? 0, z: section.right[i + 1] ?? 0 };
}

function slopeOf(section: Section, end: number): Point {
  return { x: section.slopes[2 * end] ?? 0, z: section.slopes[2 * end + 1] ?? 0 };
}

function marksOf(section: Section): Marks {
  const tip = (end: number): Point => {
    const at = endOf(section, end);
    const slope = slopeOf(section, end);
    const share = end === 0 ? SLOPE_SHARE : -SLOPE_SHARE;
    return { x: at.x + share * slope.x, z: at.z + share * slope.z };
  };
  const rim = endAt("rim", section.handles.rim);
  return { rim: endOf(section, rim), foot: endOf(section, 1 - rim), rimTip: tip(rim), footTip: tip(1 - rim) };
}

function pointOf(id: HandleId, marks: Marks): Point {
  switch (id) {
    case "rim":
      return marks.rim;
    case "foot":
      return marks.foot;
    case "rim-slope":
      return marks.rimTip;
    case "foot-slope":
      return marks.footTip;
  }
}

function isRing(handle: Grip): handle is RingHandle {
  return "index" in handle;
}

function spotOf(handle: Grip, marks: Marks, shown: Shape): Point {
  return isRing(handle) ? ringPoint(shown, handle) : pointOf(handle.id, marks);
}

/** Where a ring is on the right of the section. */
function ringPoint(shape: Shape, { index }: RingHandle): Point {
  const [x, , z] = pointOn(shape, index, 0) ?? [0, 0, 0];
  return { x, z };
}

function pointWords({ x, z }: Point, section: Section, unit: Unit): string {
  const size = Math.hypot(...section.slopes);
  const number = (value: number) => spokenLength(Math.abs(value) < DUST * size ? 0 : value, unit);
  return profile.point(number(x), number(z));
}

function reading(id: HandleId, section: Section, unit: Unit): string {
  const end = endAt(id, section.handles.rim);
  const slope = id.endsWith("slope");
  const { x, z } = slope ? slopeOf(section, end) : endOf(section, end);
  const size = Math.hypot(...section.slopes);
  // What is nothing beside the pot is dust of the arithmetic.
  const number = (value: number) => spokenLength(Math.abs(value) < DUST * size ? 0 : value, unit);
  return slope ? profile.slope(number(x), number(z)) : profile.point(number(x), number(z));
}

/** Why a handle does not move, or moves one way only. */
function whyHeld(restraints: Handle["restraints"]): string {
  return profile.sentences(restraints.map((restraint) => profile.restraints[restraint]));
}

/** Room for the section, the handles and some air, with the axis where the pot is. */
function frameOf(section: Section, marks: readonly Point[]): Frame {
  let [left, right, low, high] = [0, 0, Infinity, -Infinity];
  const take = (x: number, z: number) => {
    left = Math.min(left, x);
    right = Math.max(right, x);
    low = Math.min(low, z);
    high = Math.max(high, z);
  };
  for (const line of [section.right, section.left]) {
    for (let i = 0; i + 1 < line.length; i += 2) take(line[i] ?? 0, line[i + 1] ?? 0);
  }
  for (const mark of marks) take(mark.x, mark.z);
  const width = Math.max(right - left, 1e-9);
  const height = Math.max(high - low, 1e-9);
  const scale = Math.min((WIDTH - 2 * MARGIN) / width, (HEIGHT - 2 * MARGIN) / height);
  return { x: (left + right) / 2, z: (low + high) / 2, scale };
}

function toView(point: Point, frame: Frame): { readonly x: number; readonly y: number } {
  const round = (value: number) => Math.round(100 * value) / 100;
  return {
    x: round(WIDTH / 2 + frame.scale * (point.x - frame.x)),
    y: round(HEIGHT / 2 - frame.scale * (point.z - frame.z)),
  };
}

function pathOf(line: Float64Array, frame: Frame): string {
  const steps: string[] = [];
  for (let i = 0; i + 1 < line.length; i += 2) {
    const { x, y } = toView({ x: line[i] ?? 0, z: line[i + 1] ?? 0 }, frame);
    steps.push(`${i === 0 ? "M" : "L"}${x} ${y}`);
  }
  return steps.join("");
}

/** Down one wall and up the other. */
function outlineOf(section: Section, frame: Frame): string {
  const up: number[] = [];
  for (let i = section.left.length - 2; i >= 0; i -= 2) up.push(section.left[i] ?? 0, section.left[i + 1] ?? 0);
  return `${pathOf(section.right, frame)}${pathOf(new Float64Array(up), frame).replace("M", "L")}Z`;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-profile": PasuProfile;
  }
}
