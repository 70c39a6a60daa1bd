/** A link was opened over unsaved work: which of the two is to stay. */

import { html } from "lit";
import { customElement } from "lit/decorators.js";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { base, buttons } from "../../ui/styles";

@customElement("pasu-conflict")
export class PasuConflict extends DesignerElement {
  override render() {
    const { designer } = this;
    const { title } = designer.store.design;
    return html`<pasu-dialog heading="Open this link?" @dialog-closed=${() => designer.opening.settleConflict("mine")}>
      <p>
        This link differs from your unsaved work${title ? html` “${title}”` : ""}. Opening it can be undone as long as this page stays open.
      </p>
      <button slot="actions" class="button outlined" type="button" @click=${() => designer.opening.settleConflict("mine")}>Keep mine</button>
      <button slot="actions" class="button primary" type="button" @click=${() => designer.opening.settleConflict("theirs")}>Open the link</button>
    </pasu-dialog>`;
  }

  static override readonly styles = [base, buttons];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-conflict": PasuConflict;
  }
}
