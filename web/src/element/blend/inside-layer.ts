/** Draws what is seen within a blend in the place of the blend, and asks for it anew when that or how one looks has changed. */

import { customElement, property } from "lit/decorators.js";
import { scaleOfInside } from "../../document/blend/inside-scale";
import { InsideSheets } from "../../render/inside/sheets";
import type { Stage } from "../../render/stage";
import type { PartId } from "../../state/part-ids";
import { insideDesk, type Seen } from "../../work/inside-desk";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";

@customElement("pasu-inside-layer")
export class PasuInsideLayer extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  /** The part that is looked into. */
  @property({ attribute: false }) within: PartId | null = null;
  private readonly lent = new Lent(
    this,
    (bench) => new InsideSheets(bench),
    () => {
      this.drawn = null;
    },
  );
  private drawn: Seen | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    insideDesk(this.designer).leave();
  }

  override updated(): void {
    const { designer, within } = this;
    const { tool: sheets } = this.lent;
    const desk = insideDesk(designer);
    const { seen } = desk;
    const place = within === null ? -1 : designer.store.ids.indexOf(within);
    void desk.follow(designer, place);
    if (!sheets || seen === this.drawn) return;
    this.drawn = seen;
    if (!seen) {
      sheets.show(null);
      return;
    }
    const { positions, values, indices } = seen.inside;
    const { ramp, low, high } = scaleOfInside(seen.look.map, seen.inside);
    sheets.show({ place, positions, values, indices, low, high, ramp });
  }
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-inside-layer": PasuInsideLayer;
  }
}
