/** A pot from a scan: a file of triangles becomes rings with waves, which are seen against it before they are taken. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Network } from "../../document/network/network";
import { scanKind } from "../../document/scanned/file-kind";
import { UPS, type Up, unroundness, upright } from "../../document/scanned/upright";
import type { Levels, Unit } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { isolated } from "../../language";
import type { ScannedShape } from "../../maker/messages";
import { formatNumber } from "../../number";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { told } from "../../ui/told";
import { boundWords } from "../../words/bound";
import { page } from "../../words/english/page";
import { quantities } from "../../words/english/quantities";
import { scan as words } from "../../words/english/scan";
import { cannotWords } from "../../words/freeing";
import { drawnPot } from "../../work/drawn";
import { pickFile } from "../../work/files";
import { followedByHand } from "../../work/freeing";
import { openNetwork, readNetwork } from "../../work/network-files";
import { scaled, scannedOf } from "../../work/scanned";
import type { Outcome } from "../../worker/port";
import { FileDrop } from "../file-drop";
import { trianglesOf } from "../scanning/mesh-file";
import type { Fitted } from "../scanning/scan-picture";
import "../scanning/scan-picture";
import { Seeking } from "../seeking";
import { lengthField } from "./length-field";

/** Scans are in millimetres, if they say nothing else: nobody's scan of a pot is larger than this in centimetres. */
const MILLIMETRES = { cm: 10, mm: 1, in: 25.4 } as const;
const LARGE = 60;

/** The slider of the tolerance reaches this part of the height. */
const COARSEST = 1 / 20;

/** No hole is told to be less than this percentage. */
const LEAST_SHARE = 0.1;

const PAUSE_MS = 250;

/** What is as round as this stands upright; of anything else another way up is looked at. */
const ROUND = 0.05;

/** Another way up has to be so many times as round to be begun with. */
const ROUNDER = 2;

/** A scan as it is with something upwards, and how far from round it is so. */
interface Reading {
  readonly up: Up;
  readonly levels: Levels;
  readonly unround: number;
}

@customElement("pasu-scan")
export class PasuScan extends DesignerElement {
  /** A scan that is there already; null where it is to be chosen. */
  @property({ attribute: false }) file: File | null = null;
  @state() private busy = false;
  @state() private trouble = "";
  @state() private up: Up = "z";
  @state() private height = 0;
  @state() private typed: number | null = null;
  @state() private levels: Levels | null = null;
  /** What the faces of the file are besides, if they are patches. */
  @state() private network: { readonly file: File; readonly network: Network } | null = null;
  /** Why they are none, where they seem to be meant as such: told where the file is no scan either. */
  @state() private unpatched = "";
  private readonly rings = new Seeking<ScannedShape>(this, PAUSE_MS);
  private triangles: Float32Array | null = null;
  /** How high the scan was taken to be when it was opened. */
  private first = 0;
  /** What is shown of what was found. */
  private shown: { readonly found: Outcome<ScannedShape>; readonly fitted: Fitted } | null = null;
  /** The file that is being read. */
  private reading: File | null = null;

  constructor() {
    super();
    new FileDrop(this, (file) => void this.open(file));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.reading = null;
  }

  private get unit(): Unit {
    return unitOf(this.designer.store.design);
  }

  private get tolerance(): number {
    return this.typed ?? followedByHand(this.height);
  }

  override willUpdate(changed: PropertyValues): void {
    if (changed.has("file") && this.file) void this.open(this.file);
  }

  override render() {
    const { levels } = this;
    return html`<pasu-dialog ruled heading=${words.heading} @dialog-closed=${this.close}>
      <p class="lead">${words.lead}</p>
      <button class="button outlined" type="button" ?disabled=${this.busy} @click=${this.pick}>${icon("open")}<span>${words.file}</span></button>
      ${this.file ? html`<p class="hint">${words.undesigned(page.quoted(isolated(this.file.name)))}</p>` : nothing}
      ${this.trouble === "" ? nothing : html`<p class="trouble" role="alert">${this.trouble} ${this.unpatched}</p>`}
      ${
        this.network
          ? html`<p class="hint">${words.patches}</p>
              <p class="patches"><button class="button outlined" type="button" @click=${this.usePatches}>${words.usePatches}</button></p>`
          : nothing
      }
      ${
        this.triangles
          ? html`<label class="up">
              <span>${words.up}</span>
              <select class="field" @change=${this.turn}>
                ${UPS.map((way) => html`<option value=${way} .selected=${way === this.up}>${words.ups[way]}</option>`)}
              </select>
            </label>`
          : nothing
      }
      ${levels ? this.opened(levels) : nothing}
      <p slot="actions" class="found" role="status">${this.told()}</p>
      <button slot="actions" class="button primary" type="button" ?disabled=${this.rings.ready === null} @click=${this.use}>${words.use}</button>
    </pasu-dialog>`;
  }

  private opened(levels: Levels) {
    const { unit, height, tolerance } = this;
    const { ready } = this.rings;
    const kept = this.kept(levels);
    const { holes = 0 } = levels;
    return html`
      <pasu-scan-picture .levels=${levels} .fitted=${this.fitted(levels)} .unit=${unit}></pasu-scan-picture>
      ${lengthField({
        label: words.height,
        help: words.heightHelp,
        unit,
        value: height,
        most: 2 * this.first,
        set: (value) => {
          this.height = value;
          this.seek();
        },
      })}
      ${lengthField({
        label: words.tolerance,
        help: words.toleranceHelp,
        unit,
        value: tolerance,
        most: COARSEST * height,
        set: (value) => {
          this.typed = value;
          this.seek();
        },
      })}
      ${kept === null ? nothing : html`<p class="hint">${words.cut(this.length(kept), this.length(height))}</p>`}
      ${holes > 0 ? html`<p class="hint">${words.holes(quantities.percent(formatNumber(Math.max(LEAST_SHARE, 100 * holes), 2)))}</p>` : nothing}
      ${ready?.withoutHandle ? html`<p class="hint">${words.standsOut(this.length(ready.withoutHandle.rms), this.length(ready.withoutHandle.distance))}</p>` : nothing}
      ${ready && (ready.withoutHandle ?? ready).distance > tolerance ? html`<p class="hint">${words.further}</p>` : nothing}
    `;
  }

  /** How high the pot is where foot or rim of the scan are left out; null where nothing is. */
  private kept({ heights, height }: Levels): number | null {
    const [low = 0, next = 0] = heights;
    const high = heights.at(-1) ?? 0;
    const gap = next - low;
    return low > 2 * gap || height - high > 2 * gap ? ((high - low) / height) * this.height : null;
  }

  /** What was found last is nearly true: its colours are seen until there is something better. */
  private fitted(levels: Levels): Fitted | null {
    const { found } = this.rings;
    if (found?.state !== "done") return null;
    const { shape, away, distance, withoutHandle } = found.value;
    if (this.shown?.found !== found) {
      const fitted = {
        rings: shape.rings,
        times: this.height / levels.height,
        away,
        most: Math.max((withoutHandle ?? { distance }).distance, this.tolerance),
        greatest: distance,
      };
      this.shown = { found, fitted };
    }
    return this.shown.fitted;
  }

  private length(value: number): string {
    return boundWords(value, this.unit);
  }

  private told() {
    const { coming, found, ready } = this.rings;
    if (this.busy) return words.reading;
    if (coming) return words.coming;
    if (!this.levels) return this.trouble === "" ? words.nothing : nothing;
    if (found?.state === "refused") return html`<span class="warn">${cannotWords(found.refusal, this.unit)}</span>`;
    if (!ready) return nothing;
    const { rings } = ready.shape;
    const waves = new Set(rings.flatMap(({ r }) => (r.waves ?? []).map(({ n }) => n)));
    const kept = this.kept(this.levels);
    const short = kept === null ? "" : words.cutShort(this.length(kept), this.length(this.height));
    return words.found(rings.length, waves.size, this.length(ready.rms), this.length(ready.distance)) + short;
  }

  private readonly pick = async (): Promise<void> => {
    const file = await pickFile(".stl,.obj,.ply");
    if (file) await this.open(file);
  };

  private async open(file: File): Promise<void> {
    this.reading = file;
    if (file !== this.file) this.file = null;
    this.busy = true;
    this.trouble = "";
    this.levels = null;
    this.triangles = null;
    this.network = null;
    this.unpatched = "";
    this.rings.forget();
    if (scanKind(file.name) === "obj") await this.lookForPatches(file);
    const triangles = await trianglesOf(file).catch(() => null);
    if (this.reading !== file) return;
    this.busy = false;
    if (triangles === null) this.trouble = page.unfetched;
    else if (typeof triangles === "string") this.trouble = words.refused[triangles];
    else {
      this.triangles = triangles;
      this.typed = null;
      await this.begin(scanKind(file.name) === "obj" ? ["y", "z", "x"] : ["z", "y", "x"]);
    }
  }

  /** A network that was saved as OBJ is no scan, and quads may be either. */
  private async lookForPatches(file: File): Promise<void> {
    const read = await readNetwork(this.designer, file).catch(() => null);
    if (this.reading !== file || read === null) return;
    if ("network" in read) this.network = { file, network: read.network };
    else if (read.isMeant) this.unpatched = words.unpatched(read.trouble);
  }

  private readonly usePatches = (): void => {
    if (!this.network) return;
    openNetwork(this.designer, this.network.file, this.network.network);
    this.close();
  };

  private readonly turn = (event: Event): void => {
    const up = (event.target as HTMLSelectElement).value as Up;
    void this.busily(up, () => this.read(up));
  };

  /**
   * No file says which way is up: modellers who write OBJ have y, others z, which is the first of `ways`. Where it is no pot so, or one that is far from round, it may lie: it is begun with as it is roundest.
   */
  private begin(ways: readonly [Up, ...Up[]]): Promise<void> {
    return this.busily(ways[0], async () => {
      let best: Reading | null = null;
      for (const up of ways) {
        const reading = await this.read(up);
        if (reading && (best === null || ROUNDER * reading.unround < best.unround)) best = reading;
        if (best && best.unround < ROUND) break;
      }
      return best;
    });
  }

  /** With that upwards; null where it is no pot so. */
  private async read(up: Up): Promise<Reading | null> {
    const made = await this.designer.openMade();
    if (!made || !this.triangles) return null;
    const outcome = await made.maker.ask({ kind: "levels", positions: upright(this.triangles, up) });
    return outcome.state === "done" ? { up, levels: outcome.value, unround: unroundness(outcome.value) } : null;
  }

  /** Looks for rings in what is read, unless something else is to be read meanwhile. */
  private async busily(up: Up, read: () => Promise<Reading | null>): Promise<void> {
    const { triangles } = this;
    this.up = up;
    this.busy = true;
    this.rings.forget();
    const reading = await read();
    const trouble = reading ? "" : (await this.designer.openMade()) ? words.refused["no-pot"] : page.unfetched;
    if (this.triangles !== triangles || this.up !== up) return;
    this.busy = false;
    this.trouble = trouble;
    this.levels = reading?.levels ?? null;
    if (!reading) return;
    this.up = reading.up;
    const { height } = reading.levels;
    this.first = Number((height > LARGE ? height / MILLIMETRES[this.unit] : height).toPrecision(4));
    this.height = this.first;
    this.seek();
  }

  private seek(): void {
    const { levels, height, tolerance, designer } = this;
    if (!levels) return;
    this.rings.soon(async () => {
      const made = await designer.openMade();
      return made && scannedOf(made.maker, scaled(levels, height), tolerance);
    });
  }

  private readonly use = (): void => {
    const { designer } = this;
    const { ready } = this.rings;
    if (!ready) return;
    designer.opening.open(drawnPot(ready.shape, this.height, this.unit));
    designer.notices.say(words.done(ready.shape.rings.length, this.length(ready.rms), this.length(ready.distance)));
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("scan-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    told,
    css`
      .patches {
        padding-top: 8px;
      }

      .up {
        display: grid;
        gap: 4px;
        padding: 12px 0 4px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-scan": PasuScan;
  }
}
