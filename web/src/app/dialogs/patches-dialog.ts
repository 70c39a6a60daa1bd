/** A patch of the equation, a Coons patch and a NURBS patch over the same edges, on one stage: whoever turns one turns all. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { besideOneAnother, type Shaping, SURFACES, USUAL } from "../../document/network/beside";
import type { Design } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { StageHolder } from "../../element/stage-holder";
import { stageKey } from "../../element/stage-keys";
import { stageModel } from "../../element/stage-model";
import type { SolvedParts } from "../../solver/solved";
import "../../ui/dialog";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base } from "../../ui/styles";
import { beside } from "../../words/english/beside";
import { LENGTH_LABELS } from "../../words/length";
import { whyWords } from "../../words/refusals";
import { thumbnailGrid } from "../../work/grid";

/** What each slider reaches. */
const FIELDS = [
  { key: "a1", min: 0.1, max: 8, step: 0.1, unit: "" },
  { key: "a2", min: 0.1, max: 8, step: 0.1, unit: "" },
  { key: "height", min: -6, max: 6, step: 0.1, unit: "cm" },
  { key: "width", min: 0.1, max: 1, step: 0.05, unit: "" },
] as const satisfies readonly { readonly key: keyof Shaping; readonly [more: string]: unknown }[];

@customElement("pasu-patches")
export class PasuPatches extends DesignerElement {
  @state() private shaping: Shaping = USUAL;
  @state() private problem = "";
  /** Said by what was typed last; an answer to what was typed before does not take it back. */
  @state() private isTooWide = false;
  @query(".stage") private readonly host!: HTMLElement;
  private shown: { readonly design: Design; readonly solved: SolvedParts } | null = null;
  private readonly holder = new StageHolder(this, {
    host: () => this.host,
    options: () => ({ theme: this.holder.dark ? "dark" : "light", lengths: LENGTH_LABELS.cm }),
    opened: () => this.display(),
    closing: () => {},
  });

  override render() {
    const problem = this.isTooWide ? beside.tooWide : this.problem;
    return html`<pasu-dialog wide heading=${beside.heading} @dialog-closed=${() => this.dispatchEvent(new Event("patches-closed"))}>
      <p>${beside.lead}</p>
      <div
        class="stage"
        tabindex="0"
        role="application"
        aria-label=${beside.stage}
        aria-describedby="keys"
        @keydown=${this.key}
      ></div>
      <p id="keys" class="spoken">${beside.keys}</p>
      ${this.holder.mode === "still" ? html`<p role="alert">${beside.noStage}</p>` : nothing}
      <ul>
        ${SURFACES.map(
          ({ name, glaze }) =>
            html`<li><strong data-glaze=${glaze}>${beside.names[name]}</strong> <span>${beside.notes[name]}</span></li>`,
        )}
      </ul>
      <section aria-label=${beside.shaping}>
        <h3>${beside.shaping}</h3>
        <div class="fields">
          ${FIELDS.map(
            ({ key, min, max, step, unit }) => html`<pasu-number
              .label=${beside[key]}
              .unit=${unit}
              .value=${this.shaping[key]}
              .min=${min}
              .max=${max}
              .step=${step}
              @number-change=${({ value }: NumberChangeEvent) => this.shape(key, value)}
            ></pasu-number>`,
          )}
        </div>
        ${problem === "" ? nothing : html`<p role="alert">${problem}</p>`}
      </section>
    </pasu-dialog>`;
  }

  override firstUpdated(): void {
    void this.holder.open();
  }

  override updated(changed: PropertyValues): void {
    if (changed.has("shaping" as keyof this)) void this.solve();
  }

  /** Typed numbers may be any: what cannot be is refused by the solver, but for a region that would reach the edges. */
  private shape(key: keyof Shaping, value: number): void {
    this.isTooWide = key === "width" && value > 1;
    if (!this.isTooWide) this.shaping = { ...this.shaping, [key]: value };
  }

  private async solve(): Promise<void> {
    const design = besideOneAnother(this.shaping);
    const { rows, columns } = thumbnailGrid(1);
    const outcome = await this.designer.solver.mesh("patches compared", design, 2 * rows, 2 * columns);
    if (outcome.state === "superseded" || !this.isConnected) return;
    this.problem = outcome.state === "refused" ? beside.refused(whyWords(outcome.refusal)) : "";
    if (outcome.state !== "done") return;
    this.shown = { design, solved: outcome.value };
    this.display();
  }

  private display(): void {
    const { shown } = this;
    if (shown) this.holder.stage?.show(stageModel(shown.design, shown.solved));
  }

  private readonly key = (event: KeyboardEvent): void => {
    const { stage } = this.holder;
    if (!stage || !stageKey(event, stage)) return;
    event.preventDefault();
    event.stopPropagation();
  };

  static override readonly styles = [
    base,
    css`
      p,
      li {
        color: var(--soft);
        text-wrap: pretty;
      }
      .stage {
        position: relative;
        height: clamp(12rem, 42vh, 26rem);
        margin: 12px 0;
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 10px;
        touch-action: none;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fit, minmax(min(13rem, 100%), 1fr));
        gap: 8px 16px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        font-size: 0.92rem;
      }
      strong {
        display: block;
        color: var(--ink);
      }
      strong::before {
        display: inline-block;
        width: 0.7em;
        height: 0.7em;
        margin-inline-end: 0.5em;
        border: 1px solid var(--edge);
        border-radius: 50%;
        background: var(--chip);
        content: "";
      }
      [data-glaze="celadon"] {
        --chip: #9fbfa5;
      }
      [data-glaze="shino"] {
        --chip: #e8d5c0;
      }
      [data-glaze="cobalt"] {
        --chip: #2c4a8c;
      }
      h3 {
        padding: 14px 0 8px;
        font-size: 0.95rem;
        font-weight: 650;
      }
      .fields {
        display: grid;
        grid-template-columns: repeat(auto-fit, minmax(min(15rem, 100%), 1fr));
        gap: 4px 20px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-patches": PasuPatches;
  }
}
