/** What lies over the stage while the tool that pulls is taken up: pointers pull at what is under them, and every ring of the selected part is a handle for pointers and keys. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { bumpOf, squeezing, takesRings, widened } from "../../document/brush";
import { type Curve, curveUnder, gripsOf, pointOn, spanOf } from "../../document/curves";
import { unitOf } from "../../document/look";
import type { Pair, Shape, Triple } from "../../document/types";
import { besideCover } from "../../render/overlay/cover";
import { type Felt, Hand } from "../../render/pull/hand";
import { type Direction, reached, type See } from "../../render/pull/reach";
import type { Stage } from "../../render/stage";
import { removeRing } from "../../state/ring-actions";
import { selectParts } from "../../state/seen-actions";
import { gripStyles } from "../../ui/grip";
import { base } from "../../ui/styles";
import { pull as words } from "../../words/english/pull";
import { spokenLength } from "../../words/quantities";
import type { Pull } from "../../work/pull";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";
import "./pull-bar";
import { curveName } from "./curve-name";
import { type Modifier, type Point, PullGesture } from "./pull-gesture";
import { ringStep } from "./ring-keys";

/** A point of a ring is that one to so many places along the profile: what a hand begins needs no more, and links stay short. */
const PLACES = 1000;
/** And round the axis to a degree. */
const ROUND = 360;

/** What is under the pointer, or was when it took hold. */
interface Hold {
  readonly felt: Felt;
  readonly see: See;
  readonly point: Triple;
  readonly size: number;
  /** Whether two fingers hold it. */
  readonly pinched: boolean;
}

@customElement("pasu-pull")
export class PasuPull extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @state() private pull: Pull | null = null;
  @state() private spoken = "";
  private opening = false;
  @query(".surface") private readonly surface!: HTMLElement;
  private readonly lent = new Lent(
    this,
    (bench) => new Hand(bench),
    (tool) => {
      tool.onFrame = () => this.follow();
    },
  );
  private hold: Hold | null = null;
  private over: Felt | null = null;
  /** Where the pointer is that holds nothing: felt once a frame. */
  private pointer: Point | null = null;
  private feeling = 0;
  /** How far keys have moved the ring since the first was pressed. */
  private keyed = { out: 0, up: 0, round: 0 };
  private readonly gesture = new PullGesture({
    take: (at) => this.take(this.feel(at)),
    pull: (by, modifier) => this.move(by, modifier),
    pinch: (one, other) => this.pinch(one, other),
    squeeze: (by) => this.squeeze(by),
    release: () => this.release(),
    cancel: () => this.cancel(),
    hover: (at) => this.hover(at),
    turn: (dx, dy) => this.stage?.turnByPixels(dx, dy),
    pan: (dx, dy) => this.stage?.pan(dx, dy),
    zoom: (factor) => this.stage?.zoom(factor),
    widen: (notches) => this.widen(notches),
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
    this.pull?.cancel();
    this.hold = null;
  }

  override willUpdate(): void {
    // Not before the designer is there, which a component that is fetched late is given last.
    if (!this.opening) {
      this.opening = true;
      void this.designer.openPull().then((pull) => {
        this.pull = pull;
      });
    }
  }

  override render() {
    const { shape, curves } = this;
    return html`
      <div
        class="surface"
        @pointerdown=${this.gesture.down}
        @pointermove=${this.gesture.move}
        @pointerup=${this.gesture.up}
        @pointercancel=${this.gesture.up}
        @lostpointercapture=${this.gesture.up}
        @pointerleave=${this.gesture.leave}
        @dblclick=${this.put}
        @contextmenu=${(event: Event) => event.preventDefault()}
      ></div>
      ${
        shape && curves.length > 0
          ? html`<div class="rings" role="group" aria-label=${takesRings(shape) ? words.rings : words.places} aria-describedby="keys">
              ${curves.map((curve) => this.handle(shape, curve))}
            </div>`
          : nothing
      }
      <p id="keys" class="spoken">${shape && !takesRings(shape) ? words.keysOfFamily : words.keys}</p>
      <p class="spoken" role="status">${this.spoken}</p>
    `;
  }

  override firstUpdated(): void {
    // Lit's own listeners of the wheel are passive in some browsers.
    this.addEventListener("wheel", this.gesture.wheel, { passive: false });
  }

  override updated(): void {
    // What is said of a brush or of a pot that has changed: the touch is another one.
    void this.pull?.brush;
    void this.pull?.followed;
    this.show();
    this.follow();
  }

  /** The shape of the selected part, as the document has it. */
  private get shape(): Shape | null {
    const { design, part } = this.designer.state;
    return design.parts[part]?.shape ?? null;
  }

  private get curves(): readonly Curve[] {
    return this.shape ? gripsOf(this.shape) : [];
  }

  private handle(shape: Shape, curve: Curve) {
    const name = this.nameOf(shape, curve);
    return html`<button
      type="button"
      class=${curve.end ? "grip ring end" : "grip ring"}
      data-curve=${curve.index}
      aria-roledescription=${words.handle}
      aria-label=${this.reading(shape, curve, name)}
      title=${name}
      @pointerdown=${(event: PointerEvent) => this.gesture.hold(event, () => this.take(this.feltOf(curve)))}
      @pointermove=${this.gesture.move}
      @pointerup=${this.gesture.up}
      @pointercancel=${this.gesture.up}
      @lostpointercapture=${this.gesture.up}
      @pointerenter=${() => this.touchCurve(curve)}
      @pointerleave=${() => this.touch(null)}
      @focus=${() => {
        this.touchCurve(curve);
        if (!takesRings(shape)) void this.say(shape, curve);
      }}
      @blur=${this.blurred}
      @keydown=${(event: KeyboardEvent) => this.key(event, curve)}
      @keyup=${this.keyUp}
    ></button>`;
  }

  private nameOf(shape: Shape, curve: Curve): string {
    return curveName(shape, curve, this.designer.surface.shown?.solved.section?.handles.rim ?? null);
  }

  /** Where the hand takes hold there, before placement. */
  private gripOf(shape: Shape, curve: Curve): Triple | null {
    const felt = this.feltOf(curve);
    if (!takesRings(shape)) return (felt && this.lent.tool?.pointOf(felt)) ?? null;
    return felt && pointOn(shape, curve.index, spanOf(shape) * felt.v);
  }

  private reading(shape: Shape, curve: Curve, name: string): string {
    const unit = unitOf(this.designer.store.design);
    const { index } = curve;
    // Where a place of a family is the solver says, and it is told when a hand comes there.
    const point = takesRings(shape) ? pointOn(shape, index, 0) : null;
    if (!point) return name;
    const radius = shape.kind === "rings" ? (shape.rings[index]?.r.mean ?? 0) : Math.hypot(point[0], point[1]);
    const height = shape.kind === "rings" ? (shape.rings[index]?.z.mean ?? 0) : point[2];
    return words.at(name, spokenLength(radius, unit), spokenLength(height, unit));
  }

  // What is under the hand

  private feel({ x, y }: Point): Felt | null {
    const { stage } = this;
    const { tool: hand } = this.lent;
    if (!hand || !stage) return null;
    const { left, top } = this.surface.getBoundingClientRect();
    const felt = hand.feel({ x: x - left, y: y - top }, (a, b) => stage.pick(a, b));
    return felt && this.snapped(felt);
  }

  /** On the ring that is near enough to be taken hold of, or at a place that takes few digits. */
  private snapped({ place, u, v }: Felt): Felt {
    const shape = this.designer.surface.shown?.design.parts[place]?.shape;
    const curve = shape && curveUnder(shape, u);
    return { place, u: curve?.u ?? Math.round(PLACES * u) / PLACES, v: Math.round(ROUND * v) / ROUND };
  }

  /** The point of a ring that is seen at the right. */
  private feltOf({ u }: Curve): Felt | null {
    return this.shape && this.atRight(this.designer.store.part, u);
  }

  /** What is seen at the right there. */
  private atRight(place: number, u: number): Felt | null {
    const { tool: hand } = this.lent;
    const matrix = hand?.matrixOf(place);
    if (!hand || !matrix) return null;
    // The direction to the right of the eye, turned back as the part is turned.
    const [x, y] = [-Math.sin(hand.azimuth), Math.cos(hand.azimuth)];
    const back = (i: number) => (matrix[4 * i] ?? 0) * x + (matrix[4 * i + 1] ?? 0) * y;
    const turn = Math.atan2(back(1), back(0)) / (2 * Math.PI);
    return { place, u, v: Math.round(ROUND * (turn - Math.floor(turn))) / ROUND };
  }

  private hover(at: Point | null): void {
    this.pointer = at;
    if (this.feeling !== 0) return;
    this.feeling = requestAnimationFrame(() => {
      this.feeling = 0;
      if (!this.gesture.pulling) this.touch(this.pointer && this.feel(this.pointer));
    });
  }

  /** What a handle stands for counts, not what is seen beneath it. */
  private touchCurve(curve: Curve): void {
    cancelAnimationFrame(this.feeling);
    this.feeling = 0;
    this.touch(this.feltOf(curve));
  }

  private touch(felt: Felt | null): void {
    this.over = felt;
    this.surface?.classList.toggle("over", felt !== null);
    this.show();
  }

  /** Shows what a pull would move, or moves. */
  private show(): void {
    const { pull, hold } = this;
    const { tool: hand } = this.lent;
    const felt = hold?.felt ?? this.over;
    const shape = felt && this.designer.store.design.parts[felt.place]?.shape;
    if (!hand || !felt || !shape || !pull) {
      hand?.show(null);
      return;
    }
    const [u, v] = (hold && pull.followed.at) ?? [felt.u, spanOf(shape) * felt.v];
    const brush = hold?.pinched ? squeezing(pull.brush) : pull.brush;
    const bump = takesRings(shape) ? bumpOf(brush) : { degree: 0, petals: 1 };
    hand.show({ place: felt.place, u, v: v / spanOf(shape), ...bump, held: hold !== null });
  }

  // Pulling

  private take(felt: Felt | null, pinched = false): boolean {
    const { pull, designer } = this;
    const { tool: hand } = this.lent;
    const see = felt && hand?.sight(felt.place);
    const point = felt && hand?.pointOf(felt);
    const part = felt && designer.store.ids[felt.place];
    const shape = felt && designer.store.design.parts[felt.place]?.shape;
    if (!felt || !pull || !see || !point || !shape || part === undefined || part === null) return false;
    if (designer.store.ids.length > 1) designer.apply(selectParts(part));
    const at: Pair = [felt.u, spanOf(shape) * felt.v];
    const size = Math.hypot(...point) || 1;
    pull.take({ part, at, size });
    this.keyed = { out: 0, up: 0, round: 0 };
    this.hold = { felt, see, point, size, pinched };
    this.surface.classList.add("held");
    this.show();
    return true;
  }

  private move(by: Point, modifier: Modifier): void {
    const { hold, pull } = this;
    if (!hold || !pull) return;
    const way: Direction = modifier ?? pull.brush.way;
    pull.move(reached(hold.see, hold.point, hold.size, by, way));
  }

  /** Between two fingers that lie side by side the pot is held at the height of their middle, at the right and at the left. */
  private pinch(one: Point, other: Point): boolean {
    if (Math.abs(one.x - other.x) <= Math.abs(one.y - other.y)) return false;
    const [a, b] = [this.feel(one), this.feel(other)];
    const middle = this.feel({ x: (one.x + other.x) / 2, y: (one.y + other.y) / 2 });
    if (!a || !b || !middle || a.place !== middle.place || b.place !== middle.place) return false;
    return this.take(this.atRight(middle.place, middle.u), true);
  }

  private squeeze(by: number): void {
    const { hold, pull } = this;
    if (hold && pull)
      pull.move(reached(hold.see, hold.point, hold.size, { x: by, y: 0 }, "out"), squeezing(pull.brush));
  }

  private release(): void {
    this.letGo();
    void this.pull?.release();
  }

  private cancel(): void {
    this.letGo();
    this.pull?.cancel();
  }

  private letGo(): void {
    this.hold = null;
    this.surface.classList.remove("held");
    this.over = null;
    this.show();
  }

  /** Puts a ring where the pot is clicked on twice. */
  private readonly put = (event: MouseEvent): void => {
    const { designer, pull } = this;
    const felt = this.feel({ x: event.clientX, y: event.clientY });
    const part = felt && designer.store.ids[felt.place];
    const shape = felt && designer.store.design.parts[felt.place]?.shape;
    if (!pull || !felt || !shape || part === undefined || part === null) return;
    if (takesRings(shape) && !curveUnder(shape, felt.u)) void pull.putRing(part, felt.u);
  };

  private widen(steps: number): void {
    const { pull } = this;
    if (pull) pull.brush = widened({ ...pull.brush, spread: "side" }, steps);
  }

  // Keys

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.hold) return;
    event.preventDefault();
    event.stopPropagation();
    this.gesture.drop();
    this.cancel();
  };

  private key(event: KeyboardEvent, curve: Curve): void {
    if (event.ctrlKey || event.metaKey) return;
    const felt = this.feltOf(curve);
    const step = ringStep(event, this.pixel(curve));
    if (step) {
      if (!this.hold) this.take(felt);
      const { keyed } = this;
      this.keyed = { out: keyed.out + step.out, up: keyed.up + step.up, round: keyed.round + step.round };
      this.pull?.move(this.keyed);
    } else if (this.shape && !takesRings(this.shape)) return;
    else if (event.key === "+" || event.key === "=") this.widen(1);
    else if (event.key === "-" || event.key === "−") this.widen(-1);
    else if (event.key === "Delete" || event.key === "Backspace") this.removeRing(curve);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private readonly keyUp = (): void => {
    if (!this.hold || this.gesture.pulling) return;
    const { over } = this;
    this.release();
    this.touch(over);
    const index = Number(this.shadowRoot?.activeElement?.getAttribute("data-curve") ?? -1);
    const { shape } = this;
    const curve = this.curves[index];
    if (shape && curve) void this.say(shape, curve);
  };

  /** Says where a ring, or a place of a family, is now. */
  private async say(shape: Shape, curve: Curve): Promise<void> {
    const name = this.nameOf(shape, curve);
    if (takesRings(shape)) {
      this.spoken = this.reading(shape, curve, name);
      return;
    }
    const felt = this.feltOf(curve);
    await this.pull?.settled;
    const now = this.shape;
    if (!felt || !now) return;
    const read = await this.designer.solver.read("pull", now, new Float64Array([felt.u, spanOf(now) * felt.v]));
    if (read.state !== "done") return;
    const [x = 0, y = 0, z = 0] = read.value.points;
    const unit = unitOf(this.designer.store.design);
    this.spoken = words.at(name, spokenLength(Math.hypot(x, y), unit), spokenLength(z, unit));
  }

  private readonly blurred = (): void => {
    this.keyUp();
    if (!this.hold) this.touch(null);
  };

  /** How long a pixel of the screen is at a ring. */
  private pixel(curve: Curve): number {
    const { shape } = this;
    const { tool: hand } = this.lent;
    const felt = this.feltOf(curve);
    const see = felt && hand?.sight(felt.place);
    const at = shape && this.gripOf(shape, curve);
    const size = at ? Math.hypot(...at) || 1 : 1;
    const [here, above] = at && see ? [see(at), see([at[0], at[1], at[2] + size])] : [null, null];
    return here && above ? size / Math.max(Math.hypot(here.x - above.x, here.y - above.y), 1) : size / 100;
  }

  private removeRing(curve: Curve): void {
    const { designer, shape } = this;
    if (!shape || curve.end || !takesRings(shape)) return;
    designer.apply(removeRing(designer.state, curve.index));
    this.spoken = words.removed(curveName(shape, curve));
    // What had the focus may be gone: the ring below has it now.
    void this.updateComplete.then(() => {
      this.renderRoot.querySelector<HTMLElement>(`[data-curve="${curve.index - 1}"]`)?.focus();
    });
  }

  /** Moves the handles to where their rings are seen. */
  private follow(): void {
    const { shape } = this;
    const { tool: hand } = this.lent;
    if (!hand || !shape) return;
    const see = hand.sight(this.designer.store.part);
    for (const curve of gripsOf(shape)) {
      const handle = this.renderRoot.querySelector<HTMLElement>(`[data-curve="${curve.index}"]`);
      const point = this.gripOf(shape, curve);
      const at = point && see?.(point);
      const cover = this.stage?.cover;
      const spot = at && cover ? besideCover(at, [{ x: cover.width / 2, y: cover.height / 2 }], cover) : at;
      if (!handle) continue;
      handle.hidden = !spot;
      if (spot) handle.style.setProperty("transform", `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`);
    }
  }

  static override readonly styles = [
    base,
    gripStyles,
    css`
      .surface {
        position: absolute;
        z-index: 1;
        inset: 0;
        touch-action: none;
        user-select: none;
      }
      .surface.over {
        cursor: grab;
      }
      .surface.held {
        cursor: grabbing;
      }
      .rings {
        position: absolute;
        z-index: 2;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
      }
      .ring.end::before {
        border-radius: 2px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-pull": PasuPull;
  }
}
