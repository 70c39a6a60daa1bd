/** A modal dialogue with a heading and a close button, on the browser's own `<dialog>`: focus kept, Escape closes. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { controls } from "../words/english/controls";
import { icon } from "./icons";
import { base, buttons } from "./styles";

@customElement("pasu-dialog")
export class PasuDialog extends LitElement {
  @property() heading = "";
  /** As wide as the page allows, for the gallery. */
  @property({ type: Boolean, reflect: true }) wide = false;
  /** All text and nothing to press: the text itself takes the focus, so that keys can scroll it. */
  @property({ type: Boolean }) reading = false;
  /** A line above the actions, for a dialogue that usually scrolls. */
  @property({ type: Boolean, reflect: true }) ruled = false;
  @query("dialog") private readonly dialog!: HTMLDialogElement;

  private opener: Element | null = null;

  override firstUpdated(): void {
    this.opener = focused();
    this.dialog.showModal();
  }

  /** A dialogue that was moved stays open. */
  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.dialog.showModal();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dialog.close();
    // A dialogue that a choice inside it took off the page leaves the focus nowhere.
    if (focused() === document.body && this.opener instanceof HTMLElement) this.opener.focus();
  }

  override render() {
    return html`
      <dialog aria-labelledby="heading" @close=${this.closed} @click=${this.clicked}>
        <div class="head">
          <h2 id="heading">${this.heading}</h2>
          <button class="button bare" type="button" aria-label=${controls.close} @click=${this.close}>${icon("close")}</button>
        </div>
        <div class="body" tabindex=${this.reading ? 0 : nothing}><slot></slot></div>
        <footer><slot name="actions"></slot></footer>
      </dialog>
    `;
  }

  readonly close = (): void => {
    this.dialog.close();
  };

  private readonly closed = (): void => {
    if (this.isConnected && !this.dialog.open) this.dispatchEvent(new Event("dialog-closed"));
  };

  /** A press on the veil. */
  private readonly clicked = (event: MouseEvent): void => {
    if (event.target === this.dialog) this.close();
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      dialog {
        width: min(32.5rem, 100vw - 24px);
        max-height: min(86dvh, 900px);
        padding: 0;
        border: 1px solid var(--line);
        border-radius: 16px;
        background: var(--sheet);
        color: var(--ink);
        box-shadow: 0 24px 80px var(--shadow);
        overflow: hidden;
      }
      :host([wide]) dialog {
        width: min(70rem, 100vw - 24px);
      }
      dialog[open] {
        display: grid;
        grid-template-rows: auto 1fr auto;
      }
      dialog::backdrop {
        background: var(--veil);
      }
      .head {
        display: flex;
        align-items: center;
        justify-content: space-between;
        gap: 12px;
        padding: 14px 14px 10px 22px;
      }
      h2 {
        font: 600 1.22rem var(--font-brand);
      }
      .body {
        /* What is for ears alone scrolls along, and does not make the dialog itself longer than it is. */
        position: relative;
        overflow: auto;
        padding: 2px 22px 18px;
        overscroll-behavior: contain;
      }
      footer {
        display: flex;
        flex-wrap: wrap;
        justify-content: flex-end;
        gap: 8px;
        padding: 0 22px;
      }
      :host([ruled]) footer {
        align-items: center;
        padding-top: 14px;
        border-top: 1px solid var(--line);
      }
      ::slotted([slot="actions"]) {
        /* Whatever the page says of margins: all of them stand on one line. */
        margin-bottom: 18px !important;
      }
    `,
  ];
}

/** The element with the focus, however deep in shadow trees. */
function focused(): Element | null {
  let active = document.activeElement;
  while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
  return active;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-dialog": PasuDialog;
  }
}
