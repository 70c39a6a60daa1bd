/** A new blend by two pictures: the section at the foot and the one at the rim. */

import { css, html, LitElement } from "lit";
import { customElement, state } from "lit/decorators.js";
import { reachOf } from "../../document/blend/section";
import type { Exhibit } from "../../document/gallery/exhibit";
import { PLAN_NAMES, type PlanName, sampleOf, vaseBetween } from "../../document/gallery/section-choices";
import { radios } from "../../ui/radios";
import { base, buttons } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { drawingStyles, sectionDrawing } from "../drawing/section-drawing";

/** Both sections are chosen. */
export class BlendChosenEvent extends Event {
  readonly exhibit: Exhibit;
  constructor(exhibit: Exhibit) {
    super("blend-chosen");
    this.exhibit = exhibit;
  }
}

/** One scale for all of them. */
const REACH = Math.max(...PLAN_NAMES.map((name) => reachOf(sampleOf(name))));

@customElement("pasu-blend-chooser")
export class PasuBlendChooser extends LitElement {
  @state() private foot: PlanName = "square";
  @state() private rim: PlanName = "round";

  override render() {
    return html`
      ${this.row(words.rim, this.rim, (name) => {
        this.rim = name;
      })}
      ${this.row(words.foot, this.foot, (name) => {
        this.foot = name;
      })}
      <button class="button primary" type="button" @click=${() => this.dispatchEvent(new BlendChosenEvent(vaseBetween(this.foot, this.rim)))}>
        ${words.begin(words.plans[this.foot], words.plans[this.rim])}
      </button>
    `;
  }

  private row(legend: string, chosen: PlanName, choose: (name: PlanName) => void) {
    return html`<fieldset>
      <legend>${legend}</legend>
      <div>
        ${PLAN_NAMES.map(
          (name) => html`<label class="radio">
            <input type="radio" name=${legend} .checked=${name === chosen} @change=${() => choose(name)} />
            <span class="drawing" aria-hidden="true">${sectionDrawing(sampleOf(name), null, REACH, "")}</span>
            <span>${words.plans[name]}</span>
          </label>`,
        )}
      </div>
    </fieldset>`;
  }

  static override readonly styles = [
    base,
    buttons,
    radios,
    drawingStyles,
    css`
      :host {
        display: block;
        padding-bottom: 18px;
      }
      fieldset {
        margin: 0 0 12px;
        padding: 0;
        border: 0;
      }
      legend {
        padding: 0 0 6px;
        font-weight: 600;
      }
      fieldset div {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(66px, 1fr));
        gap: 8px;
      }
      label {
        display: grid;
        justify-items: center;
        gap: 2px;
        padding: 6px 6px 8px;
        border: 1px solid var(--line);
        border-radius: 10px;
        font-size: 0.88rem;
      }
      .drawing {
        width: 100%;
        max-width: 88px;
      }
      .section .seam,
      .section .middle {
        display: none;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-blend-chooser": PasuBlendChooser;
  }
}
