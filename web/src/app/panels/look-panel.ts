/** Glaze, clay and unit, and which part of the design is being edited. */

import { css, html, unsafeCSS } from "lit";
import { customElement } from "lit/decorators.js";
import { lookOf, unitOf } from "../../document/look";
import * as tables from "../../document/tables.gen";
import type { ClayName, GlazeName, Unit } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { setLook, setUnit } from "../../state/actions";
import { base, fields } from "../../ui/styles";
import { look } from "../../words/english/look";
import { quantities } from "../../words/english/quantities";

/** The colours of the tables: nothing of a document. */
const SWATCHES = unsafeCSS(
  Object.entries({ ...tables.GLAZES, ...tables.CLAYS })
    .map(([name, colour]) => `.${name} { --colour: ${colour}; }`)
    .join("\n"),
);

@customElement("pasu-look")
export class PasuLook extends DesignerElement {
  override render() {
    const { designer } = this;
    const { design, part } = designer.state;
    const chosen = lookOf(design.parts[part]);
    return html`
      <fieldset>
        <legend>${look.glaze}</legend>
        <div class="swatches">
          ${entries<GlazeName>(look.glazes).map(
            ([name, label]) => html`<label class="swatch">
              <input
                type="radio"
                name="glaze"
                .checked=${chosen.glaze === name}
                @change=${() => designer.apply(setLook(designer.state, { glaze: name }))}
              />
              <span class="dot ${name}"></span><span>${label}</span>
            </label>`,
          )}
        </div>
      </fieldset>
      <fieldset>
        <legend>${look.clay}</legend>
        <div class="swatches">
          ${entries<ClayName>(look.clays).map(
            ([name, label]) => html`<label class="swatch">
              <input
                type="radio"
                name="clay"
                .checked=${chosen.clay === name}
                @change=${() => designer.apply(setLook(designer.state, { clay: name }))}
              />
              <span class="dot ${name}"></span><span>${label}</span>
            </label>`,
          )}
        </div>
      </fieldset>
      <label class="unit">
        <span>${look.unit}</span>
        <select
          class="field"
          aria-label=${look.unitOfLength}
          @change=${(event: Event) =>
            designer.apply(setUnit(designer.state, (event.target as HTMLSelectElement).value as Unit))}
        >
          ${entries<Unit>(look.units).map(
            ([unit, label]) =>
              html`<option value=${unit} ?selected=${unitOf(design) === unit}>${look.unitChoice(label, quantities.units[unit])}</option>`,
          )}
        </select>
      </label>
      <p class="hint">${look.staysAsLarge}</p>
    `;
  }

  static override readonly styles = [
    base,
    fields,
    css`
      :host {
        display: block;
      }
      fieldset {
        margin: 0 0 18px;
        padding: 0;
        border: 0;
      }
      legend {
        padding: 0 0 8px;
        font-weight: 650;
      }
      .swatches {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(150px, 1fr));
        gap: 8px;
      }
      .swatch {
        position: relative;
        display: flex;
        align-items: center;
        gap: 10px;
        min-height: 48px;
        padding: 0 12px;
        border: 1px solid var(--line);
        border-radius: 12px;
        cursor: pointer;
      }
      .swatch:hover {
        background: var(--well);
      }
      .swatch:has(:checked) {
        border-color: var(--accent);
        background: var(--accent-wash);
        box-shadow: inset 0 0 0 1px var(--accent);
      }
      .swatch:has(:focus-visible) {
        outline: 2.5px solid var(--accent);
        outline-offset: 2px;
      }
      .swatch input {
        position: absolute;
        opacity: 0;
        inset: 0;
        margin: 0;
        cursor: pointer;
      }
      .dot {
        width: 26px;
        height: 26px;
        flex: none;
        border-radius: 50%;
        background: var(--colour);
        box-shadow:
          inset 3px 3px 6px rgb(255 255 255 / 0.45),
          inset -4px -4px 8px rgb(0 0 0 / 0.28);
      }
      ${SWATCHES}
      .unit {
        display: flex;
        align-items: center;
        justify-content: space-between;
        gap: 12px;
        padding-top: 14px;
        border-top: 1px solid var(--line);
      }
      .hint {
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.88rem;
      }
    `,
  ];
}

function entries<K extends string>(record: Readonly<Record<K, string>>): readonly (readonly [K, string])[] {
  return Object.entries(record) as [K, string][];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-look": PasuLook;
  }
}
