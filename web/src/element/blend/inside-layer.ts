/** Draws what is seen within a blend in the place of the blend, and asks for it anew when that or how one looks has changed. */

import { customElement, property } from "lit/decorators.js";
import { scaleOfInside } from "../../document/blend/inside-scale";
import { InsideSheets } from "../../render/inside/sheets";
import type { Stage } from "../../render/stage";
import type { PartId } from "../../state/part-ids";
import { insideDesk, type Seen } from "../../work/inside-desk";
import { DesignerElement } from "../designer-element";

@customElement("pasu-inside-layer")
export class PasuInsideLayer extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  /** The part that is looked into. */
  @property({ attribute: false }) within: PartId | null = null;
  private sheets: InsideSheets | null = null;
  private giveBack: (() => void) | null = null;
  private drawn: Seen | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.leave();
    insideDesk(this.designer).leave();
  }

  private leave(): void {
    this.giveBack?.();
    this.giveBack = null;
    this.sheets = null;
    this.drawn = null;
  }

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("stage")) this.leave();
    if (!this.stage || this.sheets || !this.isConnected) return;
    const { tool, giveBack } = this.stage.lend((bench) => new InsideSheets(bench));
    this.sheets = tool;
    this.giveBack = giveBack;
  }

  override updated(): void {
    const { designer, sheets, within } = this;
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
