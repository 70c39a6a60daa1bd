/** What is inside a blend as cells for programs of analysis: how many, what they are, how well they are shaped. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { CELL_SHAPES, CELLS_FORMATS, type CellShape, type CellsFormat } from "../../document/blend/cells";
import type { Refusal, Triple } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { grouped, isolated } from "../../language";
import type { MadeCells } from "../../maker/cells";
import { formatNumber } from "../../number";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { page } from "../../words/english/page";
import { refusalWords } from "../../words/refusals";
import { fileName, saveBlob } from "../../work/files";

const LANE = "export cells";
/** Those of the solver where nothing is said. */
const USUAL: Triple = [4, 16, 16];
/** A file of more would be no help, and long in coming. */
const MOST = 128;
const TYPING_MS = 300;
const DIGITS = 3;

@customElement("pasu-export-cells")
export class PasuExportCells extends DesignerElement {
  @state() private counts: Triple = USUAL;
  @state() private shape: CellShape = "hexahedron";
  @state() private told: MadeCells | null = null;
  @state() private refusal: Refusal | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  @state() private opened = false;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.timer);
    this.designer.made?.maker.cancel(LANE);
  }

  override render() {
    return html`<details @toggle=${this.toggled}>
      <summary>${words.cells}</summary>
      <p class="about">${words.cellsAbout}</p>
      <div class="counts" role="group" aria-label=${words.cellCounts}>
        ${this.counts.map((count, index) => {
          const label = words.along[index] ?? "";
          return html`<span class="cell"
            ><span aria-hidden="true">${label}</span
            ><pasu-number
              compact
              .label=${words.of(words.cellCounts, label)}
              .value=${count}
              .step=${1}
              .within=${[1, MOST]}
              .counted=${true}
              @number-change=${({ value }: NumberChangeEvent) => this.count(index, value)}
            ></pasu-number
          ></span>`;
        })}
      </div>
      ${choices(
        words.cellShape,
        CELL_SHAPES.map((value) => ({ value, label: words.cellShapes[value] })),
        this.shape,
        (shape) => {
          this.shape = shape;
          this.askSoon();
        },
      )}
      <p class="told" role="status">${this.verdict()}</p>
      <div class="acts">
        ${CELLS_FORMATS.map(
          (
            format,
          ) => html`<button class="button outlined" type="button" ?disabled=${this.told === null} @click=${() => void this.save(format)}>
            ${words.cellFormats[format]}
          </button>`,
        )}
      </div>
    </details>`;
  }

  private verdict() {
    const { told, refusal } = this;
    if (refusal) return html`<span class="warn">${refusalWords(refusal, this.designer.store.design)}</span>`;
    if (!told) return this.opened ? page.checking : nothing;
    const least = formatNumber(Number(told.least.toPrecision(DIGITS)));
    const good = words.cellsTold(grouped(told.count), least);
    return told.useless === 0 ? good : html`${good} <span class="warn">${words.cellsUseless(told.useless)}</span>`;
  }

  private readonly toggled = (event: Event): void => {
    if (!(event.target as HTMLDetailsElement).open || this.opened) return;
    this.opened = true;
    void this.ask(null);
  };

  private count(index: number, count: number): void {
    this.counts = this.counts.map((each, at) => (at === index ? count : each)) as unknown as Triple;
    this.askSoon();
  }

  private askSoon(): void {
    clearTimeout(this.timer);
    this.told = null;
    this.timer = setTimeout(() => void this.ask(null), TYPING_MS);
  }

  /** What they are like; their file too where one is wanted. */
  private async ask(format: CellsFormat | null): Promise<MadeCells | null> {
    const { designer, counts, shape } = this;
    const opened = await designer.openMade();
    if (!opened) return null;
    const { design, part } = designer.state;
    const outcome = await opened.maker.ask({ kind: "cells", design, part, counts, shape, format }, LANE);
    if (!this.isConnected || outcome.state === "superseded") return null;
    this.refusal = outcome.state === "refused" ? outcome.refusal : null;
    this.told = outcome.state === "done" ? outcome.value : null;
    return this.told;
  }

  private async save(format: CellsFormat): Promise<void> {
    const made = await this.ask(format);
    if (!made?.bytes) return;
    const name = fileName(this.designer.state.design.title, format);
    saveBlob(new Blob([made.bytes], { type: "application/octet-stream" }), name);
    this.designer.notices.say(page.savedAs(isolated(name)));
  }

  static override readonly styles = [
    base,
    buttons,
    choiceStyles,
    css`
      :host {
        display: block;
        margin-top: 14px;
        border-top: 1px solid var(--line);
      }
      summary {
        min-height: var(--touch);
        padding: 12px 0;
        font-weight: 600;
        cursor: pointer;
      }
      .about,
      .told {
        color: var(--soft);
        text-wrap: pretty;
      }
      .told {
        min-height: 1.5em;
        padding: 10px 0;
      }
      .warn {
        color: var(--warn);
      }
      .counts {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
        padding-top: 10px;
      }
      .cell {
        display: grid;
        gap: 3px;
        min-width: 0;
        color: var(--soft);
        font-size: 0.86rem;
      }
      .cell pasu-number {
        padding: 0;
        color: var(--ink);
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-export-cells": PasuExportCells;
  }
}
