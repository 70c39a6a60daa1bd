/** Which map colours the pot, and its legend. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { MAPS, mapOf } from "../../document/maps";
import type { MapName } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { setMap } from "../../state/wall-actions";
import { base, fields } from "../../ui/styles";
import "./legend";
import { maps } from "../../words/english/maps";
import { refusalWords } from "../../words/refusals";

@customElement("pasu-maps")
export class PasuMaps extends DesignerElement {
  override render() {
    const { designer } = this;
    const { design, session } = designer.state;
    const walled = design.parts.some((part) => part.wall !== undefined);
    const { map } = session;
    const painted = designer.made?.painted;
    const lined = designer.made?.lining.value;
    return html`<label>
        <span>${maps.show}</span>
        <select
          class="field"
          @change=${(event: Event) =>
            designer.apply(setMap(((event.target as HTMLSelectElement).value || null) as MapName | null))}
        >
          <option value="" .selected=${map === null}>${maps.glaze}</option>
          ${MAPS.map(
            ({ name, needsWall }) =>
              html`<option value=${name} .selected=${map === name} ?disabled=${needsWall && !walled}>
                ${needsWall && !walled ? maps.needsWall(maps.options[name]) : maps.options[name]}
              </option>`,
          )}
        </select>
      </label>
      ${
        map === null
          ? nothing
          : html`<pasu-legend .map=${mapOf(map)} .painted=${painted?.value ?? null} .lined=${lined ?? null} .unit=${unitOf(design)}></pasu-legend>
              ${painted?.problem ? html`<p class="problem" role="status">${refusalWords(painted.problem, design)}</p>` : nothing}`
      } `;
  }

  static override readonly styles = [
    base,
    fields,
    css`
      :host {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: 10px;
      }
      label {
        display: flex;
        align-items: center;
        justify-content: space-between;
        gap: 12px;
        font-weight: 600;
      }
      select {
        flex: 1;
        min-width: 0;
        max-width: 240px;
        font-weight: 400;
      }
      .problem {
        color: var(--warn);
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-maps": PasuMaps;
  }
}
