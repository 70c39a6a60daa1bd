/** The link of the pot, with how it is looked at if that is wanted, or to be copied by hand where the browser does not let the page do it. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import "../../ui/dialog";
import { checks } from "../../ui/checks";
import { base, buttons, fields } from "../../ui/styles";
import { link } from "../../words/english/link";

@customElement("pasu-link")
export class PasuLink extends LitElement {
  @property() address = "";
  /** The same with the view in it; empty where only the other one is asked for. */
  @property() viewed = "";
  @state() private withView = false;
  @state() private copied = false;
  @query("input.field") private readonly field!: HTMLInputElement;

  override render() {
    return html`<pasu-dialog heading=${link.heading} @dialog-closed=${() => this.dispatchEvent(new Event("link-closed"))}>
      <p>${this.viewed === "" ? link.lead : link.leadView}</p>
      <input
        class="field"
        aria-label=${link.link}
        readonly
        .value=${this.withView ? this.viewed : this.address}
        @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
      />
      ${this.viewed === "" ? nothing : this.choice()}
    </pasu-dialog>`;
  }

  private choice() {
    return html`<label class="check">
        <input
          type="checkbox"
          .checked=${this.withView}
          @change=${(event: Event) => {
            this.withView = (event.target as HTMLInputElement).checked;
            this.copied = false;
          }}
        />
        <span>${link.withView}</span>
      </label>
      <p class="copied" role="status">${this.copied ? link.copied : nothing}</p>
      <button slot="actions" class="button primary" type="button" @click=${this.copy}>${link.copy}</button>`;
  }

  private readonly copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(this.field.value);
      this.copied = true;
      this.dispatchEvent(new Event("link-copied"));
    } catch {
      // By hand, then.
      this.field.select();
    }
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    checks,
    css`
      .check {
        margin-top: 6px;
      }
      .copied {
        min-height: 1.5em;
        color: var(--soft);
      }
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
