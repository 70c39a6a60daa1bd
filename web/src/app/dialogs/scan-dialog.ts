/** A pot from a scan: a file of triangles becomes rings with waves, which are seen against it before they are taken. */

import { css, html, nothing, svg } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Levels } from "../../document/scanned/levels";
import { DIRECTIONS } from "../../document/scanned/section";
import { DesignerElement } from "../../element/designer-element";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, fields } from "../../ui/styles";
import { page } from "../../words/english/page";
import { scan as words } from "../../words/english/scan";
import { cannotWords } from "../../words/freeing";
import { spokenLength } from "../../words/quantities";
import { drawnPot } from "../../work/drawn";
import { pickFile } from "../../work/files";
import { finenessOf } from "../../work/freeing";
import { type Scanned, scaled, scannedOf } from "../../work/scanned";
import type { Outcome } from "../../worker/port";
import { trianglesOf } from "../scanning/mesh-file";

/** Scans are in millimetres, if they say nothing else: nobody's scan of a pot is larger than this in centimetres. */
const MILLIMETRES = { cm: 10, mm: 1, in: 25.4 } as const;
const LARGE = 60;

/** What a hand made is not truer than this part of its height. */
const FINE = 5;

const DIGITS = 2;
const PAUSE_MS = 250;
const SIZE = 320;
const MARGIN = 24;

type Up = "z" | "y";

@customElement("pasu-scan")
export class PasuScan extends DesignerElement {
  @state() private busy = false;
  @state() private trouble = "";
  @state() private up: Up = "z";
  @state() private height = 0;
  @state() private typed: number | null = null;
  @state() private levels: Levels | null = null;
  @state() private coming = false;
  @state() private found: Outcome<Scanned> | null = null;
  private triangles: Float32Array | null = null;
  private asked: object | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("dragover", keepToItself);
    this.addEventListener("drop", this.dropped);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("dragover", keepToItself);
    this.removeEventListener("drop", this.dropped);
    clearTimeout(this.timer);
    this.asked = null;
  }

  private get tolerance(): number {
    return this.typed ?? FINE * finenessOf({ height: this.height, greatest: { direction: 0, low: 0, width: 0 } });
  }

  private get ready(): Scanned | null {
    return !this.coming && this.found?.state === "done" ? this.found.value : null;
  }

  override render() {
    const { levels } = this;
    return html`<pasu-dialog ruled heading=${words.heading} @dialog-closed=${this.close}>
      <p class="lead">${words.lead}</p>
      <button class="button outlined" type="button" ?disabled=${this.busy} @click=${this.pick}>${icon("open")}<span>${words.file}</span></button>
      ${this.trouble === "" ? nothing : html`<p class="trouble" role="alert">${this.trouble}</p>`}
      ${
        this.triangles
          ? html`<label class="up">
              <span>${words.up}</span>
              <select class="field" @change=${this.turn}>
                ${(["z", "y"] as const).map((way) => html`<option value=${way} ?selected=${way === this.up}>${words.ups[way]}</option>`)}
              </select>
            </label>`
          : nothing
      }
      ${levels ? this.opened(levels) : nothing}
      <p slot="actions" class="found" role="status">${this.told()}</p>
      <button slot="actions" class="button primary" type="button" ?disabled=${this.ready === null} @click=${this.use}>${words.use}</button>
    </pasu-dialog>`;
  }

  private opened(levels: Levels) {
    const { ready } = this;
    const gap = (levels.heights[1] ?? 0) - (levels.heights[0] ?? 0);
    const cut = (levels.heights[0] ?? 0) > 2 * gap || levels.height - (levels.heights.at(-1) ?? 0) > 2 * gap;
    return html`
      ${this.picture(levels)}
      ${this.number(words.height, words.heightHelp, this.height, (height) => {
        this.height = height;
      })}
      ${this.number(words.tolerance, words.toleranceHelp, this.tolerance, (tolerance) => {
        this.typed = tolerance;
      })}
      ${cut ? html`<p class="hint">${words.cut}</p>` : nothing}
      ${ready?.without ? html`<p class="hint">${words.standsOut(this.length(ready.without.rms), this.length(ready.without.most))}</p>` : nothing}
      ${ready && (ready.without ?? ready).most > this.tolerance ? html`<p class="hint">${words.further}</p>` : nothing}
    `;
  }

  private length(value: number): string {
    return spokenLength(value, unitOf(this.designer.store.design), DIGITS);
  }

  private number(label: string, help: string, value: number, set: (value: number) => void) {
    return html`<pasu-number
      .label=${label}
      .unit=${unitOf(this.designer.store.design)}
      .help=${help}
      .value=${value}
      .min=${0}
      .max=${label === words.height ? 2 * this.height : this.height / 20}
      .step=${label === words.height ? this.height / 200 : this.height / 2000}
      @number-change=${({ value: typed }: NumberChangeEvent) => {
        if (!(typed > 0)) return;
        set(typed);
        this.seekSoon();
      }}
    ></pasu-number>`;
  }

  /** As it is seen with its widest place at the right; darker is what is within the least radius of every level. Rings are seen at their mean. */
  private picture(levels: Levels) {
    const widest = levels.radii.reduce((most, section) => section.reduce((a, b) => Math.max(a, b), most), 0);
    const scale = (SIZE - 2 * MARGIN) / Math.max(levels.height, 2 * widest);
    const foot = (SIZE + scale * levels.height) / 2;
    const spot = (radius: number, height: number) =>
      `${(SIZE / 2 + scale * radius).toFixed(1)} ${(foot - scale * height).toFixed(1)}`;
    const side = (of: (section: Float64Array) => number) =>
      levels.heights.map((height, i) => spot(of(levels.radii[i] as Float64Array), height));
    const around = (of: (section: Float64Array, side: 1 | -1) => number) => {
      const [right, left] = [side((section) => of(section, 1)), side((section) => -of(section, -1)).reverse()];
      return `M${right.join("L")}L${left.join("L")}Z`;
    };
    const front = directionOf(levels, widest);
    const whole = around((section, at) => seenAt(section, front + (at === 1 ? 0 : DIRECTIONS / 2)));
    const core = around((section) => section.reduce((a, b) => Math.min(a, b)));
    const times = this.height / levels.height;
    return html`<svg viewBox="0 0 ${SIZE} ${SIZE}" role="img" aria-label=${words.picture}>
      <path class="whole" d=${whole} />
      <path class="core" d=${core} />
      ${(this.ready?.shape.rings ?? []).map(({ r, z }) => {
        const [radius, height] = [r.mean / times, z.mean / times];
        return svg`<path class="hoop" d="M${spot(-radius, height)}L${spot(radius, height)}" />`;
      })}
    </svg>`;
  }

  private told() {
    const { found, ready } = this;
    const unit = unitOf(this.designer.store.design);
    if (this.busy) return words.reading;
    if (this.coming) return words.coming;
    if (!this.levels || !found) return this.trouble === "" ? words.nothing : nothing;
    if (found.state === "refused") return html`<span class="warn">${cannotWords(found.refusal, unit)}</span>`;
    if (!ready) return nothing;
    const { rings } = ready.shape;
    const waves = new Set(rings.flatMap(({ r }) => (r.waves ?? []).map(({ n }) => n)));
    return words.found(rings.length, waves.size, this.length(ready.rms), this.length(ready.most));
  }

  private readonly pick = async (): Promise<void> => {
    const file = await pickFile(".stl,.obj,.ply");
    if (file) await this.open(file);
  };

  private readonly dropped = (event: DragEvent): void => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    keepToItself(event);
    void this.open(file);
  };

  private async open(file: File): Promise<void> {
    this.busy = true;
    this.trouble = "";
    this.levels = null;
    this.found = null;
    this.triangles = null;
    const triangles = await trianglesOf(file).catch(() => null);
    this.busy = false;
    if (triangles === null) this.trouble = page.unfetched;
    else if (typeof triangles === "string") this.trouble = words.refused[triangles];
    else {
      this.triangles = triangles;
      this.height = 0;
      this.typed = null;
      // No file says which way is up: modellers who write OBJ have y, others z. Where the one is no pot, the other may be.
      const [first, second]: readonly [Up, Up] = /\.obj$/i.test(file.name) ? ["y", "z"] : ["z", "y"];
      await this.read(first);
      if (!this.levels) await this.read(second);
    }
  }

  private readonly turn = (event: Event): void => {
    this.height = 0;
    void this.read((event.target as HTMLSelectElement).value as Up);
  };

  private async read(up: Up): Promise<void> {
    const { triangles, designer } = this;
    if (!triangles) return;
    this.up = up;
    this.busy = true;
    const made = await designer.openMade();
    const positions = up === "z" ? triangles : upright(triangles);
    const outcome = made ? await made.maker.ask({ kind: "levels", positions }) : null;
    this.busy = false;
    if (this.triangles !== triangles || this.up !== up) return;
    this.levels = outcome?.state === "done" ? outcome.value : null;
    this.found = null;
    this.trouble = this.levels ? "" : made ? words.refused["no-pot"] : page.unfetched;
    if (!this.levels) return;
    const { height } = this.levels;
    this.height = Number(
      (height > LARGE ? height / MILLIMETRES[unitOf(designer.store.design)] : height).toPrecision(4),
    );
    this.seekSoon();
  }

  private seekSoon(): void {
    clearTimeout(this.timer);
    const { levels } = this;
    if (!levels) return;
    const asked = {};
    this.asked = asked;
    this.coming = true;
    this.timer = setTimeout(() => void this.seek(asked, scaled(levels, this.height)), PAUSE_MS);
  }

  private async seek(asked: object, levels: Levels): Promise<void> {
    const { designer } = this;
    const made = await designer.openMade();
    const found = made ? await scannedOf(made.maker, designer.solver, levels, this.tolerance) : null;
    if (this.asked !== asked || found?.state === "superseded") return;
    this.coming = false;
    this.found = found;
  }

  private readonly use = (): void => {
    const { ready, designer } = this;
    if (!ready) return;
    const unit = unitOf(designer.store.design);
    designer.opening.open(drawnPot(ready.shape, this.height, unit));
    designer.notices.say(words.done(ready.shape.rings.length, this.length(ready.rms), this.length(ready.most)));
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("scan-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      .lead,
      .hint {
        padding-bottom: 10px;
        color: var(--soft);
        text-wrap: pretty;
      }
      .hint {
        padding: 8px 0 0;
      }
      .trouble {
        margin: 10px 0 2px;
        padding: 8px 12px;
        border-radius: 9px;
        background: var(--warn-wash);
        color: var(--warn);
        font-size: 0.92rem;
      }
      .up {
        display: grid;
        gap: 4px;
        padding: 12px 0 4px;
      }
      svg[role] {
        display: block;
        width: min(100%, max(12rem, 86dvh - 28rem));
        margin: 12px auto 8px;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
      }
      .whole {
        fill: var(--accent-wash);
        stroke: var(--accent);
        stroke-width: 1;
      }
      .core {
        fill: var(--accent);
        opacity: 0.35;
      }
      .hoop {
        fill: none;
        stroke: var(--ink);
        stroke-width: 1.6;
      }
      .found {
        flex: 1;
        font-weight: 600;
      }
      .warn {
        color: var(--warn);
        font-weight: 400;
      }
    `,
  ];
}

/** The direction of the outermost point. */
function directionOf({ radii }: Levels, widest: number): number {
  return Math.max(0, ...radii.map((section) => section.indexOf(widest)));
}

/** How far out a section is seen to reach that way. */
function seenAt(section: Float64Array, direction: number): number {
  const turned = (k: number) => Math.cos((2 * Math.PI * (k - direction)) / DIRECTIONS);
  return section.reduce((most, radius, k) => Math.max(most, radius * turned(k)), 0);
}

/** Turned about x, so that y is up. */
function upright(triangles: Float32Array): Float32Array {
  const turned = new Float32Array(triangles.length);
  for (let i = 0; i + 2 < triangles.length; i += 3) {
    turned[i] = triangles[i] as number;
    turned[i + 1] = -(triangles[i + 2] as number);
    turned[i + 2] = triangles[i + 1] as number;
  }
  return turned;
}

function keepToItself(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-scan": PasuScan;
  }
}
