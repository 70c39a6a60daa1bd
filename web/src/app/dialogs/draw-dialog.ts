/** Drawing a pot freehand, or tracing it from an SVG file or a photograph: a line becomes rings, which are seen over it before they are taken. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import type { Spot } from "../../document/drawn/knot";
import { MARGIN, plainLine, profileOf, SHEET, type Sheet, withSymmetry } from "../../document/drawn/sheet";
import type { Sides } from "../../document/drawn/sides";
import { Steps } from "../../document/drawn/steps";
import type { Smoothing } from "../../document/drawn/stroke";
import { linesOnSheet, withOutline, withStroke } from "../../document/drawn/tracing";
import { unitOf } from "../../document/look";
import type { Unit } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { checks } from "../../ui/checks";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure, fields } from "../../ui/styles";
import { told } from "../../ui/told";
import { boundWords } from "../../words/bound";
import { drawing as words } from "../../words/english/drawing";
import { cannotWords } from "../../words/freeing";
import { type Drawn, drawnOf, drawnPot, redraw } from "../../work/drawn";
import { pickFile } from "../../work/files";
import { followedByHand } from "../../work/freeing";
import type { Overlay, SheetEvent, StrokeEvent } from "../drawing/drawing-board";
import "../drawing/drawing-board";
import { overlayOf } from "../drawing/overlay";
import "../drawing/points-list";
import { Tracing, type Trouble } from "../drawing/tracing";
import { FileDrop } from "../file-drop";
import { Seeking } from "../seeking";
import { lengthField } from "./length-field";

/** How high a pot is where nobody has said anything, in each unit. */
const HEIGHTS = { cm: 20, mm: 200, in: 8 } as const;

/** The slider of the tolerance reaches this part of the height. */
const COARSEST = 1 / 50;

/** Rings are not sought at every movement of the hand. */
const PAUSE_MS = 160;

/** Rings, and the sheet that they were found for. */
interface Found {
  readonly drawn: Drawn;
  readonly sheet: Sheet;
}

const EMPTY: Sheet = { right: [], left: null, axis: SHEET / 2, height: 0 };

/** What was drawn for a new pot when the dialogue was closed without using it, and in which unit it has its height: it is there when the dialogue is opened again. */
let left: { readonly sheet: Sheet; readonly unit: Unit } | null = null;

@customElement("pasu-draw")
export class PasuDraw extends DesignerElement {
  /** Whether it takes the place of the selected part's shape; a new pot otherwise. */
  @property({ type: Boolean }) redraws = false;
  @state() private sheet = EMPTY;
  /** How far off rings may be; what suits the height where nobody has said so. */
  @state() private typed: number | null = null;
  @state() private trouble = "";
  /** How many were drawn: the same words about another one are read aloud again. */
  @state() private strokes = 0;
  @state() private listed = false;
  private readonly rings = new Seeking<Found>(this, PAUSE_MS);
  private readonly tracing = new Tracing(this);
  private steps = new Steps(EMPTY);
  /** The pot as it is, where it is drawn anew. */
  private present: readonly (readonly Spot[])[] = [];
  /** The height that the pot had at first. */
  private first = 0;

  constructor() {
    super();
    new FileDrop(this, (file) => void this.tracing.read(file));
  }

  private get unit(): Unit {
    return unitOf(this.designer.store.design);
  }

  private get tolerance(): number {
    return this.typed ?? followedByHand(this.sheet.height);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("keydown", this.key);
    if (this.hasUpdated) return;
    const { extents, surface } = this.designer;
    this.first = this.redraws && extents ? Number(extents.height.toPrecision(3)) : HEIGHTS[this.unit];
    this.sheet = { ...EMPTY, height: this.first };
    this.steps = new Steps(this.sheet);
    if (!this.redraws && left?.unit === this.unit) this.take(left.sheet);
    const section = this.redraws ? surface.shown?.solved.section : null;
    if (section) this.present = linesOnSheet([section.right, section.left], this.sheet.axis);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("keydown", this.key);
  }

  override render() {
    const { sheet, unit, rings, tracing } = this;
    const drawn = sheet.right.length > 0;
    const isEmpty = !drawn && tracing.isEmpty;
    return html`<pasu-dialog wide ruled heading=${words.heading} @dialog-closed=${this.close}>
      <p class="lead">${words.lead}</p>
      <div class="halves">
        <div>
          <pasu-drawing-board
            .sheet=${sheet}
            .photo=${tracing.photo?.canvas ?? null}
            .ghosts=${tracing.isEmpty ? this.present : tracing.ghosts}
            .overlay=${this.overlay()}
            .unit=${unit}
            @sheet-changed=${this.changed}
            @stroke-drawn=${this.drew}
          ></pasu-drawing-board>
        </div>
        <div>
          <div class="acts">
            <button class="button outlined" type="button" @click=${this.pickSvg}>${icon("paper")}<span>${words.svg}</span></button>
            <button id="photo" class="button outlined" type="button" @click=${this.pickPhoto}>${icon("picture")}<span>${words.photo}</span></button>
            ${drawn ? nothing : html`<button class="button outlined" type="button" @click=${this.plain}>${icon("add")}<span>${words.points}</span></button>`}
            <button class="button bare" type="button" aria-label=${words.back} title=${words.back} aria-disabled=${this.steps.isFirst ? "true" : nothing} @click=${this.back}>
              ${icon("undo")}
            </button>
            <button class="button bare" type="button" aria-label=${words.clear} title=${words.clear} aria-disabled=${isEmpty ? "true" : nothing} @click=${() => isEmpty || this.clear()}>
              ${icon("remove")}
            </button>
          </div>
          ${this.trouble === "" ? nothing : keyed(this.strokes, html`<p class="trouble" role="alert">${this.trouble}</p>`)}
          ${this.file()} ${this.traced()}
          ${lengthField({
            label: words.height,
            help: words.heightHelp,
            unit,
            value: sheet.height,
            most: 2 * this.first,
            set: (height, gesture) => this.take({ ...this.sheet, height }, !gesture),
            done: () => this.take(this.sheet),
            cancel: () => this.take(this.steps.settled),
          })}
          <label class="check">
            <input type="checkbox" .checked=${sheet.left === null} ?disabled=${!drawn} @change=${this.makeAlike} />
            <span>${words.alike} <small>${words.alikeAbout}</small></span>
          </label>
          ${lengthField({
            label: words.tolerance,
            help: words.toleranceHelp,
            unit,
            value: this.tolerance,
            most: COARSEST * sheet.height,
            set: (tolerance) => {
              this.typed = tolerance;
              this.seek();
            },
          })}
          ${drawn ? this.points() : nothing}
        </div>
      </div>
      <p slot="actions" class="found" role="status">${this.told()}</p>
      <button slot="actions" class="button primary" type="button" ?disabled=${rings.ready === null} @click=${this.use}>
        ${words.use}
      </button>
    </pasu-dialog>`;
  }

  /** Which of the lines of a file it is. */
  private file() {
    const { lines, chosen } = this.tracing;
    if (lines.length < 2) return nothing;
    return html`<label class="line">
      <span>${words.line}</span>
      <select class="field" @change=${(event: Event) => this.tracing.choose(Number((event.target as HTMLSelectElement).value))}>
        ${lines.map((_, i) => html`<option value=${i} .selected=${i === chosen}>${words.lineOf(i + 1, lines.length)}</option>`)}
      </select>
    </label>`;
  }

  private traced() {
    const { tracing } = this;
    if (!tracing.photo) return nothing;
    return html`<p class="hint">${words.traced}</p>
      <pasu-number
        .label=${words.sensitivity}
        .help=${words.sensitivityHelp}
        .value=${tracing.sensitivity}
        .min=${-3}
        .max=${3}
        .step=${0.1}
        @number-change=${({ value, gesture }: NumberChangeEvent) => tracing.tell(value, !gesture)}
        @number-done=${this.settle}
        @number-cancel=${this.untell}
      ></pasu-number>
      <button class="button outlined" type="button" @click=${this.leavePhoto}>${words.withoutPhoto}</button>`;
  }

  private points() {
    return html`<details @toggle=${(event: Event) => {
      this.listed = (event.target as HTMLDetailsElement).open;
    }}>
      <summary><h3>${words.numbers}</h3><span>${words.numbersAbout}</span></summary>
      ${
        this.listed
          ? html`<pasu-points .sheet=${this.sheet} .unit=${this.unit} @sheet-changed=${this.changed}></pasu-points>`
          : nothing
      }
    </details>`;
  }

  private told() {
    const { coming, found } = this.rings;
    if (coming) return words.coming;
    if (found === null) return this.sheet.right.length > 0 ? nothing : words.nothing;
    if (found.state === "superseded") return nothing;
    if (found.state === "refused") return html`<span class="warn">${cannotWords(found.refusal, this.unit)}</span>`;
    const { shape, distance } = found.value.drawn;
    return words.found(shape.rings.length, boundWords(distance, this.unit));
  }

  /** What was found last is nearly true of a newer line: it is seen until there is something better. */
  private overlay(): Overlay | null {
    const { found } = this.rings;
    return found?.state === "done" ? overlayOf(found.value.drawn, found.value.sheet) : null;
  }

  // The sheet

  private readonly changed = ({ sheet, settled }: SheetEvent): void => {
    this.take(sheet, settled);
  };

  /** Takes another sheet; what was there when the hand last let go can be taken back. */
  private take(sheet: Sheet, settled = true): void {
    this.trouble = "";
    this.sheet = sheet;
    if (settled) this.steps.settle(sheet);
    this.seek();
  }

  /** The hand has let go. What is said of it stands where nothing came of it. */
  private readonly settle = (): void => {
    if (this.trouble === "") this.take(this.sheet);
  };

  /** The finger on the slider of the photograph was lost to scrolling. */
  private readonly untell = (): void => {
    this.recall(this.steps.settled);
  };

  private readonly back = (): void => {
    this.recall(this.steps.back());
  };

  private recall(sheet: Sheet): void {
    this.trouble = "";
    this.sheet = sheet;
    this.tracing.recall(sheet.sensitivity ?? 0);
    this.seek();
  }

  private readonly key = (event: KeyboardEvent): void => {
    const [from] = event.composedPath();
    const typing = from instanceof HTMLInputElement && from.type === "text";
    if (event.key.toLowerCase() !== "z" || !(event.ctrlKey || event.metaKey) || event.shiftKey || typing) return;
    event.preventDefault();
    this.back();
  };

  private readonly clear = (): void => {
    this.tracing.clear();
    this.empty();
  };

  private empty(): void {
    this.take({ ...this.sheet, right: [], left: null, axis: SHEET / 2 });
  }

  private readonly leavePhoto = (): void => {
    this.tracing.withoutPhoto();
    void this.updateComplete.then(() => this.renderRoot.querySelector<HTMLElement>("#photo")?.focus());
  };

  private readonly plain = (): void => {
    this.take({ ...this.sheet, right: plainLine(this.sheet.axis, MARGIN, SHEET - MARGIN) });
    void this.updateComplete.then(() => {
      const board = this.renderRoot.querySelector("pasu-drawing-board");
      void board?.updateComplete.then(() =>
        board.renderRoot.querySelector<SVGGElement>('[data-knot^="right"]')?.focus(),
      );
    });
  };

  private readonly makeAlike = (event: Event): void => {
    this.take(withSymmetry(this.sheet, (event.target as HTMLInputElement).checked));
  };

  private readonly drew = ({ line }: StrokeEvent): void => {
    const sheet = withStroke(this.sheet, line);
    this.strokes += 1;
    if (sheet) this.take(sheet);
    else this.trouble = words.stroke;
  };

  // Files

  private readonly pickSvg = async (): Promise<void> => {
    const file = await pickFile(".svg,image/svg+xml");
    if (file) await this.tracing.readSvg(file);
  };

  private readonly pickPhoto = async (): Promise<void> => {
    const file = await pickFile("image/*");
    if (file) await this.tracing.read(file);
  };

  takeTraced(sides: Sides, smoothing: Smoothing, settled: boolean): void {
    const sheet = withOutline(this.sheet, sides, smoothing);
    if (sheet) this.take({ ...sheet, sensitivity: this.tracing.sensitivity }, settled);
    else this.failTracing("flat");
  }

  failTracing(why: Trouble, isOther = false): void {
    if (isOther) this.empty();
    this.trouble = words.refused[why];
  }

  // Rings

  private seek(): void {
    const { sheet, designer, tolerance } = this;
    const profile = profileOf(sheet);
    if (!profile) {
      this.rings.forget();
      return;
    }
    this.rings.soon(async () => {
      const made = await designer.openMade();
      if (!made) return null;
      const found = await drawnOf(made.maker, designer.solver, profile, tolerance);
      return found.state === "done" ? { ...found, value: { drawn: found.value, sheet } } : found;
    });
  }

  private readonly use = (): void => {
    const { designer, unit } = this;
    const { ready } = this.rings;
    if (!ready) return;
    const { shape, distance } = ready.drawn;
    if (this.redraws) designer.apply(redraw(designer.state, shape));
    else designer.opening.open(drawnPot(shape, ready.sheet.height, unit));
    designer.notices.say(words.done(shape.rings.length, boundWords(distance, unit)));
    if (!this.redraws) left = null;
    this.dispatchEvent(new Event("draw-closed"));
  };

  private readonly close = (): void => {
    if (!this.redraws) left = this.sheet.right.length > 0 ? { sheet: this.sheet, unit: this.unit } : null;
    this.dispatchEvent(new Event("draw-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    checks,
    disclosure,
    fields,
    told,
    css`
      .halves {
        display: grid;
        grid-template-columns: minmax(0, 1.25fr) minmax(0, 1fr);
        gap: 22px;
        align-items: start;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        padding-bottom: 8px;
      }
      .line {
        display: grid;
        gap: 4px;
        padding: 4px 0 8px;
      }
      small {
        color: var(--soft);
        font-size: 0.86rem;
      }
      details {
        margin-top: 8px;
        border-top: 1px solid var(--line);
      }
      @media (max-width: 53.6875em) {
        .halves {
          grid-template-columns: minmax(0, 1fr);
          gap: 12px;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-draw": PasuDraw;
  }
}
