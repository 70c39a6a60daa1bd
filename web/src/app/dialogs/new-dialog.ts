/** Choosing what a new design begins as. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { BEGINNINGS, type Beginning, beginningOf } from "../../document/beginnings";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { base } from "../../ui/styles";

@customElement("pasu-new")
export class PasuNew extends DesignerElement {
  override render() {
    return html`<pasu-dialog heading="New pot" @dialog-closed=${this.close}>
      <p>Your present pot stays within reach: undo brings it back.</p>
      <ul>
        ${BEGINNINGS.map(
          (beginning) => html`<li>
            <button type="button" @click=${() => this.choose(beginning)}>
              <strong>${beginning.title}</strong><span>${beginning.note}</span>
            </button>
          </li>`,
        )}
      </ul>
    </pasu-dialog>`;
  }

  private choose(beginning: Beginning): void {
    this.designer.opening.open(beginningOf(beginning.kind));
    this.close();
  }

  private readonly close = (): void => {
    this.dispatchEvent(new Event("new-closed"));
  };

  static override readonly styles = [
    base,
    css`
      p {
        color: var(--soft);
        padding-bottom: 12px;
      }
      ul {
        display: grid;
        gap: 8px;
      }
      button {
        display: grid;
        gap: 2px;
        width: 100%;
        padding: 11px 16px;
        border: 1px solid var(--line);
        border-radius: 12px;
        background: var(--sheet);
        text-align: left;
        cursor: pointer;
      }
      button:hover {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      span {
        color: var(--soft);
        font-size: 0.92rem;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-new": PasuNew;
  }
}
