/** That a file is being opened, which may take long, and how to stop that. Fetched with the first file that is not small. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { DesignerElement } from "../element/designer-element";
import { isolated } from "../language";
import { formatNumber } from "../number";
import { base, buttons } from "../ui/styles";
import { wheel } from "../ui/wheel";
import { opening as words } from "../words/english/opening";

@customElement("pasu-opening-note")
export class PasuOpeningNote extends DesignerElement {
  /** Comes after the place where it is said, or nobody would hear it. */
  @state() private spoken = "";

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.escape, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.escape, { capture: true });
    this.spoken = "";
  }

  override render() {
    const { underway } = this.designer.opening;
    return html`
      <p class="spoken" role="status">${this.spoken}</p>
      ${
        underway === null
          ? nothing
          : html`<div class="note">
              <span class="wheel" aria-hidden="true"></span>
              <p aria-hidden="true">${this.said}<small>${words.stays}</small></p>
              <button class="button outlined" type="button" @click=${this.stop}>${words.stop}</button>
            </div>`
      }
    `;
  }

  override updated(): void {
    this.spoken = this.said;
  }

  private get said(): string {
    const { underway } = this.designer.opening;
    return underway ? words.opening(isolated(underway.name), formatNumber(underway.bytes / 1e6, 2)) : "";
  }

  private readonly stop = (): void => {
    const { opening, notices } = this.designer;
    const { underway } = opening;
    opening.stop();
    if (underway) notices.say(words.stopped(isolated(underway.name)));
  };

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || event.defaultPrevented || !this.designer.opening.underway) return;
    event.preventDefault();
    event.stopPropagation();
    this.stop();
  };

  static override readonly styles = [
    base,
    buttons,
    wheel,
    css`
      :host {
        display: contents;
      }
      .note {
        display: flex;
        align-items: center;
        gap: 12px;
        padding: 9px 14px;
        border: 1px solid var(--line);
        border-radius: 10px;
        background: var(--sheet);
        box-shadow: 0 8px 26px var(--shadow);
        pointer-events: auto;
      }
      .note p {
        flex: 1;
        min-width: 0;
        margin: 0;
        overflow-wrap: anywhere;
      }
      small {
        display: block;
        color: var(--soft);
      }
      .note .wheel {
        --wheel: 22px;
        position: static;
        flex: none;
        margin: 0;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-opening-note": PasuOpeningNote;
  }
}
