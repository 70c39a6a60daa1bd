/** What lies over the stage while the tool that pulls is taken up and the selected part is a network: its points, for pointers, fingers and keys. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import {
  AXES,
  type Axis,
  imagesOf,
  type Motion,
  middleOf,
  moved,
  scaleBy,
  turnBy,
  unlessStill,
} from "../../document/network/moving";
import { type Network, sizeOf } from "../../document/network/network";
import {
  type Force,
  forceFor,
  heightOf,
  isWithinReach,
  laidAt,
  liesFlat,
  MOST_FORCES,
  pointsAt,
  regionBetween,
  rimOf,
  unfolded,
} from "../../document/network/sculpting";
import { type Picks, withPatch, withVertex, withVertices } from "../../document/network/selection";
import { dot, normalAt, normalOn, unit } from "../../document/network/surface";
import { plus } from "../../document/network/topology";
import type { Pair, Triple } from "../../document/types";
import { formatNumber } from "../../number";
import { Hand } from "../../render/pull/hand";
import type { See, Spot } from "../../render/pull/reach";
import type { Stage } from "../../render/stage";
import { changeNetwork } from "../../state/network-actions";
import { ARROWS } from "../../ui/arrows";
import { base } from "../../ui/styles";
import { networks as words } from "../../words/english/networks";
import { pull } from "../../words/english/pull";
import { spokenLength } from "../../words/quantities";
import { type NetworkDesk, networkDesk, networkOf, stepOf } from "../../work/network-desk";
import { followed } from "../blend/grip-pull";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";
import { acrossView, type Grasp, moving, scaling, shifting, towardsEye, turning } from "./dragging";
import {
  around,
  type Colours,
  drawHeld,
  drawNetwork,
  type Item,
  type Items,
  isLeft,
  movedItems,
  NetworkCurves,
  type Parted,
  type Placed,
  partedOf,
  placedItems,
  rectOf,
  redrawWithin,
  respot,
  touched,
  withParted,
} from "./drawn-network";

interface Held {
  readonly pointer: number;
  readonly item: Item | null;
  /** Where the stage is on the page. */
  readonly frame: DOMRect;
  readonly network: Network;
  /** What was picked before it was touched. */
  readonly was: Picks;
  picks: Picks;
  grasp: Grasp;
  readonly more: boolean;
  /** Whether it was picked when it was touched. */
  fresh: boolean;
  /** Where on which patch a region begins. */
  readonly begun: { readonly patch: number; readonly at: Pair } | null;
  /** Whether the region that is drawn goes round a corner where there can be none. */
  isBent: boolean;
  now: Spot;
  moves: boolean;
}

/** Of very many points what is drawn on a canvas of its own, as long as it is seen so: all that is not picked, which is what a hand leaves where it is. */
interface Rest extends Items {
  readonly network: Network;
  readonly picks: Picks;
  readonly mirror: Axis | null;
  readonly view: string;
  readonly parted: Parted;
}

/** Where these are seen, all is. */
const PROBES: readonly Triple[] = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** How far from a point a mouse takes it, and a finger, in pixels. */
const NEAR = { mouse: 11, pen: 14, touch: 24 } as const;
/** A hand that goes less far has clicked. */
const STILL = 3;
/** A finger that rests on a point for so many milliseconds picks it beside the others. */
const RESTS_MS = 500;
/** With more points buttons stand for what is picked alone: fields of the panel pick by number. */
const MOST = 400;
const COARSE = 10;
/** Less than this of a step is rounding. */
const DUST = 1e-4;
const STEPS = 100;
const TURN = Math.PI / 36;
const SCALE = 1.02;
/** A new region rises by so much of the size. */
const RISE = 0.06;

@customElement("pasu-network-handles")
export class PasuNetworkHandles extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @state() private spoken = "";
  @query("canvas.front") private readonly canvas!: HTMLCanvasElement | null;
  @query("canvas.behind") private readonly behind!: HTMLCanvasElement | null;
  private readonly lent = new Lent(
    this,
    (bench) => new Hand(bench),
    (tool) => {
      tool.onFrame = () => this.follow();
    },
  );
  private held: Held | null = null;
  private curves: NetworkCurves | null = null;
  private placed: readonly Placed[] = [];
  private colours: Colours = { line: "", picked: "", ground: "" };
  private unmoved: Rest | null = null;
  /** What was drawn last. */
  private drawn: { readonly network: Network; readonly picks: Picks; readonly view: string } | null = null;
  /** Whether all handles are where they are seen. */
  private laid = false;
  private over: Document | ShadowRoot | null = null;
  private drags = 0;
  /** In CSS pixels; asked for only when it changes, because the page has to be laid out to know it. */
  private size: readonly [number, number] = [0, 0];
  private readonly sized = new ResizeObserver(() => {
    this.size = [this.clientWidth, this.clientHeight];
    this.follow();
  });
  private resting: ReturnType<typeof setTimeout> | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.escape, { capture: true });
    this.size = [this.clientWidth, this.clientHeight];
    this.sized.observe(this);
    // Before the stage hears of it: what is no point of the network turns the view.
    this.over = this.getRootNode() as ShadowRoot;
    this.over.addEventListener("pointerdown", this.take, { capture: true });
    this.over.addEventListener("contextmenu", this.noMenu, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.escape, { capture: true });
    this.sized.disconnect();
    this.over?.removeEventListener("pointerdown", this.take, { capture: true });
    this.over?.removeEventListener("contextmenu", this.noMenu, { capture: true });
    this.over = null;
    if (this.held) this.designer.store.endGesture();
    this.letGo();
  }

  override render() {
    const { network } = this;
    if (!network) return nothing;
    const picks = this.desk.picksOf(network);
    const { vertices } = network;
    const shown =
      vertices.length > MOST ? [...picks.vertices].sort((a, b) => a - b).slice(0, MOST) : [...vertices.keys()];
    const patches = network.patches.length > MOST ? [...picks.patches] : [...network.patches.keys()];
    return html`
      <canvas class="behind" aria-hidden="true"></canvas>
      <canvas class="front" aria-hidden="true"></canvas>
      <div class="handles" role="group" aria-label=${words.handles} aria-describedby="keys">
        ${picks.vertices.size > 1 ? this.handle({ kind: "pivot" }, words.pivot(picks.vertices.size), null) : nothing}
        ${shown.map((index) => this.handle({ kind: "vertex", index }, this.reading(network, index), picks.vertices.has(index)))}
        ${patches.map((index) => this.handle({ kind: "patch", index }, words.patch(formatNumber(index + 1)), picks.patches.has(index)))}
        ${[...picks.patches].flatMap((patch) =>
          (network.patches[patch]?.forces ?? []).map((_, index) =>
            this.handle({ kind: "crest", patch, index }, this.crestOf(picks, patch, index), null),
          ),
        )}
      </div>
      <p id="keys" class="spoken">${words.handleKeys}</p>
      <p class="spoken" role="status">${this.spoken}</p>
    `;
  }

  override updated(): void {
    // There may be other handles.
    this.laid = false;
    this.follow();
  }

  private get desk(): NetworkDesk {
    return networkDesk(this.designer);
  }

  private get network(): Network | null {
    return networkOf(this.designer);
  }

  /** Of forces of several patches it is told which one's they are. */
  private crestOf({ patches }: Picks, patch: number, index: number): string {
    const crest = words.crest(formatNumber(index + 1));
    return patches.size > 1 ? words.crestOf(crest, words.patch(formatNumber(patch + 1))) : crest;
  }

  /** What can be picked or left out is pressed or not; what is there as long as it can be dragged is neither. */
  private handle(item: Item, label: string, picked: boolean | null) {
    return html`<button
      type="button"
      class=${item.kind}
      data-item=${nameOf(item)}
      aria-roledescription=${pull.handle}
      aria-pressed=${picked === null ? nothing : picked ? "true" : "false"}
      aria-label=${label}
      @keydown=${(event: KeyboardEvent) => this.key(event, item)}
      @keyup=${() => this.designer.store.endGesture()}
      @blur=${() => this.designer.store.endGesture()}
    ></button>`;
  }

  private reading(network: Network, index: number): string {
    const unitName = unitOf(this.designer.store.design);
    const at = (network.vertices[index] ?? []).map((value) => spokenLength(value, unitName)).join(", ");
    return words.point(formatNumber(index + 1), at);
  }

  // Pointers

  private readonly take = (event: Event): void => {
    const { network } = this;
    const { tool: hand } = this.lent;
    if (!(event instanceof PointerEvent) || event.button !== 0 || this.held || !network) return;
    // Tools that lie over the stage are pressed as ever.
    const on = event.composedPath()[0];
    if (
      !(on instanceof HTMLCanvasElement) &&
      !(on instanceof HTMLElement && (on.classList.contains("host") || on.closest(".host")))
    )
      return;
    const see = hand?.sight(this.designer.store.part);
    if (!see) return;
    const frame = this.getBoundingClientRect();
    const from = { x: event.clientX - frame.left, y: event.clientY - frame.top };
    const { touch } = this.desk.settings;
    const reach = NEAR[event.pointerType as keyof typeof NEAR] ?? NEAR.mouse;
    // Who draws a region means the surface, and not the points on it.
    const found = this.nearest(from, reach, ({ kind }) => touch !== "region" || kind === "crest");
    const begun = !found && touch === "region" ? touched(network, see, from) : null;
    if (!found && touch !== "box" && !begun) return;
    event.preventDefault();
    event.stopPropagation();
    const more = event.shiftKey || this.desk.settings.several;
    const was = this.desk.picksOf(network);
    const item = found?.item ?? null;
    // What is not picked yet is picked at once, so that it can be dragged; what is, only when nothing was dragged.
    const picks = isPicked(was, item) ? was : toggled(network, was, item, more);
    if (picks !== was) this.desk.pick(network, picks);
    this.drags += 1;
    this.held = {
      pointer: event.pointerId,
      item,
      frame,
      network,
      was,
      picks,
      grasp: this.grasp(network, picks, item, found?.at ?? null, see, from),
      more,
      fresh: picks !== was,
      begun: begun ? { patch: begun.patch, at: [begun.u, begun.v] } : null,
      isBent: false,
      now: from,
      moves: false,
    };
    if (item) void this.focusOn(item);
    if (event.pointerType !== "mouse" && (item?.kind === "vertex" || item?.kind === "patch"))
      this.resting = setTimeout(() => this.rest(), RESTS_MS);
    window.addEventListener("pointermove", this.move);
    window.addEventListener("pointerup", this.release);
    window.addEventListener("pointercancel", this.release);
  };

  /** Of very many points those that are picked alone have a handle, which comes with the next drawing: keys go on where a hand has clicked. */
  private async focusOn(item: Item): Promise<void> {
    const handle = () => this.renderRoot.querySelector<HTMLElement>(`[data-item="${nameOf(item)}"]`);
    if (!handle()) await this.updateComplete;
    handle()?.focus({ preventScroll: true });
  }

  /** A finger or a pen rests on a point: it is picked beside those before, and all of them can be dragged; or it is left out of them, and nothing is held. */
  private rest(): void {
    const { held, network } = this;
    if (!held || held.moves || held.network !== network) return;
    const { item, was, grasp } = held;
    const picks = toggled(network, was, item, true);
    this.desk.pick(network, picks);
    this.spoken = words.picked(picks.vertices.size, picks.patches.size);
    if (!isPicked(picks, item)) {
      this.letGo();
      return;
    }
    held.picks = picks;
    held.grasp = this.grasp(network, picks, item, grasp.at, grasp.see, grasp.from);
    held.fresh = true;
  }

  /** A finger that rests is no question for a menu. */
  private readonly noMenu = (event: Event): void => {
    if (this.held) event.preventDefault();
  };

  private nearest(spot: Spot, reach: number, counts: (item: Item) => boolean): Placed | null {
    let best: Placed | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (const placed of this.placed) {
      const far = Math.hypot(placed.seen.x - spot.x, placed.seen.y - spot.y);
      if (far > reach || !counts(placed.item)) continue;
      // What is behind is taken where nothing before it is as near; what is worked with goes first.
      const score =
        far +
        (placed.front ? 0 : reach) -
        (placed.item.kind === "pivot" || placed.item.kind === "crest" ? reach / 2 : 0);
      if (score < least) [best, least] = [placed, score];
    }
    return best;
  }

  private grasp(network: Network, picks: Picks, item: Item | null, at: Triple | null, see: See, from: Spot): Grasp {
    const { settings } = this.desk;
    const { way, grid } = settings;
    const pivot = middleOf(network, picks.vertices);
    return {
      see,
      at: at ?? pivot,
      pivot,
      way: this.wayOf(network, picks, item, way),
      size: sizeOf(network),
      grid: grid ? stepOf(settings, network) : null,
      from,
    };
  }

  private wayOf(network: Network, picks: Picks, item: Item | null, way: string): Triple | null {
    const axis = AXES.indexOf(way as Axis);
    if (axis >= 0) return [0, 1, 2].map((each) => (each === axis ? 1 : 0)) as unknown as Triple;
    if (way !== "normal") return null;
    if (item?.kind === "patch") return normalOn(network, item.index, 0.5, 0.5);
    if (item?.kind === "vertex") return normalAt(network, item.index);
    let sum: Triple = [0, 0, 0];
    for (const vertex of picks.vertices) sum = plus(sum, normalAt(network, vertex) ?? [0, 0, 0], 1);
    return unit(sum);
  }

  private readonly move = (event: PointerEvent): void => {
    const { held } = this;
    if (held?.pointer !== event.pointerId) return;
    const { frame } = held;
    held.now = { x: event.clientX - frame.left, y: event.clientY - frame.top };
    const { from } = held.grasp;
    const by = { x: held.now.x - from.x, y: held.now.y - from.y };
    if (!held.moves && Math.hypot(by.x, by.y) < STILL) return;
    held.moves = true;
    clearTimeout(this.resting);
    if (!held.item) {
      this.bend(held);
      this.follow();
      return;
    }
    if (held.item.kind === "crest") {
      this.raise(held, held.item, by);
      return;
    }
    const { motion } = this.desk.settings;
    const act: Motion =
      motion === "turn"
        ? turning(held.grasp, by)
        : motion === "scale"
          ? scaling(held.grasp, by)
          : moving(held.grasp, by, this.met(held));
    this.change(held.network, held.picks, act, `drag ${this.drags}`);
  };

  /** Says so as soon as the region that is drawn comes round a corner where none can lie. */
  private bend(held: Held): void {
    const { begun, network, grasp, now } = held;
    const end = begun && this.endOf(network, begun.patch, grasp.see, now);
    const region = begun && this.regionOf(network, begun, end);
    // What is near but nowhere in the plane lies beyond such a corner.
    const over = begun && !end ? touched(network, grasp.see, now) : null;
    const isBent =
      begun !== null &&
      (region
        ? !liesFlat(network, begun.patch, region)
        : over !== null && isWithinReach(network, begun.patch, over.patch));
    if (isBent && !held.isBent) this.designer.notices.say(words.bentRegion);
    held.isBent = isBent;
  }

  /** The point that the hand is over, where points meet. */
  private met({ item, picks, now }: Held): Triple | null {
    if (!this.desk.settings.meet || item?.kind !== "vertex") return null;
    const others = (each: Item) => each.kind === "vertex" && !picks.vertices.has(each.index);
    return this.nearest(now, NEAR.mouse, others)?.at ?? null;
  }

  /** Pulls the crest of a force out along the way that it points, or the normal. */
  private raise({ network, grasp }: Held, item: Extract<Item, { kind: "crest" }>, by: Spot): void {
    const patch = network.patches[item.patch];
    const force = patch?.forces?.[item.index];
    if (!patch || !force) return;
    const height = heightOf(patch, force);
    const way = unit(height) ?? normalOn(network, item.patch, 0.5, 0.5) ?? [0, 0, 1];
    const [far = 0] = followed(grasp.see, grasp.at, [way], by);
    const f0 = forceFor(patch, plus(height, way, far));
    const patches = network.patches.map((each, index) =>
      index === item.patch
        ? { ...each, forces: (each.forces ?? []).map((one, place) => (place === item.index ? { ...one, f0 } : one)) }
        : each,
    );
    this.edit(() => ({ ...network, patches }), `crest ${this.drags}`);
  }

  private readonly release = (event: PointerEvent): void => {
    const { held, network } = this;
    if (held?.pointer !== event.pointerId) return;
    this.letGo();
    if (event.type === "pointercancel") {
      this.designer.store.cancelGesture();
      return;
    }
    if (network) this.finish(held, network);
    this.designer.store.endGesture();
    this.requestUpdate();
  };

  private finish(held: Held, network: Network): void {
    const { item, begun, picks, grasp, now } = held;
    if (begun) {
      const isFull = (network.patches[begun.patch]?.forces ?? []).length >= MOST_FORCES;
      // A click is no region: what is as narrow as can be would be a spike.
      if (isFull) this.designer.notices.say(words.noMoreForces(formatNumber(MOST_FORCES)));
      else if (held.isBent) this.designer.notices.say(words.bentRegion);
      else if (!held.moves || !this.sculpt(held, begun)) this.designer.notices.say(words.noRegion);
      return;
    }
    if (!item) {
      const [left, right] = [Math.min(grasp.from.x, now.x), Math.max(grasp.from.x, now.x)];
      const [top, bottom] = [Math.min(grasp.from.y, now.y), Math.max(grasp.from.y, now.y)];
      const inside = this.placed.flatMap(({ item: each, seen }) =>
        each.kind === "vertex" && seen.x >= left && seen.x <= right && seen.y >= top && seen.y <= bottom
          ? [each.index]
          : [],
      );
      this.desk.pick(network, withVertices(picks, inside, held.more));
      return;
    }
    if (held.moves || held.fresh) return;
    this.desk.pick(network, toggled(network, picks, item, held.more));
  }

  /** A force on the rectangle that was drawn, which rises a little: its crest is there to be pulled. Whether the hand ended on the surface, where there can be one. */
  private sculpt({ network, grasp, now }: Held, begun: NonNullable<Held["begun"]>): boolean {
    const patch = network.patches[begun.patch];
    const end = this.endOf(network, begun.patch, grasp.see, now);
    if (!patch || !end) return false;
    const normal = normalOn(network, begun.patch, ...begun.at) ?? [0, 0, 1];
    const out = facesEye(normal, grasp.see, grasp.at, network) ? 1 : -1;
    const far = out * RISE * grasp.size;
    const force = regionBetween(patch, begun.at, end, [far * normal[0], far * normal[1], far * normal[2]]);
    const patches = network.patches.map((each, index) =>
      index === begun.patch ? { ...each, forces: [...(each.forces ?? []), force] } : each,
    );
    this.edit((before) => ({ ...before, patches }));
    const after = this.network;
    if (after) this.desk.pick(after, withPatch(after, { vertices: new Set(), patches: new Set() }, begun.patch, false));
    this.desk.set({ touch: "view" });
    return true;
  }

  /** Where a region ends: on the patches round the one that it begins on, laid flat. */
  private endOf(network: Network, patch: number, see: See, spot: Spot): Pair | null {
    const found = touched(network, see, spot);
    if (!found) return null;
    const laid = unfolded(network, patch).find((each) => each.patch === found.patch);
    return laid ? laidAt(laid, found.u, found.v) : null;
  }

  private letGo(): void {
    this.held = null;
    clearTimeout(this.resting);
    window.removeEventListener("pointermove", this.move);
    window.removeEventListener("pointerup", this.release);
    window.removeEventListener("pointercancel", this.release);
  }

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.held) return;
    event.preventDefault();
    event.stopPropagation();
    this.letGo();
    this.designer.store.cancelGesture();
    this.requestUpdate();
  };

  // Keys

  private key(event: KeyboardEvent, item: Item): void {
    const { network } = this;
    const { tool: hand } = this.lent;
    if (event.ctrlKey || event.metaKey || event.altKey || !network) return;
    const was = this.desk.picksOf(network);
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      event.stopPropagation();
      this.desk.pick(network, toggled(network, was, item, event.shiftKey || this.desk.settings.several));
      return;
    }
    const arrow = ARROWS[event.key];
    const see = hand?.sight(this.designer.store.part);
    if (!arrow || !see) return;
    event.preventDefault();
    event.stopPropagation();
    const times = event.shiftKey ? COARSE : 1;
    if (item.kind === "crest") {
      this.raiseBy(network, item, (times * (arrow[0] + arrow[1]) * sizeOf(network)) / STEPS, see);
      return;
    }
    const picks = isPicked(was, item) ? was : toggled(network, was, item, this.desk.settings.several);
    if (picks !== was) this.desk.pick(network, picks);
    const held = item.kind === "vertex" ? (network.vertices[item.index] ?? null) : null;
    const grasp = this.grasp(network, picks, item, held, see, { x: 0, y: 0 });
    this.change(network, picks, this.nudge(grasp, arrow, times), `keys ${nameOf(item)}`);
    const now = this.network;
    if (now && item.kind === "vertex") this.spoken = this.reading(now, item.index);
  }

  private nudge(grasp: Grasp, [right, up]: readonly [number, number], times: number): Motion {
    const { see, pivot, way, size, grid } = grasp;
    const { motion } = this.desk.settings;
    if (motion === "turn") return turnBy(pivot, way ?? towardsEye(see, pivot, size), -(right - up) * times * TURN);
    if (motion === "scale") return scaleBy(pivot, SCALE ** (times * (right + up)), way);
    const step = times * (grid ?? Number((size / STEPS).toPrecision(1)));
    const along = way ?? unit(acrossView(see, pivot, size, { x: right, y: -up })) ?? [0, 0, 0];
    const far = way ? step * (right + up) : step;
    return shifting(grasp, [along[0] * far, along[1] * far, along[2] * far]);
  }

  /** Towards the eye or away from it, as a region rises that is drawn: through the surface to its other side too, where the crest points the other way. */
  private raiseBy(network: Network, item: Extract<Item, { kind: "crest" }>, far: number, see: See): void {
    const patch = network.patches[item.patch];
    const force = patch?.forces?.[item.index];
    if (!patch || !force) return;
    const height = heightOf(patch, force);
    const way = unit(height) ?? normalOn(network, item.patch, 0.5, 0.5) ?? [0, 0, 1];
    const from = this.placed.find((each) => nameOf(each.item) === nameOf(item))?.at ?? [0, 0, 0];
    const next = plus(height, way, facesEye(way, see, from, network) ? far : -far);
    // As high as nothing is what rounding leaves.
    const f0 = forceFor(patch, Math.hypot(...next) > DUST * Math.abs(far) ? next : [0, 0, 0]);
    const forces = (patch.forces ?? []).map((each, place) => (place === item.index ? { ...each, f0 } : each));
    const patches = network.patches.map((each, index) => (index === item.patch ? { ...each, forces } : each));
    this.edit((before) => ({ ...before, patches }), `crest ${nameOf(item)}`);
  }

  private change(from: Network, picks: Picks, motion: Motion, key: string): void {
    const { mirror } = this.desk.settings;
    this.edit((before) => {
      const next = moved(from, picks.vertices, motion, mirror);
      return next === from && before !== from ? before : unlessStill(next, before);
    }, key);
  }

  private edit(edit: (network: Network) => Network, key?: string): void {
    const before = this.network;
    const picks = before && this.desk.picksOf(before);
    this.designer.apply(changeNetwork(this.designer.state, edit, key));
    const { network } = this;
    // Where points were moved alone, the same are picked.
    if (network && picks && network.patches !== before?.patches) this.desk.pick(network, picks);
  }

  /** Draws the network where it is seen, and puts the handles there. */
  private follow(): void {
    const { network, canvas } = this;
    const { tool: hand } = this.lent;
    const see = hand && network ? hand.sight(this.designer.store.part) : null;
    if (!hand || !network || !canvas) return;
    const picks = this.desk.picksOf(network);
    const view = this.viewOf(see);
    // A frame of the stage in which nothing of this changed is no reason to draw thousands of points again.
    const drawing = this.held?.moves && !this.held.item;
    const last = this.drawn;
    if (!drawing && last?.network === network && last.picks === picks && last.view === view) {
      if (see && !this.laid) this.putHandles(network, see);
      return;
    }
    this.drawn = drawing ? null : { network, picks, view };
    const pivot = picks.vertices.size > 1 ? middleOf(network, picks.vertices) : null;
    const rest = this.restOf(network, picks, see, view);
    const context = this.cleared(canvas);
    if (see && context && rest && this.curves) {
      const { parted, placed, middle } = rest;
      const moved = movedItems(this.curves, parted, picks, pivot, see, middle);
      this.placed = [...placed, ...moved];
      drawNetwork(context, this.curves, moved, picks, see, this.colours, { of: parted, which: "moved" });
    } else if (see && context) {
      if (this.curves?.network !== network) this.curves = new NetworkCurves(network);
      const { placed } = placedItems(this.curves, picks, pivot, see);
      this.placed = placed;
      this.colours = this.coloursNow();
      drawNetwork(context, this.curves, placed, picks, see, this.colours);
    }
    const { held } = this;
    if (see && context && held && drawing) {
      const box = held.begun ? null : ([held.grasp.from, held.now] as const);
      drawHeld(context, see, this.colours, box, this.outline(network, see));
    }
    if (see) this.putHandles(network, see);
  }

  /** Which way the stage is looked at: the same as long as all points are seen where they were. */
  private viewOf(see: See | null): string {
    const seen = see ? PROBES.map((point) => see(point)) : [];
    const places = seen.flatMap((spot) =>
      (spot ? [spot.x, spot.y, 100 * (spot.depth ?? 0)] : []).map((each) => each.toFixed(3)),
    );
    // While a hand holds something nobody asks for other colours, and asking for them has the browser find all styles again.
    const colours = this.held?.moves ? this.colours : this.coloursNow();
    return [...this.size, window.devicePixelRatio, ...places, ...Object.values(colours)].join();
  }

  private coloursNow(): Colours {
    const style = getComputedStyle(this);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    const [line, picked, ground] = [colour("--ink"), colour("--accent"), colour("--sheet")];
    // The same ones as before, as long as they are: what was drawn in them is kept with them.
    const { colours } = this;
    if (colours.line === line && colours.picked === picked && colours.ground === ground) return colours;
    return { line, picked, ground };
  }

  /** The canvas as large as it is seen, and empty. */
  private cleared(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
    const context = canvas.getContext("2d");
    const ratio = window.devicePixelRatio;
    const [width, height] = this.size;
    if (canvas.width !== Math.round(ratio * width) || canvas.height !== Math.round(ratio * height)) {
      canvas.width = Math.round(ratio * width);
      canvas.height = Math.round(ratio * height);
    }
    context?.setTransform(ratio, 0, 0, ratio, 0, 0);
    context?.clearRect(0, 0, width, height);
    return context;
  }

  /** What of very many points is not picked: drawn once, on a canvas of its own, and again where something else is picked or was moved. Null where all is drawn together. */
  private restOf(network: Network, picks: Picks, see: See | null, view: string): Rest | null {
    const { behind } = this;
    const before = this.unmoved;
    const { mirror } = this.desk.settings;
    if (see && behind) {
      const same = before?.picks === picks && before.mirror === mirror && before.network.patches === network.patches;
      const parted = same ? before.parted : partedOf(network, withImages(network, pickedOf(network, picks), mirror));
      if (parted) {
        const next = before && this.restAfter(before, parted, network, see, view);
        this.unmoved = {
          ...(next ?? this.restAnew(behind, parted, network, picks, see)),
          network,
          picks,
          mirror,
          view,
          parted,
        };
        return this.unmoved;
      }
    }
    if (before && behind) this.cleared(behind);
    this.unmoved = null;
    return null;
  }

  private restAnew(behind: HTMLCanvasElement, parted: Parted, network: Network, picks: Picks, see: See): Items {
    this.curves = this.curves?.network === network ? this.curves : new NetworkCurves(network);
    this.colours = this.coloursNow();
    const items = placedItems(this.curves, picks, null, see);
    const placed = items.placed.filter((each) => isLeft(parted, each));
    const context = this.cleared(behind);
    if (context) drawNetwork(context, this.curves, placed, picks, see, this.colours, { of: parted, which: "left" });
    return { ...items, placed };
  }

  /** The same after points were moved, or others were picked; null where it is seen from elsewhere, or too much is different. */
  private restAfter(before: Rest, parted: Parted, network: Network, see: See, view: string): Items | null {
    const { curves, behind } = this;
    const { spots, middle } = before;
    if (before.view !== view || before.network.patches !== network.patches || !curves || !behind) return null;
    const elsewhere = movedSince(before.network, network);
    const isAlike = parted === before.parted;
    const touched = partedOf(network, elsewhere);
    if (!touched) return null;
    const stays = isAlike && [...elsewhere].every((vertex) => parted.vertices.has(vertex));
    // Where it was, and where it is.
    const all = stays ? null : withParted(network, before.parted, [...elsewhere, ...parted.vertices]);
    if (!stays && !all) return null;
    const was = all && rectOf(network, all, spots);
    if (elsewhere.size > 0) this.curves = new NetworkCurves(network, curves, touched);
    respot(network, elsewhere, see, spots);
    if (!all) return { spots, middle, placed: before.placed };
    const picks = this.desk.picksOf(network);
    const again = movedItems(this.curves ?? curves, all, picks, null, see, middle);
    const placed = [...before.placed.filter((each) => isLeft(all, each)), ...again]
      .filter((each) => isLeft(parted, each))
      .sort((one, other) => one.seen.depth - other.seen.depth);
    const items = { spots, middle, placed };
    const rect = around(was, rectOf(network, all, spots));
    const context = behind.getContext("2d");
    if (rect && context) redrawWithin(context, rect, this.curves ?? curves, items, picks, see, this.colours, parted);
    return items;
  }

  private putHandles(network: Network, see: See): void {
    this.laid = true;
    for (const handle of this.renderRoot.querySelectorAll<HTMLElement>("[data-item]")) {
      const spot = this.spotOf(handle.dataset.item ?? "", network, see);
      if (spot) handle.style.setProperty("transform", `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`);
    }
  }

  /** Where a handle is seen, also one that is not drawn because it is behind. */
  private spotOf(name: string, network: Network, see: See): Spot | null {
    const [kind, index = ""] = name.split(" ");
    const place = Number(index);
    if (kind === "vertex") return network.vertices[place] ? see(network.vertices[place]) : null;
    if (kind === "patch") return this.curves?.middles[place] ? see(this.curves.middles[place]) : null;
    return this.placed.find(({ item }) => nameOf(item) === name)?.seen ?? null;
  }

  /** Round the region that is being drawn. */
  private outline(network: Network, see: See): readonly Triple[] {
    const { held } = this;
    if (!held?.begun || !held.moves || held.isBent) return [];
    const { patch } = held.begun;
    const region = this.regionOf(network, held.begun, this.endOf(network, patch, see, held.now));
    return region ? pointsAt(network, unfolded(network, patch), rimOf(region, 8)) : [];
  }

  /** From where it begins to there, without a height. */
  private regionOf(network: Network, { patch, at }: NonNullable<Held["begun"]>, end: Pair | null): Force | null {
    const own = network.patches[patch];
    return own && end ? regionBetween(own, at, end, [0, 0, 0]) : null;
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
      }
      canvas {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      .handles {
        position: absolute;
        inset: 0;
      }
      button {
        position: absolute;
        top: -12px;
        left: -12px;
        width: 24px;
        height: 24px;
        padding: 0;
        border: 0;
        border-radius: 50%;
        background: none;
      }
      .pivot {
        top: -16px;
        left: -16px;
        width: 32px;
        height: 32px;
      }
    `,
  ];
}

/** Whether a direction leads towards the eye, and not away from it. */
function facesEye(way: Triple, see: See, from: Triple, network: Network): boolean {
  return dot(way, towardsEye(see, from, sizeOf(network))) >= 0;
}

/** The vertices that are picked, and those of picked patches. */
function pickedOf(network: Network, { vertices, patches }: Picks): ReadonlySet<number> {
  if (patches.size === 0) return vertices;
  return new Set([...vertices, ...[...patches].flatMap((patch) => network.patches[patch]?.frame ?? [])]);
}

/** Of two networks with the same patches the vertices that are elsewhere. */
function movedSince({ vertices: before }: Network, { vertices: after }: Network): ReadonlySet<number> {
  const moved = new Set<number>();
  if (before === after) return moved;
  for (let vertex = 0; vertex < after.length; vertex += 1) if (before[vertex] !== after[vertex]) moved.add(vertex);
  return moved;
}

/** Vertices with their images in a mirror, which move too. */
function withImages(network: Network, vertices: ReadonlySet<number>, mirror: Axis | null): ReadonlySet<number> {
  if (!mirror) return vertices;
  const images = imagesOf(network, mirror);
  return new Set([...vertices, ...[...vertices].flatMap((vertex) => images.get(vertex) ?? [])]);
}

function isPicked({ vertices, patches }: Picks, item: Item | null): boolean {
  if (item?.kind === "vertex") return vertices.has(item.index);
  return item?.kind === "patch" && patches.has(item.index);
}

/** With a point or a patch picked, alone or beside what there is; the same picks of anything else. */
function toggled(network: Network, picks: Picks, item: Item | null, more: boolean): Picks {
  if (item?.kind === "vertex") return withVertex(picks, item.index, more);
  return item?.kind === "patch" ? withPatch(network, picks, item.index, more) : picks;
}

function nameOf(item: Item): string {
  switch (item.kind) {
    case "pivot":
      return "pivot";
    case "crest":
      return `crest ${item.patch} ${item.index}`;
    default:
      return `${item.kind} ${item.index}`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-network-handles": PasuNetworkHandles;
  }
}
