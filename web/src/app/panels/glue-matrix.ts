/** Which parts are glued to which: the connectivity matrix of the scene, read by rows and pressed to change it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { DesignerElement } from "../../element/designer-element";
import { glueTogether, objectOf, separateParts } from "../../state/scene-actions";
import { base, disclosure } from "../../ui/styles";
import { parts as words } from "../../words/english/parts";
import { partName } from "../../words/parts";

/** A larger matrix can neither be read nor be pressed. */
const MOST = 24;

@customElement("pasu-glue-matrix")
export class PasuGlueMatrix extends DesignerElement {
  override render() {
    const { ids } = this.designer.store;
    return html`<details>
      <summary><h3>${words.matrix}</h3></summary>
      ${ids.length > MOST ? html`<p class="note">${words.matrixMany(MOST)}</p>` : this.matrix()}
    </details>`;
  }

  private matrix() {
    const { design, ids } = this.designer.store;
    const names = design.parts.map(({ name }, place) => partName(place, name));
    const objects = design.parts.map(objectOf);
    return html`<p class="note">${words.matrixNote}</p>
      <div class="scroll" tabindex="0" role="group" aria-label=${words.matrix}>
        <table>
          <thead>
            <tr>
              <td></td>
              ${ids.map((_, at) => html`<th scope="col"><span>${names[at]}</span></th>`)}
            </tr>
          </thead>
          <tbody>
            ${ids.map(
              (_, row) => html`<tr>
                <th scope="row">${names[row]}</th>
                ${ids.map((__, column) => html`<td>${row === column ? nothing : this.field(row, column, names, objects)}</td>`)}
              </tr>`,
            )}
          </tbody>
        </table>
      </div>`;
  }

  private field(row: number, column: number, names: readonly string[], objects: readonly number[]) {
    const glued = objects[row] === objects[column];
    return html`<button
      type="button"
      aria-pressed=${glued ? "true" : "false"}
      aria-label=${words.pair(names[row] ?? "", names[column] ?? "")}
      title=${glued ? words.glued : nothing}
      @click=${() => this.toggle(row, column, glued)}
    ></button>`;
  }

  private toggle(row: number, column: number, glued: boolean): void {
    const { designer } = this;
    const { ids } = designer.store;
    const pair = [ids[column], ids[row]].filter((id) => id !== undefined);
    designer.apply(
      glued ? separateParts(designer.state, pair.slice(-1)) : glueTogether(designer.state, pair.toReversed()),
    );
  }

  static override readonly styles = [
    base,
    disclosure,
    css`
      :host {
        display: block;
      }
      .note {
        padding-bottom: 6px;
        color: var(--soft);
        font-size: 0.88rem;
      }
      .scroll {
        overflow: auto;
      }
      table {
        border-collapse: collapse;
        font-size: 0.86rem;
      }
      th {
        max-width: 9em;
        overflow: hidden;
        padding: 2px 8px 2px 0;
        color: var(--soft);
        font-weight: normal;
        text-align: start;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      thead th {
        height: 5.5em;
        padding: 0;
        vertical-align: bottom;
      }
      thead th span {
        display: inline-block;
        max-height: 5.5em;
        overflow: hidden;
        writing-mode: vertical-rl;
        rotate: 180deg;
      }
      tbody td {
        padding: 0;
        border: 1px solid var(--line);
      }
      button {
        display: grid;
        place-items: center;
        width: 28px;
        height: 28px;
        padding: 0;
        border: 0;
        background: none;
        cursor: pointer;
      }
      button:hover {
        background: var(--well);
      }
      button[aria-pressed="true"]::before {
        content: "";
        width: 14px;
        height: 14px;
        border-radius: 50%;
        background: var(--accent);
      }
      @media (pointer: coarse) {
        button {
          width: var(--touch);
          height: var(--touch);
        }
      }
      @media (forced-colors: active) {
        button[aria-pressed="true"]::before {
          background: Highlight;
          forced-color-adjust: none;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-glue-matrix": PasuGlueMatrix;
  }
}
