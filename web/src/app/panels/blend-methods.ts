/** The same blend by each method side by side: its time, its terms, and what it leaves of the equation. Fetched when somebody asks. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Blend, Refusal } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import type { Solved } from "../../maker/messages";
import { formatNumber } from "../../number";
import { base, buttons } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { page } from "../../words/english/page";
import { lengthWords } from "../../words/quantities";
import { refusalWords } from "../../words/refusals";

const LANE = "methods";
const DIGITS = 2;

@customElement("pasu-blend-methods")
export class PasuBlendMethods extends DesignerElement {
  @state() private told: { readonly blend: Blend; readonly ways: readonly Solved[] } | null = null;
  @state() private refusal: Refusal | null = null;
  @state() private asking = false;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.designer.made?.maker.cancel(LANE);
    this.asking = false;
  }

  override firstUpdated(): void {
    void this.ask();
  }

  override render() {
    const { told, refusal, asking } = this;
    const { design, part } = this.designer.state;
    const old = told !== null && told.blend !== design.parts[part]?.shape;
    return html`
      <div role="status">
        ${asking ? html`<p>${page.checking}</p>` : nothing}
        ${refusal ? html`<p class="warn">${refusalWords(refusal, design)}</p>` : nothing}
        ${old ? html`<p>${words.methodsOld}</p>` : nothing}
      </div>
      ${told ? this.table(told.ways, old) : nothing}
      ${old ? html`<button class="button outlined" type="button" @click=${() => void this.ask()}>${words.compareAgain}</button>` : nothing}
    `;
  }

  private table(ways: readonly Solved[], old: boolean) {
    const unit = unitOf(this.designer.store.design);
    const rows: readonly (readonly [string, (way: Solved) => string])[] = [
      [words.methodTime, ({ milliseconds }) => words.milliseconds(short(milliseconds))],
      [words.terms, ({ terms }) => (terms.length === 0 ? words.noTerms : terms.map(String).join(" × "))],
      [words.methodResidual, ({ residual }) => words.residualOf(short(residual), unit)],
      [words.methodMean, ({ mean }) => words.residualOf(short(mean), unit)],
      [words.methodApart, ({ apart }) => lengthWords(Number(apart.toFixed(6)), unit)],
      [words.methodLoft, ({ fromLoft }) => lengthWords(Number(fromLoft.toFixed(6)), unit)],
    ];
    return html`<table ?data-old=${old}>
      <caption class="spoken">${words.compareMethods}</caption>
      <thead>
        <tr>
          <td></td>
          ${ways.map(({ method }) => html`<th scope="col">${words.methods[method].name}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${rows.map(([name, of]) => html`<tr><th scope="row">${name}</th>${ways.map((way) => html`<td>${of(way)}</td>`)}</tr>`)}
      </tbody>
    </table>
    <p class="about">${words.methodsAbout}</p>`;
  }

  private async ask(): Promise<void> {
    const { designer } = this;
    const opened = await designer.openMade();
    if (!opened || !this.isConnected) return;
    const { design, part } = designer.state;
    const blend = design.parts[part]?.shape;
    if (blend?.kind !== "blend") return;
    this.asking = true;
    const outcome = await opened.maker.ask({ kind: "methods", design, part }, LANE);
    if (!this.isConnected || outcome.state === "superseded") return;
    this.asking = false;
    this.refusal = outcome.state === "refused" ? outcome.refusal : null;
    this.told = outcome.state === "done" ? { blend, ways: outcome.value } : null;
  }

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        display: block;
        padding-top: 12px;
      }
      table {
        width: 100%;
        border-collapse: collapse;
        font-size: 0.86rem;
        font-variant-numeric: tabular-nums;
      }
      table[data-old] {
        opacity: 0.55;
      }
      th,
      td {
        padding: 5px 4px;
        border-bottom: 1px solid var(--line);
        text-align: end;
        vertical-align: top;
      }
      th[scope="row"] {
        color: var(--soft);
        font-weight: 400;
        text-align: start;
      }
      .about {
        padding-top: 8px;
        color: var(--soft);
        font-size: 0.86rem;
        text-wrap: pretty;
      }
      .warn {
        color: var(--warn);
      }
    `,
  ];
}

function short(value: number): string {
  return formatNumber(Number(value.toPrecision(DIGITS)));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-blend-methods": PasuBlendMethods;
  }
}
