/** The link of the pot, to be copied by hand where the browser does not let the page do it. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import "../../ui/dialog";
import { base, fields } from "../../ui/styles";
import { link } from "../../words/english/link";

@customElement("pasu-link")
export class PasuLink extends LitElement {
  @property() address = "";

  override render() {
    return html`<pasu-dialog heading=${link.heading} @dialog-closed=${() => this.dispatchEvent(new Event("link-closed"))}>
      <p>${link.lead}</p>
      <input
        class="field"
        aria-label=${link.link}
        readonly
        .value=${this.address}
        @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
      />
    </pasu-dialog>`;
  }

  static override readonly styles = [
    base,
    fields,
    css`
      .field {
        width: 100%;
        margin-top: 10px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-link": PasuLink;
  }
}
