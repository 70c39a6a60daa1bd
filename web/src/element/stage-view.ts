/** The stage in the page: loads the renderer beside the solver, gives it what was solved, and passes the keyboard on. */

import { computed, effect, signal, untracked } from "@preact/signals-core";
import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { unitOf } from "../document/look";
import type { Stage } from "../render/stage";
import { togglePlacing, togglePulling } from "../state/actions";
import type { PartId } from "../state/part-ids";
import { alsoSelect, insidePart, selectedIds, selectParts } from "../state/seen-actions";
import type { Change, State } from "../state/store";
import type { Camera } from "../state/viewed";
import { base, buttons } from "../ui/styles";
import { wheel } from "../ui/wheel";
import { page } from "../words/english/page";
import { LENGTH_LABELS } from "../words/length";
import type { Compared } from "../work/comparison";
import type { Shown } from "../work/surface";
import { trace } from "../work/trace";
import { DesignerElement } from "./designer-element";
import { StageHolder } from "./stage-holder";
import { stageKey } from "./stage-keys";
import type { StageMade } from "./stage-made";
import { stageModel } from "./stage-model";
import type { Spot, UnderEvent } from "./under/ask";

/** Undo across a change of size by more than this fits the view again. */
const OTHER_SIZE = 1.6;

/** A graphics context that has not come back by then, in milliseconds, is taken for lost. */
const PATIENCE = 5000;

/** The keys that take up a tool, or put it down. */
const TOOLS: Readonly<Record<string, (state: State) => Change>> = { p: togglePulling, m: togglePlacing };

/** What stands at the upper edge while something is pulled at or moved. */
const BARS = "pasu-pull-bar, pasu-place-bar";

@customElement("pasu-stage")
export class PasuStage extends DesignerElement {
  @query(".host") private readonly host!: HTMLDivElement;
  @query(".still") private readonly still!: HTMLCanvasElement | null;
  private readonly holder = new StageHolder(this, {
    host: () => this.host,
    options: () => this.options(),
    patience: PATIENCE,
    opened: () => {
      for (const each of this.renderRoot.querySelectorAll(".host, #description, pasu-stage-tools")) {
        this.furniture.observe(each);
      }
      // The pot is drawn without waiting for its tools.
      void import("./stage-tools");
    },
    closing: () => this.forget(),
  });
  /** The point under which parts are listed. */
  @state() private under: Spot | null = null;
  private drawn: Shown | null = null;
  private hiding: readonly PartId[] = [];
  private within: PartId | null = null;
  private compared: Compared | null = null;
  readonly #made = signal<StageMade | null>(null);
  private making = false;
  private leave: (() => void)[] = [];
  private hinting = false;
  private framed = -1;
  private wanted: Camera | null = null;
  private framedSize = 0;
  private readonly resizes = new ResizeObserver(() => void this.drawStill());
  private readonly furniture = new ResizeObserver(() => this.furnish());
  /** What the still picture is of. */
  private pictured: { readonly shown: Shown | null; readonly hidden: readonly PartId[] } = { shown: null, hidden: [] };
  // Apart from what else changes of the design and of what is shown of it, so that a drag draws nothing of this again.
  readonly #kind = computed(() => {
    const { design, part } = this.designer.store;
    return design.parts[part]?.shape.kind;
  });
  readonly #within = computed(() => insidePart(this.designer.store));
  readonly #unit = computed(() => unitOf(this.designer.store.design));
  readonly #several = computed(() => this.designer.store.design.parts.length > 1);
  readonly #held = computed(() => this.designer.store.inGesture);
  readonly #waits = computed(() => this.designer.surface.shown === null && this.designer.surface.problem === null);

  override connectedCallback(): void {
    super.connectedCallback();
    // A new surface goes to the stage before the page writes about it.
    this.leave = [
      effect(() => this.display()),
      effect(() => this.measure()),
      effect(() => this.#made.value?.update()),
      effect(() => void this.hint()),
    ];
    this.addEventListener("under-asked", this.underAsked as EventListener);
    if (this.hasUpdated) void this.holder.open();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.leave) leave();
    this.leave = [];
  }

  /** Nothing is drawn any more. */
  private forget(): void {
    this.resizes.disconnect();
    this.furniture.disconnect();
    this.#made.peek()?.dispose();
    this.#made.value = null;
    this.making = false;
    this.drawn = null;
    this.compared = null;
    this.framed = -1;
    this.framedSize = 0;
  }

  override firstUpdated(): void {
    void this.holder.open();
  }

  get stage(): Stage | null {
    return this.holder.stage;
  }

  /** The picture as it is seen; null while there is no stage to take it from. */
  picture(width: number, height: number, transparent: boolean): Promise<Blob> | null {
    return this.stage?.picture(width, height, { transparent }) ?? null;
  }

  override focus(options?: FocusOptions): void {
    this.host.focus(options);
  }

  private options() {
    return {
      theme: this.theme(),
      lengths: LENGTH_LABELS[unitOf(this.designer.store.design)],
      onTap: (part: PartId | string, adds: boolean) => {
        const { designer } = this;
        if (designer.store.ids.length < 2) return;
        designer.apply(adds ? alsoSelect(designer.state, Number(part)) : selectParts(Number(part)));
      },
      onUnder: (x: number, y: number) => this.lookUnder({ x, y }),
      onDrawn: () => {
        if (this.drawn) trace("drawn", this.drawn.change);
      },
      onCost: (milliseconds: number, coarsest: boolean) => {
        // Only what a hand asked for says what its changes cost: what stands at rest took longer, and is drawn for other reasons too.
        const { drawn } = this;
        if (!drawn || drawn.settled || !this.designer.store.inGesture) return;
        const { times } = drawn.solved;
        if (times) this.designer.surface.pace.learn(times.done - times.begun + milliseconds, coarsest);
      },
    };
  }

  /** Tells the stage what lies over it. */
  private furnish(): void {
    const { stage } = this;
    if (!stage) return;
    const frame = this.getBoundingClientRect();
    const boxOf = (found: string | Element | null) => {
      const element = typeof found === "string" ? this.renderRoot.querySelector(found) : found;
      const each = element?.getBoundingClientRect();
      if (!each || each.width === 0 || each.height === 0) return [];
      const [left, top] = [each.left - frame.left, each.top - frame.top];
      return [{ left, top, right: left + each.width, bottom: top + each.height }];
    };
    // On a narrow screen the bar of the tool that pulls stands where the caption was.
    const caption = this.renderRoot.querySelector("#description:not(:empty)");
    const hidden = caption !== null && getComputedStyle(caption).visibility === "hidden";
    const [box = null] = boxOf(hidden ? BARS : "#description:not(:empty)");
    const bar = this.renderRoot.querySelector(BARS)?.shadowRoot?.querySelector(".bar") ?? null;
    stage.furnish(box, [...boxOf("pasu-stage-tools"), ...boxOf(bar)]);
  }

  override render() {
    const { designer } = this;
    return html`
      <div
        class="host"
        ?data-gone=${this.holder.mode === "gone"}
        tabindex="0"
        role="application"
        aria-roledescription=${page.stage}
        aria-label=${page.thePot}
        aria-describedby="description keys"
        @keydown=${this.key}
      ></div>
      ${this.stands ? html`<canvas class="still" role="img" aria-label=${designer.description}></canvas>` : nothing}
      ${this.note()}
      ${this.hand()}${this.inside()}${this.witness()}${this.beneath()}${this.contrast()}
      ${
        designer.comparison.shown
          ? html`<pasu-captions .designer=${designer} .order=${designer.comparison.shown.order}></pasu-captions>`
          : nothing
      }
      <p id="keys" class="spoken">${page.stageKeys}</p>
      <div class="foot">
        <p id="description">${designer.description}</p>
        ${
          this.stands ? nothing : html`<pasu-stage-tools .designer=${designer} .stage=${this.stage}></pasu-stage-tools>`
        }
      </div>
    `;
  }

  /** Whether a still picture stands in the place of the stage. */
  private get stands(): boolean {
    const { mode } = this.holder;
    return mode === "still" || mode === "gone";
  }

  /** What pulls at the pot, or moves its parts, fetched when it is taken up. */
  private hand() {
    const { designer, stage } = this;
    const { pulling, placing } = designer.store.session;
    if (!(pulling || placing) || !stage || this.holder.mode !== "live") return nothing;
    if (placing) {
      this.fetch("pasu-place-handles", () => import("./place/place-handles"));
      return html`<pasu-place-handles .designer=${designer} .stage=${stage}></pasu-place-handles
        ><pasu-place-bar .designer=${designer} @bar-shown=${() => this.furnish()}></pasu-place-bar>`;
    }
    const kind = this.#kind.value;
    if (kind === "vertex-frame") {
      this.fetch("pasu-network-handles", () => import("./network/network-handles"));
      return html`<pasu-network-handles .designer=${designer} .stage=${stage}></pasu-network-handles>`;
    }
    if (kind === "blend") {
      this.fetch("pasu-section-handles", () => import("./blend/section-handles"));
      return html`<pasu-section-handles .designer=${designer} .stage=${stage}></pasu-section-handles>`;
    }
    this.fetch("pasu-pull", () => import("./pull/pull-layer"));
    return html`<pasu-pull .designer=${designer} .stage=${stage}></pasu-pull
      ><pasu-pull-bar .designer=${designer} @bar-shown=${() => this.furnish()}></pasu-pull-bar>`;
  }

  /** What is seen within a blend, fetched when somebody first looks. */
  private inside() {
    const { designer, stage } = this;
    const part = this.#within.value;
    if (part === null || !stage || this.holder.mode !== "live") return nothing;
    this.fetch("pasu-inside-layer", () => import("./blend/inside-layer"));
    return html`<pasu-inside-layer .designer=${designer} .stage=${stage} .within=${part}></pasu-inside-layer>`;
  }

  /** Where a report on the scene has its witness, by code that is fetched with the first. */
  private witness() {
    const { designer, stage } = this;
    if (!designer.witness.shown || !stage || this.holder.mode !== "live") return nothing;
    this.fetch("pasu-witness", () => import("./witness/witness-layer"));
    return html`<pasu-witness .designer=${designer} .stage=${stage}></pasu-witness>`;
  }

  /** Another scene that the design is held against, by code that is fetched with the first. */
  private contrast() {
    const { designer, stage } = this;
    if (!designer.contrast.there || !stage || this.holder.mode !== "live") return nothing;
    this.fetch("pasu-contrast", () => import("./contrast/contrast-layer"));
    return html`<pasu-contrast .designer=${designer} .stage=${stage}></pasu-contrast>`;
  }

  /** Of several parts, those that lie under a point. */
  private lookUnder(at: Spot): void {
    if (this.designer.store.ids.length > 1) this.under = at;
  }

  private beneath() {
    const { designer, stage, under } = this;
    if (!under || !stage || this.holder.mode !== "live") return nothing;
    this.fetch("pasu-under", () => import("./under/under-list"));
    const close = () => {
      this.under = null;
      this.host.focus({ preventScroll: true });
    };
    return html`<pasu-under .designer=${designer} .stage=${stage} .at=${under} @under-closed=${close}></pasu-under>`;
  }

  private readonly underAsked = ({ at }: UnderEvent): void => {
    const { left, top } = this.host.getBoundingClientRect();
    this.lookUnder({ x: at.x - left, y: at.y - top });
  };

  private note() {
    switch (this.holder.mode) {
      case "loading":
        return html`<div class="wheel" aria-hidden="true"></div>`;
      case "lost":
        return html`<p class="note" role="status">${page.lost}</p>`;
      case "gone":
        return html`<p class="note" role="status">
          ${page.lostForGood}
          <button class="button outlined" type="button" @click=${() => void this.holder.retry()}>${page.tryAgain}</button>
        </p>`;
      case "still":
        return html`<p class="note" role="status">${page.still}</p>`;
      case "live":
        return this.#waits.value ? html`<div class="wheel" aria-hidden="true"></div>` : nothing;
    }
  }

  override updated(_changed: PropertyValues): void {
    const { designer, stage } = this;
    const { session } = designer.store;
    const comparison = designer.comparison.shown;
    if (this.still) {
      this.resizes.observe(this.still);
      const { shown } = designer.surface;
      const { hidden } = session;
      if (shown !== this.pictured.shown || hidden !== this.pictured.hidden) void this.drawStill();
      this.pictured = { shown, hidden };
    }
    if (!stage) return;
    stage.theme(this.theme());
    stage.lengths(LENGTH_LABELS[this.#unit.value]);
    // These follow the pot by themselves; here is the stage that they have to have first.
    untracked(() => {
      this.display();
      this.measure();
      this.#made.value?.update();
    });
    stage.hold(this.#held.value);
    stage.overlays(session.overlays);
    // Of a pot of one part there is nothing to tell apart.
    stage.select(this.#several.value && session.selection.length > 0 ? selectedIds(designer.store) : []);
    if (designer.made && !this.making) void this.make(stage);
    if (comparison !== this.compared) {
      this.compared = comparison;
      if (comparison) void import("./stage-captions");
      stage.compare(comparison && stageModel(comparison.design, comparison.solved));
    }
  }

  /** What is made of the design is drawn by code that is fetched with the first thing to draw. */
  private async make(stage: Stage): Promise<void> {
    this.making = true;
    try {
      const { StageMade } = await import("./stage-made");
      if (stage !== this.stage) return;
      this.#made.value = new StageMade(this.designer, stage, this);
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  }

  private display(): void {
    const { designer, stage } = this;
    const { shown } = designer.surface;
    const { hidden } = designer.store.session;
    const within = this.#within.value;
    if (!stage || !shown || (shown === this.drawn && hidden === this.hiding && within === this.within)) return;
    const another = shown !== this.drawn;
    this.drawn = shown;
    this.hiding = hidden;
    this.within = within;
    designer.surface.recycle(stage.show(stageModel(shown.design, shown.solved, hidden, within)));
    if (!another) {
      this.#made.peek()?.update();
      return;
    }
    trace("shown", shown.change);
    if (shown.solved.lines) stage.lines(shown.solved.lines);
    stage.measure(designer.extents);
    // A wall of the design before, which is larger or smaller, must not stand in the view that is fitted.
    this.#made.peek()?.update();
    this.frame(shown, stage);
  }

  /** What the dimension lines say. */
  private measure(): void {
    const { extents } = this.designer;
    this.stage?.measure(extents);
  }

  /** Draws the curves whose numbers somebody points at. What they are is worked out by code that is fetched when somebody first does. */
  private async hint(): Promise<void> {
    const { designer } = this;
    const { places } = designer.pointed;
    // Elsewhere a field keeps the focus for long, and the pot is to be seen as it is.
    if (places.length === 0 || designer.store.session.tab !== "equation") {
      if (this.hinting) this.stage?.point([]);
      this.hinting = false;
      return;
    }
    const { design, part } = designer.state;
    const { pointedCurves } = await import("./pointed-curves");
    if (places !== designer.pointed.places) return;
    this.hinting = true;
    this.stage?.point(pointedCurves(design.parts[part], places), part);
  }

  /** Goes to a design that was just opened, and to one of quite another size that undo brought back. */
  private frame(shown: Shown, stage: Stage): void {
    const facts = shown.solved.facts;
    const size = facts ? Math.hypot(facts.width, facts.depth, facts.height) : this.framedSize;
    const ratio = this.framedSize > 0 ? size / this.framedSize : 1;
    const elsewhere = shown.travelled && (ratio > OTHER_SIZE || ratio < 1 / OTHER_SIZE);
    if (shown.framing === this.framed && !elsewhere) return;
    this.framed = shown.framing;
    this.framedSize = size;
    stage.fit();
    this.aim();
  }

  /** Where the camera is; null while there is none. */
  get camera(): Camera | null {
    return this.holder.stage?.looking ?? null;
  }

  /** Looks at the pot from there, as soon as it is on the stage. */
  look(camera: Camera): void {
    this.wanted = camera;
    if (this.framed >= 0) this.aim();
  }

  private aim(): void {
    if (this.wanted) this.holder.stage?.look(this.wanted, this.wanted.share, true);
    this.wanted = null;
  }

  private theme(): "light" | "dark" {
    const choice = this.designer.store.session.theme;
    if (choice !== "auto") return choice;
    return this.holder.dark ? "dark" : "light";
  }

  private async drawStill(): Promise<void> {
    if (!this.still) return;
    const { paintStill } = await import("./still-picture");
    const canvas = this.still;
    const shown = this.designer.surface.shown;
    if (!canvas || !shown) return;
    const { hidden } = this.designer.store.session;
    const { parts } = stageModel(shown.design, shown.solved, hidden);
    paintStill(
      parts.filter((part) => !part.hidden),
      canvas,
    );
  }

  private readonly key = (event: KeyboardEvent): void => {
    const { designer, stage } = this;
    if (!stage || stageKey(event, stage)) return;
    if (asksUnder(event)) {
      event.preventDefault();
      this.lookUnder({ x: this.host.clientWidth / 2, y: this.host.clientHeight / 2 });
      return;
    }
    const tool = TOOLS[event.key.toLowerCase()];
    if (!tool || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    designer.apply(tool(designer.state));
  };

  static override readonly styles = [
    base,
    buttons,
    wheel,
    css`
      :host {
        position: relative;
        display: block;
        min-width: 0;
        min-height: 0;
        overflow: hidden;
      }
      .host,
      .still {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      .host {
        touch-action: none;
      }
      .host[data-gone] {
        visibility: hidden;
      }
      .still {
        top: 76px;
        height: calc(100% - 76px);
      }
      .host:focus-visible {
        outline-offset: -4px;
        z-index: 1;
      }
      .foot {
        position: absolute;
        z-index: 4;
        inset: auto 0 0 0;
        display: flex;
        align-items: end;
        justify-content: space-between;
        gap: 12px;
        padding: 14px;
        pointer-events: none;
      }
      #description {
        max-width: 46ch;
        padding: 6px 11px;
        border-radius: 9px;
        background: var(--sheet);
        color: var(--soft);
        font-size: 0.9rem;
      }
      #description:empty {
        visibility: hidden;
      }
      .note {
        position: absolute;
        z-index: 2;
        inset: 14px 14px auto;
        width: fit-content;
        max-width: 62ch;
        margin-inline: auto;
        padding: 9px 14px;
        border: 1px solid var(--line);
        border-radius: 10px;
        background: var(--sheet);
      }
      @media (max-width: 53.6875em) {
        .foot {
          inset: 0;
          flex-direction: column;
          align-items: stretch;
          padding: 6px 8px 22px;
        }
        #description {
          align-self: center;
          max-width: none;
          padding: 2px 9px;
          font-size: 0.8rem;
          line-height: 1.35;
          text-align: center;
        }
        /* The captions, or the bar of a tool, stand in its place. */
        pasu-captions ~ .foot #description,
        :is(pasu-pull, pasu-place-bar) ~ .foot #description {
          visibility: hidden;
        }
        pasu-stage-tools {
          align-self: end;
          margin-top: auto;
        }
      }
      @media (max-width: 23.6875em) {
        #description {
          max-width: 100%;
          overflow: hidden;
          text-overflow: ellipsis;
          white-space: nowrap;
        }
      }
    `,
  ];
}

/** U, or the key of menus. */
function asksUnder({ key, shiftKey, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  if (ctrlKey || metaKey || altKey) return false;
  return key.toLowerCase() === "u" || key === "ContextMenu" || (key === "F10" && shiftKey);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-stage": PasuStage;
  }
}
