/** Choosing what a new design begins as, by its picture. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { BEGINNINGS, beginningOf } from "../../document/beginnings";
import type { Exhibit } from "../../document/gallery/exhibit";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { base } from "../../ui/styles";
import { beginnings } from "../../words/english/beginnings";
import { exhibitIn, Pictures, tileStyles, tiles } from "./pictures";

@customElement("pasu-new")
export class PasuNew extends DesignerElement {
  private pictures: Pictures | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.pictures?.end();
    this.pictures = null;
  }

  override render() {
    return html`<pasu-dialog wide heading=${beginnings.heading} @dialog-closed=${this.close}>
      <p>${beginnings.lead}</p>
      ${tiles(
        BEGINNINGS,
        (id) => beginnings.forms[id],
        (beginning) => this.choose(beginning),
      )}
    </pasu-dialog>`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.watchPictures();
  }

  override firstUpdated(): void {
    this.watchPictures();
  }

  private watchPictures(): void {
    if (this.pictures || !this.hasUpdated) return;
    this.pictures = new Pictures(this.designer, exhibitIn(BEGINNINGS));
    this.pictures.watch(this.renderRoot);
  }

  private choose(beginning: Exhibit): void {
    this.designer.opening.open(beginningOf(beginning));
    this.close();
  }

  private readonly close = (): void => {
    this.dispatchEvent(new Event("new-closed"));
  };

  static override readonly styles = [
    base,
    tileStyles,
    css`
      p {
        color: var(--soft);
        padding-bottom: 12px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-new": PasuNew;
  }
}
