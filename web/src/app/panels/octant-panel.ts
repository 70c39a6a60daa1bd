/** The exponents of an octant, and octants that have a name. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { alike, PRESETS, presetOf } from "../../document/octant/presets";
import { pathText } from "../../document/path";
import type { Octant } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { toggleExplain } from "../../state/actions";
import { changeOctant } from "../../state/octant-actions";
import "../../ui/number-field";
import { intro } from "../../ui/intro";
import type { NumberChangeEvent, NumberResetEvent } from "../../ui/number-field";
import { base, buttons, pointed } from "../../ui/styles";
import { octants as words } from "../../words/english/octants";
import { explainButton } from "./explain-button";

const SYMBOLS = ["a", "b", "c"];
/** What a slider goes through; what is typed may be anything that there is. */
const LEAST = 0.2;
const MOST = 10;
const STEP = 0.1;

@customElement("pasu-octant")
export class PasuOctant extends DesignerElement {
  override render() {
    const { design, part } = this.designer.state;
    const octant = design.parts[part]?.shape;
    if (octant?.kind !== "octant") return html``;
    const opened = this.originOf(octant);
    const chosen = presetOf(octant);
    return html`
      <div class="intro">
        <p><strong>${words.lead}</strong> ${words.about}</p>
        ${explainButton(this.designer.store.session.explain, () => this.designer.apply(toggleExplain(this.designer.state)))}
      </div>
      <div class="presets" role="group" aria-label=${words.presets}>
        ${PRESETS.map(
          ({ id, exponent }) => html`<button
            class="button outlined"
            type="button"
            data-preset=${id}
            aria-pressed=${id === chosen ? "true" : "false"}
            @click=${() => this.designer.apply(changeOctant(this.designer.state, () => alike(exponent)))}
          >
            ${words.names[id]}
          </button>`,
        )}
      </div>
      ${octant.exponents.map((value, axis) => this.exponent(axis, value, opened.exponents[axis] ?? value))}
    `;
  }

  private originOf(octant: Octant): Octant {
    const { origin, state } = this.designer;
    const opened = origin.design.parts[state.part]?.shape;
    return opened?.kind === "octant" ? opened : octant;
  }

  private exponent(axis: number, value: number, opened: number) {
    const { designer } = this;
    const path = ["exponents", axis];
    const set = (to: number, gesture: boolean) =>
      designer.apply(
        changeOctant(
          designer.state,
          (octant) => {
            const [a, b, c] = octant.exponents.with(axis, to);
            return a === undefined || b === undefined || c === undefined || octant.exponents[axis] === to
              ? octant
              : { ...octant, exponents: [a, b, c] };
          },
          gesture ? `${axis}` : undefined,
        ),
      );
    return html`<pasu-number
      data-field="exponent-${axis}"
      data-at=${pathText(path)}
      .label=${words.exponents[axis] ?? ""}
      .symbol=${SYMBOLS[axis] ?? ""}
      .help=${words.help}
      .explain=${designer.store.session.explain}
      .problem=${this.problemAt(path)}
      .value=${value}
      .opened=${opened}
      .min=${LEAST}
      .max=${MOST}
      .step=${STEP}
      @number-change=${({ value: to, gesture }: NumberChangeEvent) => set(to, gesture)}
      @number-done=${() => designer.store.endGesture()}
      @number-cancel=${() => designer.store.cancelGesture()}
      @number-reset=${(_: NumberResetEvent) => set(opened, false)}
    ></pasu-number>`;
  }

  static override readonly styles = [
    base,
    intro,
    buttons,
    pointed,
    css`
      :host {
        display: block;
      }
      .presets {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        padding-bottom: 10px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-octant": PasuOctant;
  }
}
