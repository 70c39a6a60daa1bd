/** Which part of the pot the panels are about, where there are several. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { DesignerElement } from "../../element/designer-element";
import { selectPart } from "../../state/actions";
import { base, fields } from "../../ui/styles";

@customElement("pasu-part-choice")
export class PasuPartChoice extends DesignerElement {
  override render() {
    const { designer } = this;
    const { design, session } = designer.store;
    if (design.parts.length < 2) return nothing;
    return html`<label>
      <span>Part</span>
      <select
        class="field"
        @change=${(event: Event) =>
          designer.apply(selectPart(designer.state, Number((event.target as HTMLSelectElement).value)))}
      >
        ${design.parts.map(
          (part, index) =>
            html`<option value=${index} ?selected=${index === session.part}>${part.name ?? `Part ${index + 1}`}</option>`,
        )}
      </select>
    </label>`;
  }

  static override readonly styles = [
    base,
    fields,
    css`
      :host {
        display: block;
      }
      label {
        display: flex;
        align-items: center;
        gap: 12px;
        padding-bottom: 12px;
      }
      .field {
        flex: 1;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-part-choice": PasuPartChoice;
  }
}
