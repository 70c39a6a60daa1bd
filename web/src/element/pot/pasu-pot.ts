/** `<pasu-pot>`: a pot in any page. */

import { html, LitElement, nothing, type PropertyValues } from "lit";
import { property, query, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Field } from "../../document/schema";
import type { Design, Refusal, Sent } from "../../document/types";
import type { SolverClient } from "../../solver/client";
import { boundsWith, type SolvedParts } from "../../solver/solved";
import { base } from "../../ui/styles";
import { wheel } from "../../ui/wheel";
import { pot } from "../../words/english/pot";
import { LENGTH_LABELS } from "../../words/length";
import { COARSEST, gridFor } from "../../work/grid";
import { StageHolder } from "../stage-holder";
import { stageKey } from "../stage-keys";
import { stageModel } from "../stage-model";
import type { Contract, PotChange, PotOrbit, PotPicture, PotProblem } from "./contract";
import { familyIn, namesIn, shownFields } from "./controls";
import { type Orbit, orbitOf, orbitText, USUAL } from "./orbit";
import { potStyles } from "./pot-styles";
import type { PotWall } from "./pot-wall";
import type { Share } from "./shared";
import { solvers } from "./shared-solver";
import { type Sight, watchSight } from "./sights";
import type { Hand } from "./sliders";
import { sourceOf, textAt } from "./source";
import { came, comes, waitsForThoseSeen } from "./those-seen";

/** How finely pots are sampled: they are smaller than the designer's. The steps are those of {@link gridFor}. */
const FINENESS = 2;
const FINENESS_IN_HAND = 3;

/** A turn in this many seconds, as with `<model-viewer>`. */
const TURN = 12;

const HINT_MS = 1800;

/** A design on its way to the screen, or there. */
interface Shown {
  readonly design: Design;
  readonly link: string;
}

let count = 0;

export class PasuPotElement extends LitElement implements Contract {
  @property({ converter: (text) => text ?? "" }) src = "";
  @property() alt = "";
  @property() poster = "";
  @property() loading: "auto" | "lazy" | "eager" = "auto";
  @property({ attribute: "camera-orbit" }) cameraOrbit = "";
  @property({ attribute: "auto-rotate", type: Boolean }) autoRotate = false;
  @property() controls = "";
  @property() ui: "" | "view" | "sliders" = "";
  @property({ reflect: true, useDefault: true }) theme: "auto" | "light" | "dark" = "auto";

  @state() private shown: Shown | null = null;
  @state() private problem: Refusal | null = null;
  @state() private isLoaded = false;
  @state() private hint = false;
  @query(".stage") private readonly host!: HTMLDivElement;
  @query(".still") private readonly still!: HTMLCanvasElement | null;
  @query(".probe") private readonly probe!: HTMLElement;
  @query(".printed") private readonly printed!: HTMLCanvasElement;

  private readonly holder = new StageHolder(this, {
    host: () => this.host,
    options: () => ({
      theme: this.scheme(),
      lengths: LENGTH_LABELS[this.shown ? unitOf(this.shown.design) : "cm"],
      page: { takesWheel: () => this.shadowRoot?.activeElement === this.host },
      onDrawn: () => this.drawn(),
      onCamera: () => this.isLoaded && this.dispatchEvent(new Event("camera-change")),
    }),
    opened: () => this.display(),
    closing: () => {
      this.aimed = "";
      this.resizes.disconnect();
      this.wall?.dispose();
      this.wall = null;
    },
  });
  private readonly lane = `pot ${++count}`;
  private readonly resizes = new ResizeObserver(() => this.paint());
  private share: Share<SolverClient> | null = null;
  private wall: PotWall | null = null;
  private sight: Sight = { near: false, seen: false };
  private leave: readonly (() => void)[] = [];
  /** What is being fetched or read: what comes of anything older is not wanted any more. */
  private wanted = new AbortController();
  /** Of what was asked for and is not there yet. */
  private reading: AbortSignal | null = null;
  /** What is to be shown once the element is near the screen: the design that was set, or what `src` says. */
  private given: Design | null = null;
  private pending = false;
  private origin: Design | null = null;
  private solved: SolvedParts | null = null;
  /** Events that wait for their picture. */
  private untold = false;
  private aimed = "";
  private held: Shown | null = null;
  private changing: Promise<void> = Promise.resolve();
  /** What is shown of its parameters. */
  private fields: readonly Field[] = [];
  /** What was said of `controls`, each once; and what is still to be said. */
  private readonly complained = new Set<string>();
  private readonly complaints: Refusal[] = [];
  private hiding: ReturnType<typeof setTimeout> | undefined;

  /** Whether the design is on the screen. */
  get loaded(): boolean {
    return this.isLoaded;
  }

  get design(): Sent | null {
    return this.shown ? copy(this.shown.design) : null;
  }

  /** Null gives it up: then there is what `src` says, or no pot. */
  set design(design: Sent | null) {
    this.given = design ?? null;
    if (this.given || this.src !== "") this.renew();
    else this.unload();
  }

  /** The link of the design that is shown, with its `#`. */
  get link(): string | null {
    return this.shown ? `#${this.shown.link}` : null;
  }

  getCameraOrbit(): PotOrbit {
    const orbit = this.holder.stage?.looking ?? this.wantedOrbit();
    return { ...orbit, toString: () => orbitText(orbit) };
  }

  async toBlob({ width, height, transparent = false }: PotPicture = {}): Promise<Blob> {
    const { stage } = this.holder;
    if (!stage || !this.isLoaded) throw new DOMException(pot.unshown, "InvalidStateError");
    const ratio = devicePixelRatio || 1;
    const side = (given: number | undefined, own: number) => given ?? Math.max(1, Math.round(own * ratio));
    return await stage.picture(side(width, this.host.clientWidth), side(height, this.host.clientHeight), {
      transparent,
    });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.leave = [
      watchSight(this, (sight) => {
        this.sight = sight;
        if (!sight.seen) came(this);
        this.begin();
        this.turn();
      }),
      on(window, "beforeprint", () => this.print()),
      on(window, "afterprint", () => this.unprint()),
    ];
    this.begin();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.leave) leave();
    this.leave = [];
    this.sight = { near: false, seen: false };
    came(this);
    queueMicrotask(() => {
      if (!this.isConnected) this.end();
    });
  }

  /** Gives everything up; what was shown, or was to be, is shown when the element comes back. */
  private end(): void {
    const isUnderway = this.reading?.aborted === false;
    this.wanted.abort();
    this.share?.leave();
    this.share = null;
    this.solved = null;
    this.isLoaded = false;
    this.held = null;
    if (this.shown && !this.pending && !isUnderway) this.given = this.shown.design;
    this.pending = this.given !== null || this.src !== "";
  }

  /** Nothing is fetched before the element is near the screen. */
  private begin(): void {
    const { near, seen } = this.sight;
    const now = this.loading === "eager" || near || seen;
    if (!now || !this.isConnected || !this.hasUpdated) return;
    if (this.pending && !seen && waitsForThoseSeen(this.resume)) return;
    void this.holder.open();
    if (!this.pending) return;
    if (seen) comes(this);
    void this.read();
  }

  private readonly resume = () => this.begin();

  /** Another design is to be shown. */
  private renew(): void {
    this.pending = true;
    this.begin();
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("controls")) this.complained.clear();
    if (changed.has("src") && (this.hasUpdated || !this.given)) {
      this.given = null;
      this.pending = this.src !== "";
      if (!this.pending) this.unload();
    }
    this.fields = this.chooseFields();
  }

  /** Without a source there is no pot, as with `<model-viewer>`: the poster stands in its place again. */
  private unload(): void {
    this.pending = false;
    this.wanted.abort();
    this.shown = null;
    this.solved = null;
    this.origin = null;
    this.held = null;
    this.problem = null;
    this.untold = false;
    this.isLoaded = false;
    this.aimed = "";
    came(this);
    this.wall?.rest();
    this.holder.stage?.show({ parts: [], bounds: null });
  }

  override updated(changed: PropertyValues<this>): void {
    this.begin();
    // Not while rendering: whoever listens may set what is rendered.
    for (const refusal of this.complaints.splice(0)) this.tell(refusal);
    const { stage } = this.holder;
    if (this.holder.mode === "still") {
      if (this.still) this.resizes.observe(this.still);
      this.paint();
    }
    if (!stage) return;
    stage.theme(this.scheme());
    if (changed.has("cameraOrbit")) this.aim(false);
    this.turn();
  }

  /** The solver, from when it is first wanted. */
  private get solver() {
    this.share ??= solvers.take();
    return this.share.it;
  }

  private async read(): Promise<void> {
    this.pending = false;
    this.wanted.abort();
    this.wanted = new AbortController();
    const { signal } = this.wanted;
    this.reading = signal;
    try {
      const parsed = await this.solver.parse(await this.text(signal));
      if (signal.aborted || parsed.state === "superseded") return;
      if (parsed.state === "refused") throw parsed.refusal;
      const { design, link } = parsed.value;
      if (await this.solve({ design, link }, FINENESS, signal)) {
        // What a hand still holds is another pot, and not changed by it.
        this.held = null;
        this.origin = design;
        this.aimed = "";
        this.display();
      }
    } catch (error) {
      if (!signal.aborted) this.refuse(error);
    }
    if (this.reading === signal) this.reading = null;
  }

  /** What the solver has to read. */
  private async text(signal: AbortSignal): Promise<string> {
    if (this.given) return JSON.stringify(this.given);
    const source = sourceOf(this.src, document.baseURI);
    return source.kind === "link" ? source.link : await textAt(source.address, signal);
  }

  /** Brings a design to the screen; false when something newer came. */
  private async solve(next: Shown, fineness: number, signal: AbortSignal): Promise<boolean> {
    await this.holder.open();
    const { rows, columns } = gridFor(next.design, this.holder.mode === "still" ? COARSEST : fineness);
    const outcome = await this.solver.mesh(this.lane, next.design, rows, columns);
    if (signal.aborted || outcome.state === "superseded") return false;
    if (outcome.state === "refused") throw outcome.refusal;
    this.solved = outcome.value;
    this.shown = next;
    this.problem = null;
    this.untold = true;
    return true;
  }

  /** The design that was there stays. */
  private refuse(error: unknown): void {
    const refusal = isRefusal(error) ? error : { code: "internal", path: "", message: String(error) };
    this.problem = refusal;
    came(this);
    this.tell(refusal);
  }

  private tell({ code, path, message }: Refusal): void {
    // What stopped says nothing of itself.
    const detail: PotProblem = { type: "loadfailure", code, path, message: message || pot.stopped };
    this.dispatchEvent(new CustomEvent("error", { detail }));
  }

  private display(): void {
    const { stage } = this.holder;
    if (!this.solved || !this.shown) return;
    if (!stage) {
      this.paint();
      return;
    }
    stage.lengths(LENGTH_LABELS[unitOf(this.shown.design)]);
    stage.show(stageModel(this.shown.design, this.solved));
    this.aim(true);
    this.turn();
    void this.raise();
  }

  /** Draws the wall beside the surface, which does not wait for it; under the hand there is none. */
  private async raise(): Promise<void> {
    const { shown, solved } = this;
    const { stage } = this.holder;
    const walled = shown?.design.parts.some(({ wall }) => wall !== undefined) ?? false;
    if (!walled && !this.wall) return;
    // Without a network there is the surface alone.
    const fetched = await import("./pot-wall").catch(() => null);
    if (!fetched || !stage || !shown || !solved || stage !== this.holder.stage || shown !== this.shown) return;
    this.wall ??= new fetched.PotWall(stage, this.lane);
    if (this.held) this.wall.rest();
    else await this.wall.show(shown.design, solved, (walls) => boundsWith(walls, shown.design, solved.parts));
  }

  /** Looks from where the page says, once for every design. */
  private aim(atOnce: boolean): void {
    const key = this.cameraOrbit === "" ? "auto" : this.cameraOrbit;
    if (!this.solved || key === this.aimed) return;
    this.aimed = key;
    const orbit = this.wantedOrbit((refusal) => this.tell(refusal));
    this.holder.stage?.look(orbit, orbit.share, atOnce);
  }

  private wantedOrbit(refused: (refusal: Refusal) => void = () => {}): Orbit {
    if (this.cameraOrbit === "") return USUAL;
    try {
      return orbitOf(this.cameraOrbit);
    } catch (error) {
      if (isRefusal(error)) refused(error);
      return USUAL;
    }
  }

  /** Goes round where somebody can see it, and not under the hand. */
  private turn(): void {
    const focused = this.shadowRoot?.activeElement === this.host;
    const turning = this.autoRotate && this.sight.seen && !focused;
    this.holder.stage?.spin(turning ? (2 * Math.PI) / TURN : 0);
  }

  /** A frame was drawn. */
  private drawn(): void {
    if (!this.untold || !this.shown) return;
    this.untold = false;
    came(this);
    if (this.held) return;
    this.isLoaded = true;
    this.dispatchEvent(new CustomEvent("load", { detail: changeOf(this.shown) }));
  }

  /** The picture of a browser without WebGL2. */
  private paint(): void {
    const { solved, shown, still } = this;
    if (!solved || !shown || !still) return;
    void import("../still-picture").then(({ paintStill }) => {
      if (solved !== this.solved || still.clientWidth === 0) return;
      paintStill(stageModel(shown.design, solved).parts, still);
      this.drawn();
    });
  }

  /** Browsers do not print what is on the graphics card. */
  private print(): void {
    const { stage } = this.holder;
    const { clientWidth, clientHeight } = this.host;
    if (!stage || !this.isLoaded || clientWidth === 0 || clientHeight === 0) return;
    const picture = stage.still(2 * clientWidth, 2 * clientHeight);
    if (!picture) return;
    this.printed.width = picture.width;
    this.printed.height = picture.height;
    this.printed.getContext("2d")?.drawImage(picture, 0, 0);
  }

  private unprint(): void {
    this.printed.width = 0;
    this.printed.height = 0;
  }

  private readonly hand: Hand = {
    set: (design) => {
      const { shown } = this;
      if (!shown) return;
      this.held ??= shown;
      this.wanted.abort();
      this.wanted = new AbortController();
      const { signal } = this.wanted;
      // The link is made when the hand lets go.
      this.shown = { design, link: shown.link };
      this.dispatchEvent(new CustomEvent("input", { bubbles: true, detail: { design: copy(design) } }));
      this.changing = this.solve(this.shown, FINENESS_IN_HAND, signal).then(
        (done) => {
          if (done) this.display();
        },
        (error) => {
          if (!signal.aborted) this.refuse(error);
        },
      );
    },
    done: () => void this.settle(),
    cancel: () => {
      const { held } = this;
      if (!held) return;
      void this.putBack(held);
    },
  };

  /** The hand took back what it did: what it held, as fine as it was. */
  private async putBack(held: Shown): Promise<void> {
    this.wanted.abort();
    this.wanted = new AbortController();
    const { signal } = this.wanted;
    this.shown = held;
    this.dispatchEvent(new CustomEvent("input", { bubbles: true, detail: { design: copy(held.design) } }));
    try {
      if (!(await this.solve(held, FINENESS, signal))) return;
      this.held = null;
      this.untold = false;
      this.display();
    } catch (error) {
      if (!signal.aborted) this.refuse(error);
    }
  }

  /** The hand let go: the fine mesh, and the link. */
  private async settle(): Promise<void> {
    const { held, shown, wanted } = this;
    if (!held || !shown) return;
    await this.changing;
    if (this.wanted !== wanted || !this.isConnected) return;
    const { signal } = wanted;
    try {
      const parsed = await this.solver.parse(JSON.stringify(shown.design));
      if (signal.aborted || parsed.state === "superseded") return;
      if (parsed.state === "refused") throw parsed.refusal;
      if (!(await this.solve(parsed.value, FINENESS, signal))) return;
      this.held = null;
      this.untold = false;
      this.display();
      this.dispatchEvent(new CustomEvent("change", { bubbles: true, detail: changeOf(parsed.value) }));
    } catch (error) {
      if (signal.aborted) return;
      await this.putBack(held);
      if (this.shown === held) this.refuse(error);
    }
  }

  /** Light or dark, whichever the style of the page makes of this element. */
  private scheme(): "light" | "dark" {
    return getComputedStyle(this.probe).color === "rgb(255, 255, 255)" ? "light" : "dark";
  }

  private chooseFields(): readonly Field[] {
    const { shown } = this;
    if (!shown || this.ui === "view") return [];
    const named = namesIn(this.controls).length > 0;
    if (!named) return this.ui === "sliders" ? (familyIn(shown.design)?.fields ?? []) : [];
    return shownFields(shown.design, this.controls, (refusal) => {
      if (this.complained.has(refusal.message)) return;
      this.complained.add(refusal.message);
      this.complaints.push(refusal);
    });
  }

  override render() {
    const { mode } = this.holder;
    const label = this.alt || this.shown?.design.title || pot.aPot;
    // Where there is no pot there is nothing to turn.
    const turns = mode !== "still" && this.isLoaded;
    return html`
      <span class="probe" aria-hidden="true" @transitionrun=${() => this.holder.stage?.theme(this.scheme())}></span>
      <div class="frame">
      <div class="view" part="view">
        <div
          class="stage"
          part="stage"
          tabindex=${turns ? 0 : nothing}
          role=${mode === "still" ? nothing : turns ? "application" : "img"}
          aria-roledescription=${turns ? pot.view : nothing}
          aria-label=${mode === "still" ? nothing : label}
          aria-describedby=${turns ? "keys" : nothing}
          @keydown=${this.key}
          @focus=${this.turn}
          @blur=${this.turn}
          @touchmove=${{ handleEvent: this.touched, passive: true }}
        ></div>
        ${mode === "still" ? html`<canvas class="still" part="stage" role="img" aria-label=${label}></canvas>` : nothing}
        <canvas class="printed" width="0" height="0" aria-hidden="true"></canvas>
        <div class="poster" part="poster" ?data-done=${this.isLoaded}>
          <slot name="poster">${this.poster === "" ? this.wheel() : html`<img src=${this.poster} alt="" />`}</slot>
        </div>
        <p id="keys" class="spoken">${pot.keys}</p>
        <div class="over"><slot></slot></div>
        <p class="hint" part="hint" aria-hidden="true" ?data-shown=${this.hint}>${pot.fingers}</p>
        ${this.message()}
      </div>
      ${this.sliders()}
      </div>
    `;
  }

  /** Something is on its way, and nothing else is said of it. */
  private wheel() {
    return this.problem === null && this.holder.mode !== "lost" && this.src !== ""
      ? html`<span class="wheel"></span>`
      : nothing;
  }

  private message() {
    const words =
      this.holder.mode === "lost" ? pot.lost : this.problem === null ? "" : this.isLoaded ? pot.unchanged : pot.unshown;
    return words === "" ? nothing : html`<p class="message" part="message" role="status">${words}</p>`;
  }

  private sliders() {
    const { fields } = this;
    if (fields.length === 0) return nothing;
    // Without a network there is the pot alone.
    import("./sliders").catch(() => {});
    return html`<div class="sliders" part="sliders" role="group" aria-label=${pot.parameters} @input=${keep} @change=${keep}
      @number-change=${keep} @number-done=${keep} @number-cancel=${keep}>
      <pasu-pot-sliders
        .design=${this.shown?.design ?? null}
        .origin=${this.origin}
        .fields=${fields}
        .problem=${this.problem}
        .hand=${this.hand}
      ></pasu-pot-sliders>
    </div>`;
  }

  private readonly key = (event: KeyboardEvent): void => {
    // What the pot takes is not the page's as well: slides turn by the same keys.
    if (this.holder.stage && stageKey(event, this.holder.stage)) event.stopPropagation();
  };

  /** One finger scrolls the page: whoever meant to turn the pot is told how. */
  private readonly touched = (event: TouchEvent): void => {
    clearTimeout(this.hiding);
    this.hint = event.touches.length === 1;
    this.hiding = setTimeout(() => {
      this.hint = false;
    }, HINT_MS);
  };

  static override readonly styles = [base, wheel, potStyles];
}

/** What is handed out is nobody else's. */
function copy(design: Design): Sent {
  return structuredClone(design) as Sent;
}

function changeOf({ design, link }: Shown): PotChange {
  return { design: copy(design), link: `#${link}` };
}

/** What happens inside is told by the element's own events. */
function keep(event: Event): void {
  event.stopPropagation();
}

function on(target: EventTarget, type: string, listener: () => void): () => void {
  target.addEventListener(type, listener);
  return () => target.removeEventListener(type, listener);
}

function isRefusal(error: unknown): error is Refusal {
  return typeof error === "object" && error !== null && "code" in error && "path" in error && "message" in error;
}
