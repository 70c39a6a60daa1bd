/** How much wet clay the pot begins with. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { millilitres } from "../../document/volume";
import { MOST_ALLOWANCE, MOST_SHRINKAGE, wedging } from "../../document/wedging";
import { DesignerElement } from "../../element/designer-element";
import { setAllowance, setExport } from "../../state/actions";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base } from "../../ui/styles";
import { wedging as words } from "../../words/english/wedging";
import { clayWords, countedWords } from "../../words/wedging";

type Percentage = "shrinkage" | "allowance";

const MOST: Readonly<Record<Percentage, number>> = { shrinkage: MOST_SHRINKAGE, allowance: MOST_ALLOWANCE };
/** Where the sliders end: what there is of clay bodies and of trimming. */
const REACH: Readonly<Record<Percentage, number>> = { shrinkage: 20, allowance: 60 };

@customElement("pasu-wedging")
export class PasuWedging extends DesignerElement {
  @state() private wrong: Percentage | null = null;

  override render() {
    const { made, state: now } = this.designer;
    const { export: chosen, allowance } = now.session;
    const clay = made?.measures.value?.clay;
    const of = made?.measures.of;
    if (!clay || !of?.parts.some((part) => part.wall)) return nothing;
    const unit = unitOf(of);
    const wet = wedging(millilitres(clay.volume.value, unit), chosen.shrinkage, allowance);
    return html`<section aria-labelledby="wedging" ?data-old=${!made?.isOfNow(made.measures)}>
      <div class="bar">
        <h3 id="wedging">${words.heading}</h3>
        <output aria-labelledby="wedging">${clayWords(wet.all, unit)}</output>
      </div>
      ${this.number("shrinkage", words.shrinkage, chosen.shrinkage)}
      ${this.number("allowance", words.allowance, allowance)}
      ${countedWords(wet, clay.mass.value, unit).map((text) => html`<p class="hint">${text}</p>`)}
    </section>`;
  }

  private number(of: Percentage, label: string, value: number) {
    return html`<pasu-number
      .label=${label}
      .unit=${"%"}
      .value=${value}
      .min=${0}
      .max=${REACH[of]}
      .step=${of === "shrinkage" ? 0.5 : 1}
      .problem=${this.wrong === of ? words.percentage(String(MOST[of])) : ""}
      @number-change=${({ value: next }: NumberChangeEvent) => this.take(of, next)}
    ></pasu-number>`;
  }

  private take(of: Percentage, value: number): void {
    const { designer } = this;
    const fits = value >= 0 && value < MOST[of];
    this.wrong = fits ? null : of;
    if (!fits) return;
    designer.apply(of === "shrinkage" ? setExport(designer.state, { shrinkage: value }) : setAllowance(value));
  }

  static override readonly styles = [
    base,
    css`
      :host {
        display: block;
      }
      section[data-old] output,
      section[data-old] .hint {
        opacity: 0.55;
      }
      .bar {
        display: flex;
        align-items: baseline;
        justify-content: space-between;
        gap: 14px;
        padding-bottom: 4px;
      }
      h3 {
        font-size: 1rem;
        font-weight: 650;
      }
      output {
        font-weight: 650;
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
      }
      .hint {
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-wedging": PasuWedging;
  }
}
