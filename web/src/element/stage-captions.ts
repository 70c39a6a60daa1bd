/** What stands left and right while two orders are compared. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { OrderKind } from "../document/types";
import { base } from "../ui/styles";
import { page } from "../words/english/page";
import { parameters } from "../words/english/parameters";
import { DesignerElement } from "./designer-element";

@customElement("pasu-captions")
export class PasuCaptions extends DesignerElement {
  @property() order: OrderKind = "second-order";

  override render() {
    const { design, part } = this.designer.state;
    const kind = design.parts[part]?.shape.kind ?? "second-order";
    return html`
      <p>${parameters.kinds[kind]} <span>${page.asItIs}</span></p>
      <p>${parameters.kinds[this.order]} <span>${page.toCompare}</span></p>
    `;
  }

  static override readonly styles = [
    base,
    css`
      :host {
        position: absolute;
        z-index: 2;
        inset: 14px 0 auto;
        display: grid;
        grid-template-columns: 1fr 1fr;
        pointer-events: none;
      }
      p {
        justify-self: center;
        padding: 5px 12px;
        border-radius: 9px;
        background: var(--sheet);
        border: 1px solid var(--line);
        font-weight: 550;
      }
      span {
        color: var(--soft);
        font-weight: 400;
      }
      @media (max-width: 53.6875em) {
        :host {
          inset: 6px 0 auto;
          font-size: 0.8rem;
        }
        p {
          padding: 1px 9px;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-captions": PasuCaptions;
  }
}
