/** A link was opened over unsaved work: which of the two is to stay. */

import { html } from "lit";
import { customElement } from "lit/decorators.js";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { isolated } from "../../language";
import { base, buttons } from "../../ui/styles";
import { link } from "../../words/english/link";

@customElement("pasu-conflict")
export class PasuConflict extends DesignerElement {
  override render() {
    const { designer } = this;
    const { title } = designer.store.design;
    return html`<pasu-dialog heading=${link.open} @dialog-closed=${() => designer.opening.settleConflict("mine")}>
      <p>${title ? link.differsFrom(isolated(title)) : link.differs}</p>
      <button slot="actions" class="button outlined" type="button" @click=${() => designer.opening.settleConflict("mine")}>${link.keepMine}</button>
      <button slot="actions" class="button primary" type="button" @click=${() => designer.opening.settleConflict("theirs")}>${link.openIt}</button>
    </pasu-dialog>`;
  }

  static override readonly styles = [base, buttons];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-conflict": PasuConflict;
  }
}
