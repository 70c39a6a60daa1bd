/** The stage in the page: loads the renderer beside the solver, gives it what was solved, and passes the keyboard on. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { KIND_NAMES } from "../document/kinds";
import { looksOf, unitOf } from "../document/look";
import type { Stage } from "../render/stage";
import { toggleOverlay } from "../state/actions";
import type { Overlays } from "../state/session";
import type { Comparison, Shown } from "./designer";
import { DesignerElement } from "./element";
import { type IconName, icon } from "./icons";
import "./menu";
import { base, buttons } from "./styles";
import { trace } from "./trace";

type ViewName = "three-quarter" | "front" | "side" | "top" | "below";

const VIEWS: readonly { readonly name: ViewName; readonly label: string }[] = [
  { name: "three-quarter", label: "Three-quarter" },
  { name: "front", label: "Front" },
  { name: "side", label: "Side" },
  { name: "top", label: "Top" },
  { name: "below", label: "Below" },
];

const OVERLAYS: readonly { readonly name: keyof Overlays; readonly label: string }[] = [
  { name: "isoU", label: "Lines round the pot (u)" },
  { name: "isoV", label: "Lines up the wall (v)" },
  { name: "wireframe", label: "Wireframe" },
  { name: "boundary", label: "Rim, foot and tangents" },
  { name: "axes", label: "Axes and dimensions" },
];

const TURN = Math.PI / 18;
const PAN = 40;
const ZOOM = 1.2;
/** Undo across a change of size by more than this fits the view again. */
const OTHER_SIZE = 1.6;

const ZOOMS: readonly {
  readonly label: string;
  readonly key: string;
  readonly icon: IconName;
  readonly act: (stage: Stage) => void;
}[] = [
  { label: "Zoom out", key: "−", icon: "less", act: (stage) => stage.zoom(1 / ZOOM) },
  { label: "Zoom in", key: "+", icon: "add", act: (stage) => stage.zoom(ZOOM) },
  { label: "Fit to view", key: "F", icon: "fit", act: (stage) => stage.fit() },
];

const REDUCED = "(prefers-reduced-motion: reduce)";
const DARK = "(prefers-color-scheme: dark)";

@customElement("pasu-stage")
export class PasuStage extends DesignerElement {
  @state() private mode: "loading" | "live" | "lost" | "still" = "loading";
  @query(".host") private readonly host!: HTMLDivElement;
  @query(".still") private readonly still!: HTMLCanvasElement | null;
  private stage: Stage | null = null;
  private drawn: Shown | null = null;
  private compared: Comparison | null = null;
  private said = "";
  private framed = -1;
  private framedSize = 0;
  private readonly dark = matchMedia(DARK);
  private readonly reduced = matchMedia(REDUCED);
  private readonly resizes = new ResizeObserver(() => void this.drawStill());

  override connectedCallback(): void {
    super.connectedCallback();
    this.dark.addEventListener("change", this.mediaChanged);
    this.reduced.addEventListener("change", this.mediaChanged);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dark.removeEventListener("change", this.mediaChanged);
    this.reduced.removeEventListener("change", this.mediaChanged);
    this.resizes.disconnect();
    this.stage?.dispose();
    this.stage = null;
  }

  override firstUpdated(): void {
    void this.load();
  }

  /** The picture as it is seen; null while there is no stage to take it from. */
  picture(width: number, height: number, transparent: boolean): Promise<Blob> | null {
    return this.stage?.picture(width, height, { transparent }) ?? null;
  }

  override focus(options?: FocusOptions): void {
    this.host.focus(options);
  }

  private async load(): Promise<void> {
    try {
      const { Stage } = await import("../render/stage");
      if (!this.isConnected) return;
      if (!Stage.supported()) {
        this.mode = "still";
        return;
      }
      this.stage = new Stage(this.host, {
        theme: this.theme(),
        reducedMotion: this.reduced.matches,
        unit: unitOf(this.designer.state.design),
        onContextLost: () => {
          this.mode = "lost";
        },
        onContextRestored: () => {
          this.mode = "live";
        },
        onDrawn: () => {
          if (this.drawn) trace("drawn", this.drawn.change);
        },
        onCost: (milliseconds, coarsest) => {
          const times = this.drawn?.solved.times;
          if (times) this.designer.pace.learn(times.done - times.begun + milliseconds, coarsest);
        },
      });
      this.mode = "live";
    } catch {
      this.mode = "still";
    }
  }

  override render() {
    const { designer } = this;
    const overlays = designer.state.session.overlays;
    return html`
      <div
        class="host"
        tabindex="0"
        role="application"
        aria-roledescription="3D view"
        aria-label="The pot"
        aria-describedby="description keys"
        @keydown=${this.key}
      ></div>
      ${this.mode === "still" ? html`<canvas class="still" role="img" aria-label=${designer.description}></canvas>` : nothing}
      ${this.note()}
      ${designer.comparison ? this.captions(designer.comparison) : nothing}
      <p id="keys" class="spoken">Arrow keys turn the pot, plus and minus zoom, F fits it to the view.</p>
      <div class="foot">
        <p id="description">${designer.description}${this.accuracy()}</p>
        ${
          this.mode === "still"
            ? nothing
            : html`<div class="tools" role="toolbar" aria-label="View">
                <div class="views">
                  ${VIEWS.map(
                    ({ name, label }) =>
                      html`<button class="button" type="button" @click=${() => this.stage?.view(name)}>${label}</button>`,
                  )}
                </div>
                <div class="zooms">
                  ${ZOOMS.map(
                    ({ label, key, icon: name, act }) =>
                      html`<button class="button bare" type="button" aria-label=${label} title="${label} (${key})" @click=${() => this.stage && act(this.stage)}>
                        ${icon(name)}
                      </button>`,
                  )}
                </div>
                <pasu-menu class="small" label="View" icon="view" side="up" bare>
                  ${VIEWS.map(
                    ({ name, label }) =>
                      html`<button class="button item" type="button" @click=${() => this.stage?.view(name)}>${label}</button>`,
                  )}
                  ${ZOOMS.map(
                    ({ label, icon: name, act }) =>
                      html`<button class="button item phone" type="button" @click=${() => this.stage && act(this.stage)}>
                        ${icon(name)}<span>${label}</span>
                      </button>`,
                  )}
                </pasu-menu>
                <pasu-menu label="Overlays" icon="layers" side="up" bare>
                  ${OVERLAYS.map(
                    ({ name, label }) => html`<label class="check">
                      <input
                        type="checkbox"
                        .checked=${overlays[name]}
                        @change=${() => designer.apply(toggleOverlay(designer.state, name))}
                      />
                      <span>${label}</span>
                    </label>`,
                  )}
                </pasu-menu>
              </div>`
        }
      </div>
    `;
  }

  /** Keeps its place while a gesture is under way, when nobody knows it. */
  private accuracy() {
    const { accuracy } = this.designer;
    if (accuracy !== "") this.said = accuracy;
    return this.said === "" ? nothing : html` <span class="accuracy" ?data-old=${accuracy === ""}>${this.said}</span>`;
  }

  private note() {
    switch (this.mode) {
      case "loading":
        return html`<div class="wheel" aria-hidden="true"></div>`;
      case "lost":
        return html`<p class="note" role="status">The graphics card was taken away for a moment. The picture comes back by itself.</p>`;
      case "still":
        return html`<p class="note" role="status">
          This browser has no WebGL2, so the pot stands still. Everything else works: change it, save it, share it.
        </p>`;
      case "live":
        return this.designer.shown === null && this.designer.problem === null
          ? html`<div class="wheel" aria-hidden="true"></div>`
          : nothing;
    }
  }

  private captions(comparison: Comparison) {
    const { design, session } = this.designer.state;
    const kind = design.parts[session.part]?.shape.kind ?? "second-order";
    return html`<div class="captions">
      <p>${KIND_NAMES[kind]} <span>as it is</span></p>
      <p>${KIND_NAMES[comparison.order]} <span>to compare</span></p>
    </div>`;
  }

  override updated(_changed: PropertyValues): void {
    const { designer, stage } = this;
    const { comparison, state: now } = designer;
    if (this.still) {
      this.resizes.observe(this.still);
      if (designer.shown !== this.drawn) void this.drawStill();
      this.drawn = designer.shown;
    }
    if (!stage) return;
    stage.theme(this.theme());
    stage.unit(unitOf(now.design));
    this.display();
    stage.overlays(now.session.overlays);
    if (comparison !== this.compared) {
      this.compared = comparison;
      stage.compare(comparison ? { mesh: comparison.mesh, looks: [...comparison.looks] } : null);
    }
  }

  /** A new surface goes to the stage before the page writes about it. */
  protected override told(): void {
    this.display();
    super.told();
  }

  private display(): void {
    const { designer, stage } = this;
    const { shown } = designer;
    if (!stage || !shown || shown === this.drawn) return;
    this.drawn = shown;
    const before = stage.show(shown.solved.mesh, looksOf(shown.design));
    if (before) designer.solver.recycle(before);
    trace("shown", shown.change);
    if (shown.solved.lines) stage.lines(shown.solved.lines);
    this.frame(shown, stage);
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
  }

  private theme(): "light" | "dark" {
    const choice = this.designer.state.session.theme;
    if (choice !== "auto") return choice;
    return this.dark.matches ? "dark" : "light";
  }

  private readonly mediaChanged = (): void => {
    this.stage?.reducedMotion(this.reduced.matches);
    this.requestUpdate();
  };

  private async drawStill(): Promise<void> {
    if (!this.still) return;
    const { drawStill } = await import("./still-picture");
    const canvas = this.still;
    const shown = this.designer.shown;
    if (!canvas || !shown) return;
    const ratio = Math.min(2, devicePixelRatio || 1);
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    drawStill(shown.solved.mesh, canvas, this.theme() === "dark" ? [0.62, 0.78, 0.71] : [0.66, 0.8, 0.73]);
  }

  private readonly key = (event: KeyboardEvent): void => {
    const { stage } = this;
    if (!stage || event.ctrlKey || event.metaKey || event.altKey) return;
    const view = VIEWS[Number(event.key) - 1];
    const arrow = ARROWS[event.key];
    if (arrow) {
      const [x, y] = arrow;
      if (event.shiftKey) stage.pan(-PAN * x, -PAN * y);
      else stage.orbit(TURN * x, TURN * y);
    } else if (view) stage.view(view.name);
    else if (event.key === "+" || event.key === "=") stage.zoom(ZOOM);
    else if (event.key === "-" || event.key === "_" || event.key === "−") stage.zoom(1 / ZOOM);
    else if (event.key === "f" || event.key === "F") stage.fit();
    else return;
    event.preventDefault();
  };

  static override readonly styles = [
    base,
    buttons,
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
        z-index: 2;
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
      .accuracy[data-old] {
        visibility: hidden;
      }
      #description:empty {
        visibility: hidden;
      }
      .tools {
        display: flex;
        flex: none;
        align-items: center;
        padding: 4px;
        border: 1px solid var(--line);
        border-radius: 13px;
        background: var(--sheet);
        box-shadow: 0 3px 14px var(--shadow);
        pointer-events: auto;
      }
      .views {
        display: flex;
        margin-right: 4px;
        padding-right: 4px;
        border-right: 1px solid var(--line);
      }
      .views .button {
        padding: 0 10px;
        font-size: 0.9rem;
      }
      .zooms {
        display: flex;
      }
      .small {
        display: none;
      }
      @media (min-width: 860px) {
        .phone {
          display: none !important;
        }
      }
      .item {
        justify-content: flex-start;
      }
      .check {
        align-items: center;
        gap: 10px;
        min-height: var(--touch);
        padding: 0 10px;
        border-radius: 8px;
        white-space: nowrap;
        cursor: pointer;
      }
      .check:hover {
        background: var(--well);
      }
      .check input {
        width: 18px;
        height: 18px;
        margin: 0;
        accent-color: var(--accent);
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
      .captions {
        position: absolute;
        z-index: 2;
        inset: 14px 0 auto;
        display: grid;
        grid-template-columns: 1fr 1fr;
        pointer-events: none;
      }
      .captions p {
        justify-self: center;
        padding: 5px 12px;
        border-radius: 9px;
        background: var(--sheet);
        border: 1px solid var(--line);
        font-weight: 550;
      }
      .captions span {
        color: var(--soft);
        font-weight: 400;
      }
      .wheel {
        position: absolute;
        inset: 0;
        margin: auto;
        width: 44px;
        height: 44px;
        border: 3px solid var(--line);
        border-top-color: var(--accent);
        border-radius: 50%;
        animation: turn 1s linear infinite;
      }
      @keyframes turn {
        to {
          rotate: 1turn;
        }
      }
      @media (max-width: 1239px) {
        .views {
          display: none;
        }
        .small {
          display: inline-block;
        }
      }
      @media (max-width: 859px) {
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
        /* Under the pot: above it a third line would lie over the rim. */
        .accuracy {
          position: absolute;
          inset: auto auto 24px 8px;
          padding: 0 7px;
          border-radius: 7px;
          background: var(--sheet);
          font-size: 0.68rem;
          white-space: nowrap;
        }
        .captions ~ .foot .accuracy {
          display: none;
        }
        .captions {
          inset: auto 0 24px;
          padding-right: 104px;
          font-size: 0.86rem;
        }
        .captions span {
          display: none;
        }
        .tools {
          align-self: end;
          margin-top: auto;
          padding: 1px;
        }
        .zooms {
          display: none;
        }
        .small {
          --menu-columns: auto auto;
        }
      }
    `,
  ];
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

declare global {
  interface HTMLElementTagNameMap {
    "pasu-stage": PasuStage;
  }
}
