/** Drawing a section of a blend, freehand or from an SVG file: a closed line becomes a Fourier series, with how far it is off. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { type DrawnOutline, outlineBy, outlineThrough } from "../../document/blend/drawn";
import { borderOf, type End, reachOf } from "../../document/blend/section";
import type { Spot } from "../../document/drawn/knot";
import { unitOf } from "../../document/look";
import type { Section } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { changeSection } from "../../state/blend-actions";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, fields } from "../../ui/styles";
import { boundWords } from "../../words/bound";
import { blends as words } from "../../words/english/blends";
import { drawing } from "../../words/english/drawing";
import { pickFile } from "../../work/files";
import { type OutlineEvent, SECTION_SHEET } from "./section-sheet";
import "./section-sheet";
import { onSheet, type SvgLine, svgLines } from "./svg-lines";

const MARGIN = 40;
/** How far off a section is at most where nobody has said so, as a share of its reach. */
const USUAL = 0.02;
const FINEST = 0.001;

@customElement("pasu-section-dialog")
export class PasuSectionDialog extends DesignerElement {
  @property() end: End = "start";
  /** What the section is called. */
  @property() name = "";
  @state() private line: readonly Spot[] = [];
  @state() private drawn: DrawnOutline | null = null;
  @state() private lines: readonly SvgLine[] = [];
  @state() private chosen = 0;
  @state() private trouble = "";
  /** As a share of the reach. */
  @state() private tolerance = USUAL;

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("dragover", keepToItself);
    this.addEventListener("drop", this.dropped);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("dragover", keepToItself);
    this.removeEventListener("drop", this.dropped);
  }

  override render() {
    const { section } = this;
    if (!section) return nothing;
    const reach = reachOf(section);
    return html`<pasu-dialog ruled heading=${words.draw(this.name)} @dialog-closed=${this.close}>
      <p class="lead">${words.drawLead}</p>
      <pasu-section-sheet
        .line=${this.line}
        .curve=${this.drawn?.curve ?? []}
        .ghost=${ghostOf(section, reach)}
        @outline-drawn=${({ line }: OutlineEvent) => {
          this.lines = [];
          this.take(line);
        }}
      ></pasu-section-sheet>
      ${this.trouble === "" ? nothing : html`<p class="trouble" role="alert">${this.trouble}</p>`}
      <div class="acts">
        <button class="button outlined" type="button" @click=${this.pick}>${icon("paper")}<span>${drawing.svg}</span></button>
        ${this.file()}
      </div>
      <pasu-number
        .label=${drawing.tolerance}
        .unit=${unitOf(this.designer.store.design)}
        .help=${words.toleranceHelp}
        .value=${Number((reach * this.tolerance).toPrecision(3))}
        .min=${reach * FINEST}
        .max=${reach * 0.1}
        .step=${(reach * USUAL) / 10}
        @number-change=${({ value }: NumberChangeEvent) => {
          if (!(value > 0)) return;
          this.tolerance = value / reach;
          this.find();
        }}
      ></pasu-number>
      <p slot="actions" class="found" role="status">${this.told(reach)}</p>
      <button slot="actions" class="button primary" type="button" ?disabled=${this.drawn === null} @click=${this.use}>
        ${drawing.use}
      </button>
    </pasu-dialog>`;
  }

  private get section(): Section | null {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    return shape?.kind === "blend" ? shape[this.end] : null;
  }

  private told(reach: number) {
    const { drawn } = this;
    if (!drawn) return drawing.nothing;
    const off = (drawn.off / drawn.reach) * reach;
    return words.found(drawn.waves, boundWords(off, unitOf(this.designer.store.design)));
  }

  /** Which of the lines of a file it is. */
  private file() {
    const { lines } = this;
    if (lines.length < 2) return nothing;
    return html`<label>
      <span>${drawing.line}</span>
      <select class="field" @change=${(event: Event) => this.choose(Number((event.target as HTMLSelectElement).value))}>
        ${lines.map((_, i) => html`<option value=${i} .selected=${i === this.chosen}>${drawing.lineOf(i + 1, lines.length)}</option>`)}
      </select>
    </label>`;
  }

  private take(line: readonly Spot[]): void {
    this.line = line;
    this.trouble = "";
    this.find();
    if (!this.drawn) this.trouble = words.noArea;
  }

  private find(): void {
    const rough = outlineThrough(this.line, Number.POSITIVE_INFINITY);
    this.drawn = rough && outlineThrough(this.line, this.tolerance * rough.reach);
  }

  private choose(index: number): void {
    const line = this.lines[index];
    if (!line) return;
    this.chosen = index;
    this.take(line.points);
  }

  private readonly pick = async (): Promise<void> => {
    const file = await pickFile(".svg,image/svg+xml");
    if (file) await this.read(file);
  };

  private readonly dropped = (event: DragEvent): void => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    keepToItself(event);
    void this.read(file);
  };

  private async read(file: Blob): Promise<void> {
    const found = await svgLines(file);
    if (typeof found === "string") {
      this.trouble = drawing.refused[found];
      return;
    }
    this.lines = onSheet(found, SECTION_SHEET, MARGIN);
    // A line that closes is an outline sooner than one that does not.
    this.choose(
      Math.max(
        0,
        this.lines.findIndex(({ closed }) => closed),
      ),
    );
  }

  /** The section has the drawn outline, as large as it was. */
  private readonly use = (): void => {
    const { drawn, section, designer } = this;
    if (!drawn || !section) return;
    const { z, taper, dz } = section;
    const factor = reachOf(section) / drawn.reach;
    const outline = outlineBy(drawn, factor);
    designer.apply(changeSection(designer.state, this.end, () => ({ form: "outline", ...outline, z, taper, dz })));
    designer.notices.say(words.found(drawn.waves, boundWords(drawn.off * factor, unitOf(designer.store.design))));
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("section-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      .lead {
        padding-bottom: 10px;
        color: var(--soft);
        text-wrap: pretty;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 8px 14px;
        padding: 12px 0 4px;
      }
      .acts label {
        display: flex;
        align-items: center;
        gap: 8px;
      }
      .trouble {
        margin: 8px 0 0;
        padding: 8px 12px;
        border-radius: 9px;
        background: var(--warn-wash);
        color: var(--warn);
        font-size: 0.92rem;
      }
      .found {
        flex: 1;
        color: var(--soft);
      }
    `,
  ];
}

/** The section as it is, on the sheet. */
function ghostOf(section: Section, reach: number): readonly Spot[] {
  const scale = (SECTION_SHEET / 2 - MARGIN) / Math.max(reach, Number.MIN_VALUE);
  const middle = SECTION_SHEET / 2;
  return borderOf(section).map(([x, y]) => ({ x: middle + scale * x, y: middle - scale * y }));
}

function keepToItself(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-section-dialog": PasuSectionDialog;
  }
}
