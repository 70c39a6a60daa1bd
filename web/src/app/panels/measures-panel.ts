/** What the pot measures, whether it can be made, the water in it and the colours on it. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { isSolid } from "../../document/closes";
import { unitOf } from "../../document/look";
import type { Design } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { icon } from "../../ui/icons";
import "./map-choice";
import "./size-panel";
import "./wedging-panel";
import { base, buttons } from "../../ui/styles";
import { hiddenNote } from "../hidden-note";
import { sentenceStyles, sentences } from "../sentences";
import { remedies, remedyStyles } from "./remedies";
import "./water-control";
import { measures } from "../../words/english/measures";
import { page } from "../../words/english/page";
import { type Group, type Line, measureGroups } from "../../words/measures";
import { partName } from "../../words/parts";
import { refusalWords } from "../../words/refusals";
import { verdictNow } from "../../work/verdict";

@customElement("pasu-measures")
export class PasuMeasures extends DesignerElement {
  @state() private exact = false;

  override render() {
    const { designer } = this;
    const { accuracy } = designer.surface;
    return html`
      <pasu-size .designer=${designer}></pasu-size>
      ${hiddenNote(designer)}
      ${this.canBeMade()}
      <pasu-water .designer=${designer}></pasu-water>
      <pasu-maps .designer=${designer}></pasu-maps>
      ${this.numbers()}
      <pasu-wedging .designer=${designer}></pasu-wedging>
      ${accuracy === "" ? nothing : html`<p class="hint">${accuracy}</p>`}
    `;
  }

  private canBeMade() {
    const { designer } = this;
    const { state: now } = designer;
    if (!now.design.parts.some((part) => part.wall)) {
      const open = now.design.parts.map(({ shape }) => shape).filter((shape) => !isSolid(shape));
      const hasRim = open.some(({ kind }) => kind !== "vertex-frame");
      const said = open.length === 0 ? measures.isSolid : hasRim ? measures.isSurface : measures.isSheet;
      return html`<p class="lead">${said}</p>`;
    }
    const found = verdictNow(designer);
    return html`<section aria-labelledby="made">
      <h3 id="made">${measures.canBeMade}</h3>
      ${found.length > 0 ? sentences(found) : html`<p class="wait" role="status">${page.checking}</p>`}
      ${remedies(designer)}
    </section>`;
  }

  private numbers() {
    const { made, state: now } = this.designer;
    const piece = made?.measures;
    const rewalled = piece?.of && wallsOf(piece.of) !== wallsOf(now.design);
    if (!piece?.value || !piece.of || rewalled) {
      const why = piece?.problem && !rewalled && refusalWords(piece.problem, now.design);
      return why
        ? html`<p class="problem" role="status">${icon("warn")}<span>${why}</span></p>`
        : html`<p class="wait">${page.checking}</p>`;
    }
    const old = !made?.isOfNow(piece);
    const { parts } = now.design;
    const name = parts.length > 1 ? partName(now.part, parts[now.part]?.name) : null;
    const groups = measureGroups(piece.value, now.part, unitOf(piece.of), this.exact, name);
    return html`
      <div class="bar">
        <h3>${measures.heading} ${old ? html`<span class="wait">${page.checking}</span>` : nothing}</h3>
        <button
          class="button outlined"
          type="button"
          aria-pressed=${this.exact ? "true" : "false"}
          @click=${() => {
            this.exact = !this.exact;
          }}
        >
          ${measures.howExact}
        </button>
      </div>
      ${this.exact ? html`<p class="hint">${measures.exactMeans}</p>` : nothing}
      <div class="groups" ?data-old=${old}>${groups.map((group) => this.group(group))}</div>
    `;
  }

  private group({ title, lines, reason }: Group) {
    return html`<section>
      <h4>${title}</h4>
      ${reason === undefined ? nothing : html`<p class="reason">${reason}</p>`}
      ${lines.length === 0 ? nothing : html`<dl>${lines.map((line) => this.line(line))}</dl>`}
    </section>`;
  }

  private line({ name, value, error, note }: Line) {
    return html`<div>
      <dt><span>${name}</span>${note === undefined ? nothing : html`<span class="note">${note}</span>`}</dt>
      <dd>${value}${this.exact && error !== "" ? html`<span class="error">${error}</span>` : nothing}</dd>
    </div>`;
  }

  static override readonly styles = [
    base,
    buttons,
    sentenceStyles,
    remedyStyles,
    css`
      :host {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: 18px;
      }
      h3 {
        font-size: 1rem;
        font-weight: 650;
      }
      h4 {
        padding-bottom: 2px;
        color: var(--soft);
        font-size: 0.84rem;
        font-weight: 600;
      }
      .lead,
      .hint {
        color: var(--soft);
        font-size: 0.92rem;
        text-wrap: pretty;
      }
      .bar {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      .groups {
        display: grid;
        gap: 14px;
      }
      .groups[data-old] {
        opacity: 0.55;
      }
      dl {
        margin: 0;
      }
      dl div {
        display: flex;
        align-items: baseline;
        justify-content: space-between;
        gap: 14px;
        padding: 6px 0;
        border-top: 1px solid var(--line);
      }
      dt {
        text-wrap: pretty;
      }
      dd {
        margin: 0;
        text-align: right;
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
      }
      .note,
      .error {
        display: block;
        color: var(--soft);
        font-size: 0.82rem;
      }
      .reason {
        padding: 6px 0;
        text-wrap: pretty;
      }
      .problem {
        display: flex;
        gap: 8px;
        color: var(--warn);
      }
      .wait {
        color: var(--soft);
      }
      h3 .wait {
        padding-left: 6px;
        font-size: 0.84rem;
        font-weight: 400;
      }
    `,
  ];
}

/** Which parts have a wall, to be compared: measures of a surface say nothing of a pot. */
function wallsOf({ parts }: Design): string {
  return parts.map(({ wall }) => (wall ? "pot" : "surface")).join();
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-measures": PasuMeasures;
  }
}
