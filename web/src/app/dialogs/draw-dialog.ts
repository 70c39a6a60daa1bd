/** Drawing a pot freehand, or tracing it from an SVG file or a photograph: a line becomes rings, which are seen over it before they are taken. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { evenly, type Spot } from "../../document/drawn/knot";
import {
  addKnot,
  type DrawnProfile,
  knotsOn,
  measured,
  moveKnot,
  placed,
  plainLine,
  profileOf,
  removeKnot,
  type Sheet,
  type Side,
  scaleOf,
  sharpenKnot,
  sidesDrawn,
  withSide,
  withSides,
  withSymmetry,
} from "../../document/drawn/sheet";
import { boxOf, mirrored, type Sides, sidesOf } from "../../document/drawn/sides";
import { alike, silhouetteOf } from "../../document/drawn/silhouette";
import { knotsOf, type Smoothing } from "../../document/drawn/stroke";
import { unitOf } from "../../document/look";
import { DesignerElement } from "../../element/designer-element";
import type { Section } from "../../solver/messages";
import { checks } from "../../ui/checks";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, fields } from "../../ui/styles";
import { drawing as words } from "../../words/english/drawing";
import { page } from "../../words/english/page";
import { cannotWords } from "../../words/freeing";
import { spokenLength } from "../../words/quantities";
import { type Drawn, drawnOf, drawnPot, redraw } from "../../work/drawn";
import { pickFile } from "../../work/files";
import { finenessOf } from "../../work/freeing";
import type { Outcome } from "../../worker/port";
import { type Overlay, pointName, SHEET, type SheetEvent, type StrokeEvent } from "../drawing/drawing-board";
import "../drawing/drawing-board";
import { type Photo, photoOf } from "../drawing/photo";
import { onSheet, type SvgLine, type SvgRefusal, svgLines } from "../drawing/svg-lines";

/** How high a pot is where nobody has said anything, in each unit. */
const HEIGHTS = { cm: 20, mm: 200, in: 8 } as const;

/** A line keeps off the edge of the sheet. */
const MARGIN = 40;

/** Nobody draws more exactly than this part of the height. */
const FINE = 5;

/** Rings are not sought at every movement of the hand. */
const PAUSE_MS = 160;

const DIGITS = 2;
const MOST_BACK = 100;

interface Found {
  readonly outcome: Outcome<Drawn>;
  readonly sheet: Sheet;
}

type Trouble = SvgRefusal | "flat" | "no-photo";

@customElement("pasu-draw")
export class PasuDraw extends DesignerElement {
  /** Whether it takes the place of the selected part's shape; a new pot otherwise. */
  @property({ type: Boolean }) redraws = false;
  @state() private sheet: Sheet = { right: [], left: null, axis: SHEET / 2, height: 0 };
  /** How far off rings may be; what suits the height where nobody has said so. */
  @state() private typed: number | null = null;
  /** What was found last, and for which sheet; null before anything was. */
  @state() private found: Found | null = null;
  /** Whether something newer is being looked for. */
  @state() private coming = false;
  @state() private trouble = "";
  @state() private photo: Photo | null = null;
  @state() private sensitivity = 0;
  @state() private lines: readonly SvgLine[] = [];
  @state() private chosen = 0;
  @state() private listed = false;
  /** The pot as it is, where it is drawn anew. */
  private present: readonly (readonly Spot[])[] = [];
  private readonly past: Sheet[] = [];
  /** The last one that the hand had let go of. */
  private settled: Sheet | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asked: Sheet | null = null;

  private get tolerance(): number {
    return this.typed ?? FINE * finenessOf({ height: this.sheet.height, greatest: { direction: 0, low: 0, width: 0 } });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("keydown", this.key);
    this.addEventListener("dragover", keepToItself);
    this.addEventListener("drop", this.dropped);
    if (this.hasUpdated) return;
    const unit = unitOf(this.designer.store.design);
    const { extents } = this.designer;
    const high = this.redraws && extents ? Number(extents.height.toPrecision(3)) : HEIGHTS[unit];
    this.sheet = { ...this.sheet, height: high };
    this.settled = this.sheet;
    if (this.redraws) this.present = presentLines(this.designer.surface.shown?.solved.section ?? null, this.sheet.axis);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("keydown", this.key);
    this.removeEventListener("dragover", keepToItself);
    this.removeEventListener("drop", this.dropped);
    clearTimeout(this.timer);
    this.asked = null;
  }

  override render() {
    const { sheet } = this;
    const unit = unitOf(this.designer.store.design);
    const drawn = sheet.right.length > 0;
    return html`<pasu-dialog wide ruled heading=${words.heading} @dialog-closed=${this.close}>
      <p class="lead">${words.lead}</p>
      <div class="halves">
        <div>
          <pasu-drawing-board
            .sheet=${sheet}
            .photo=${this.photo?.canvas ?? null}
            .ghosts=${this.ghosts()}
            .overlay=${this.overlay()}
            .unit=${unit}
            @sheet-changed=${this.changed}
            @stroke-drawn=${this.drew}
          ></pasu-drawing-board>
        </div>
        <div>
          <div class="acts">
            <button class="button outlined" type="button" @click=${this.pickSvg}>${icon("paper")}<span>${words.svg}</span></button>
            <button class="button outlined" type="button" @click=${this.pickPhoto}>${icon("picture")}<span>${words.photo}</span></button>
            ${drawn ? nothing : html`<button class="button outlined" type="button" @click=${this.plain}>${icon("add")}<span>${words.points}</span></button>`}
            <button class="button bare" type="button" aria-label=${words.back} title=${words.back} ?disabled=${this.past.length === 0} @click=${this.back}>
              ${icon("undo")}
            </button>
            <button class="button bare" type="button" aria-label=${words.clear} title=${words.clear} ?disabled=${!drawn && !this.photo} @click=${this.clear}>
              ${icon("remove")}
            </button>
          </div>
          ${this.trouble === "" ? nothing : html`<p class="trouble" role="alert">${this.trouble}</p>`}
          ${this.file()} ${this.traced()}
          ${this.number(words.height, words.heightHelp, sheet.height, 2 * HEIGHTS[unit], (height) => this.take({ ...this.sheet, height }))}
          <label class="check">
            <input type="checkbox" .checked=${sheet.left === null} ?disabled=${!drawn} @change=${this.makeAlike} />
            <span>${words.alike} <small>${words.alikeAbout}</small></span>
          </label>
          ${this.number(words.tolerance, words.toleranceHelp, this.tolerance, sheet.height / 50, (tolerance) => {
            this.typed = tolerance;
            // Another question about the same sheet.
            this.sheet = { ...this.sheet };
            this.seekSoon();
          })}
          ${drawn ? this.points() : nothing}
        </div>
      </div>
      <p slot="actions" class="found" role="status">${this.told()}</p>
      <button slot="actions" class="button primary" type="button" ?disabled=${this.ready === null} @click=${this.use}>
        ${words.use}
      </button>
    </pasu-dialog>`;
  }

  /** What there is to trace beside a photograph. */
  private ghosts(): readonly (readonly Spot[])[] {
    if (this.lines.length > 1) return this.lines.map(({ points }) => points);
    return this.lines.length === 0 && !this.photo ? this.present : [];
  }

  private number(label: string, help: string, value: number, max: number, set: (value: number) => void) {
    return html`<pasu-number
      .label=${label}
      .unit=${unitOf(this.designer.store.design)}
      .help=${help}
      .value=${value}
      .min=${0}
      .max=${max}
      .step=${max / 400}
      @number-change=${({ value: typed }: NumberChangeEvent) => {
        if (typed > 0) set(typed);
      }}
    ></pasu-number>`;
  }

  /** Which of the lines of a file it is. */
  private file() {
    const { lines } = this;
    if (lines.length < 2) return nothing;
    return html`<label class="line">
      <span>${words.line}</span>
      <select class="field" @change=${(event: Event) => this.choose(Number((event.target as HTMLSelectElement).value))}>
        ${lines.map((_, i) => html`<option value=${i} ?selected=${i === this.chosen}>${words.lineOf(i + 1, lines.length)}</option>`)}
      </select>
    </label>`;
  }

  private traced() {
    if (!this.photo) return nothing;
    return html`<p class="hint">${words.traced}</p>
      <pasu-number
        .label=${words.sensitivity}
        .help=${words.sensitivityHelp}
        .value=${this.sensitivity}
        .min=${-3}
        .max=${3}
        .step=${0.1}
        @number-change=${({ value }: NumberChangeEvent) => {
          this.sensitivity = value;
          this.trace();
        }}
      ></pasu-number>
      <button class="button outlined" type="button" @click=${this.withoutPhoto}>${words.withoutPhoto}</button>`;
  }

  private points() {
    return html`<details @toggle=${(event: Event) => {
      this.listed = (event.target as HTMLDetailsElement).open;
    }}>
      <summary><h3>${words.numbers}</h3><span>${words.numbersAbout}</span></summary>
      ${this.listed ? sidesDrawn(this.sheet).map((side) => this.side(side)) : nothing}
    </details>`;
  }

  private side(side: Side) {
    const { sheet } = this;
    const unit = unitOf(this.designer.store.design);
    const all = knotsOn(sheet, side);
    return html`
      ${sheet.left === null ? nothing : html`<h4>${words.sides[side]}</h4>`}
      <ol>
        ${all.map((knot, index) => {
          const name = pointName(sheet, side, index);
          const at = measured(sheet, knot);
          const number = (label: string, value: number, set: (value: number) => Spot) =>
            html`<label class="cell"><span>${label}</span><pasu-number
              compact
              .label=${words.of(label, name)}
              .unit=${unit}
              .value=${Number(value.toPrecision(4))}
              .step=${sheet.height / 200}
              @number-change=${({ value: typed }: NumberChangeEvent) => this.take(moveKnot(this.sheet, side, index, set(typed)))}
            ></pasu-number></label>`;
          return html`<li>
            <strong>${name}</strong>
            ${number(words.radius, at.radius, (radius) => placed(this.sheet, side, radius, measured(this.sheet, knot).height))}
            ${number(words.up, at.height, (height) => placed(this.sheet, side, measured(this.sheet, knot).radius, height))}
            <label class="check" title=${words.sharpOf(name)}>
              <input
                type="checkbox"
                aria-label=${words.sharpOf(name)}
                .checked=${knot.sharp}
                @change=${(event: Event) => this.take(sharpenKnot(this.sheet, side, index, (event.target as HTMLInputElement).checked))}
              />
              <span aria-hidden="true">${words.sharp}</span>
            </label>
            <span class="edit">
              <button class="button bare" type="button" aria-label=${words.add(name)} title=${words.add(name)} ?disabled=${index === all.length - 1} @click=${() => this.take(addKnot(this.sheet, side, index))}>
                ${icon("add")}
              </button>
              <button class="button bare" type="button" aria-label=${words.remove(name)} title=${words.remove(name)} ?disabled=${all.length <= 2} @click=${() => this.take(removeKnot(this.sheet, side, index))}>
                ${icon("remove")}
              </button>
            </span>
          </li>`;
        })}
      </ol>
    `;
  }

  /** What would be taken: not what was found for an earlier line. */
  private get ready(): Drawn | null {
    const { found, coming } = this;
    return !coming && found?.outcome.state === "done" ? found.outcome.value : null;
  }

  private told() {
    const { found, coming } = this;
    const unit = unitOf(this.designer.store.design);
    if (coming) return words.coming;
    if (found === null) return this.sheet.right.length > 0 ? nothing : words.nothing;
    if (found.outcome.state === "superseded") return nothing;
    if (found.outcome.state === "refused")
      return html`<span class="warn">${cannotWords(found.outcome.refusal, unit)}</span>`;
    const { shape, distance } = found.outcome.value;
    return words.found(shape.rings.length, spokenLength(distance, unit, DIGITS));
  }

  /** What was found, where it is on the sheet. */
  private overlay(): Overlay | null {
    const { found } = this;
    const scale = found && scaleOf(found.sheet);
    if (!scale || found.outcome.state !== "done") return null;
    const { axis } = found.sheet;
    const spot = ([across, up]: readonly [number, number]): Spot => ({
      x: axis + across / scale.unit,
      y: scale.foot - up / scale.unit,
    });
    const { right, left, rings } = found.outcome.value;
    return { lines: [right.map(spot), left.map(spot)], rings: rings.map(([a, b]) => [spot(a), spot(b)]) };
  }

  // The sheet

  private readonly changed = ({ sheet, settled }: SheetEvent): void => {
    if (settled) this.take(sheet);
    else {
      this.sheet = sheet;
      this.seekSoon();
    }
  };

  /** Takes another sheet; what was there can be taken back. */
  private take(sheet: Sheet): void {
    const { settled } = this;
    this.trouble = "";
    this.sheet = sheet;
    if (settled && settled !== sheet) this.past.push(settled);
    if (this.past.length > MOST_BACK) this.past.shift();
    this.settled = sheet;
    this.seekSoon();
  }

  private readonly back = (): void => {
    const sheet = this.past.pop();
    if (!sheet) return;
    this.sheet = sheet;
    this.settled = sheet;
    this.trouble = "";
    this.seekSoon();
    this.requestUpdate();
  };

  private readonly key = (event: KeyboardEvent): void => {
    const [from] = event.composedPath();
    const typing = from instanceof HTMLInputElement && from.type === "text";
    if (event.key.toLowerCase() !== "z" || !(event.ctrlKey || event.metaKey) || event.shiftKey || typing) return;
    event.preventDefault();
    this.back();
  };

  private readonly clear = (): void => {
    this.withoutPhoto();
    this.lines = [];
    this.take({ ...this.sheet, right: [], left: null, axis: SHEET / 2 });
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

  /** A line that was drawn by hand. */
  private readonly drew = ({ line }: StrokeEvent): void => {
    const { sheet } = this;
    const sides = sidesOf(line, false, sheet.axis);
    const right = sides && knotsOf(sides.right, 4);
    if (!sides || !right || right.length < 2) {
      this.trouble = words.stroke;
      return;
    }
    if (sides.left && sheet.left !== null) this.take(withSides(sheet, right, knotsOf(sides.left, 4)));
    else if (sheet.left === null) this.take(withSides(sheet, right, null));
    else {
      const mean = line.reduce((sum, { x }) => sum + x, 0) / line.length;
      const side = mean < sheet.axis ? "left" : "right";
      this.take(withSide(sheet, side, side === "left" ? mirrored(right, sheet.axis) : right));
    }
  };

  // Files

  private readonly pickSvg = async (): Promise<void> => {
    const file = await pickFile(".svg,image/svg+xml");
    if (file) await this.readSvg(file);
  };

  private readonly pickPhoto = async (): Promise<void> => {
    const file = await pickFile("image/*");
    if (file) await this.readPhoto(file);
  };

  private readonly dropped = (event: DragEvent): void => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    keepToItself(event);
    void (/svg/i.test(`${file.type} ${file.name}`) ? this.readSvg(file) : this.readPhoto(file));
  };

  private async readSvg(file: Blob): Promise<void> {
    const lines = await svgLines(file);
    if (typeof lines === "string") {
      this.fail(lines);
      return;
    }
    this.withoutPhoto();
    this.lines = onSheet(lines, SHEET, MARGIN);
    this.choose(0);
  }

  private choose(index: number): void {
    const line = this.lines[index];
    if (!line) return;
    this.chosen = index;
    const sides = sidesOf(line.points, line.closed, null);
    if (sides) this.takeSides(sides, 0);
    else this.fail("flat");
  }

  private async readPhoto(file: Blob): Promise<void> {
    const photo = await photoOf(file, SHEET);
    if (!photo) {
      this.fail("no-photo");
      return;
    }
    this.photo = photo;
    this.lines = [];
    this.sensitivity = 0;
    this.trace();
  }

  /** Finds the pot on the photograph. */
  private trace(): void {
    const { photo } = this;
    if (!photo) return;
    const seen = silhouetteOf(photo.picture, this.sensitivity);
    if (!seen) {
      this.trouble = words.noPot;
      return;
    }
    const there = (line: readonly Spot[]) => line.map(({ x, y }) => ({ x: x + photo.x, y: y + photo.y }));
    const both = alike(seen);
    const sides: Sides = {
      right: there(both ?? seen.right),
      left: both ? null : there(seen.left),
      axis: seen.axis + photo.x,
    };
    this.takeSides(sides, 4);
  }

  private takeSides({ right, left, axis }: Sides, smoothing: Smoothing): void {
    const knots = (line: readonly Spot[]) => knotsOf(evenly(line, 1), smoothing);
    const [one, other] = [knots(right), left && knots(left)];
    if (one.length < 2) {
      this.fail("flat");
      return;
    }
    const middle = axis ?? this.sheet.axis;
    // An outline that is the same on both sides says so.
    const same = other && evenOn(one, mirrored(other, middle));
    this.take(withSides(this.sheet, one, same ? null : other, middle));
  }

  private fail(why: Trouble): void {
    this.trouble = words.refused[why];
  }

  private readonly withoutPhoto = (): void => {
    this.photo = null;
  };

  // Rings

  private seekSoon(): void {
    clearTimeout(this.timer);
    const { sheet } = this;
    this.asked = sheet;
    const profile = profileOf(sheet);
    this.coming = profile !== null;
    if (profile) this.timer = setTimeout(() => void this.seek(sheet, profile), PAUSE_MS);
    // What was found for an earlier line is nearly true: it is seen until there is something better.
    else this.found = null;
  }

  private async seek(sheet: Sheet, profile: DrawnProfile): Promise<void> {
    const { designer } = this;
    const made = await designer.openMade();
    if (!made) {
      this.coming = false;
      this.trouble = page.unfetched;
      return;
    }
    const outcome = await drawnOf(made.maker, designer.solver, profile, this.tolerance);
    if (this.asked !== sheet || outcome.state === "superseded") return;
    this.found = { outcome, sheet };
    this.coming = false;
  }

  private readonly use = (): void => {
    const { ready, designer, sheet } = this;
    if (!ready) return;
    const { shape, distance } = ready;
    const unit = unitOf(designer.store.design);
    if (this.redraws) designer.apply(redraw(designer.state, shape));
    else designer.opening.open(drawnPot(shape, sheet.height, unit));
    designer.notices.say(words.done(shape.rings.length, spokenLength(distance, unit, DIGITS)));
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("draw-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    checks,
    css`
      .lead,
      .hint {
        padding-bottom: 10px;
        color: var(--soft);
        text-wrap: pretty;
      }
      .hint {
        padding: 8px 0 2px;
      }
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
      .trouble {
        margin: 2px 0 8px;
        padding: 8px 12px;
        border-radius: 9px;
        background: var(--warn-wash);
        color: var(--warn);
        font-size: 0.92rem;
      }
      .line {
        display: grid;
        gap: 4px;
        padding: 4px 0 8px;
      }
      .found {
        flex: 1;
        font-weight: 600;
      }
      .warn {
        color: var(--warn);
        font-weight: 400;
      }
      small {
        color: var(--soft);
        font-size: 0.86rem;
      }
      details {
        margin-top: 8px;
        border-top: 1px solid var(--line);
      }
      summary {
        display: flex;
        align-items: center;
        gap: 10px;
        min-height: var(--touch);
        cursor: pointer;
      }
      h3 {
        font-size: 0.95rem;
        font-weight: 650;
      }
      h4 {
        padding: 6px 0 4px;
        font-size: 0.92rem;
      }
      summary span {
        color: var(--soft);
        font-size: 0.84rem;
      }
      ol {
        display: grid;
        gap: 8px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 4px 8px;
        padding: 8px 12px;
        border-radius: 12px;
        background: var(--well);
      }
      li strong {
        grid-column: 1 / -1;
        font-size: 0.9rem;
      }
      .cell {
        display: grid;
        gap: 3px;
        min-width: 0;
        color: var(--soft);
        font-size: 0.82rem;
      }
      .cell pasu-number {
        padding: 0;
        color: var(--ink);
        font-size: 0.94rem;
      }
      .edit {
        display: flex;
        justify-content: flex-end;
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

/** Both sides of the pot as it is, as large as the sheet allows. */
function presentLines(section: Section | null, axis: number): readonly (readonly Spot[])[] {
  if (!section) return [];
  const lines = [section.right, section.left].map((pairs) =>
    Array.from({ length: pairs.length >> 1 }, (_, i) => ({ x: pairs[2 * i] ?? 0, y: -(pairs[2 * i + 1] ?? 0) })),
  );
  const { top, bottom } = boxOf(lines.flat());
  const wide = Math.max(...lines.flat().map(({ x }) => Math.abs(x)));
  const scale = Math.min((SHEET - 2 * MARGIN) / (bottom - top), (SHEET / 2 - MARGIN / 2) / wide);
  const middle = (SHEET - scale * (top + bottom)) / 2;
  return Number.isFinite(scale)
    ? lines.map((line) => line.map(({ x, y }) => ({ x: axis + scale * x, y: middle + scale * y })))
    : [];
}

function keepToItself(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}

/** How unlike two sides may be and still be the same, on the sheet. */
const SAME = 1.5;

/** Whether two sides go the same way, as far as their points say. */
function evenOn(one: readonly Spot[], other: readonly Spot[]): boolean {
  const gap = 8;
  const [a, b] = [evenly(one, gap), evenly(other, gap)];
  if (Math.abs(a.length - b.length) > 1) return false;
  const count = Math.min(a.length, b.length);
  const at = (line: readonly Spot[], i: number) => line[Math.round((i * (line.length - 1)) / (count - 1))] as Spot;
  return Array.from({ length: count }, (_, i) => i).every((i) => {
    const [p, q] = [at(a, i), at(b, i)];
    return Math.hypot(p.x - q.x, p.y - q.y) < gap / 2 + SAME;
  });
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-draw": PasuDraw;
  }
}
