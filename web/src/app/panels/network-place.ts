/** Where the middle of what is picked of a network is, to be typed; it alone of the panel is drawn again while a hand moves points. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { middleOf, moved, shiftExactly, unlessStill } from "../../document/network/moving";
import { type Network, sizeOf } from "../../document/network/network";
import type { Triple } from "../../document/types";
import { UnhurriedElement } from "../../element/unhurried";
import { changeNetwork } from "../../state/network-actions";
import { cells } from "../../ui/cells";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, fields } from "../../ui/styles";
import { networks as words } from "../../words/english/networks";
import { networkDesk, networkOf } from "../../work/network-desk";

/** What is typed is read back as it was typed. */
const DIGITS = 6;
/** Of what keys step by: a middle that is no further from 0 is there but for rounding. */
const NOISE = 1e-7;

@customElement("pasu-network-place")
export class PasuNetworkPlace extends UnhurriedElement {
  private step: number | null = null;
  /** The network before a number was typed: on its way to where it is meant a point may stand in the mirror, or where another one is. */
  private from: Network | null = null;

  override render() {
    const network = networkOf(this.designer);
    const vertices = network && networkDesk(this.designer).picksOf(network).vertices;
    if (!network || !vertices || vertices.size === 0) return nothing;
    const unit = unitOf(this.designer.store.design);
    // What keys step by is nothing that a hand on the stage looks for: of thousands of points the size is found again once it rests.
    if (this.step === null || !this.designer.store.inGesture)
      this.step = Number((sizeOf(network) / 100).toPrecision(1));
    const least = NOISE * this.step;
    return html`<div class="three">
      ${middleOf(network, vertices).map(
        (value, axis) => html`<span class="cell" title=${words.placeHelp}
          ><span aria-hidden="true">${words.place[axis] ?? ""}</span
          ><pasu-number
            compact
            .label=${words.place[axis] ?? ""}
            .unit=${unit}
            .value=${Math.abs(value) < least ? 0 : Number(value.toPrecision(DIGITS))}
            .step=${this.step}
            @number-change=${(event: NumberChangeEvent) => this.place(axis, event.value, event.gesture)}
            @number-done=${() => this.designer.store.endGesture()}
            @number-cancel=${() => this.designer.store.cancelGesture()}
          ></pasu-number
        ></span>`,
      )}
    </div>`;
  }

  private place(axis: number, value: number, gesture: boolean): void {
    const { designer } = this;
    const network = networkOf(designer);
    if (!network) return;
    const { store } = designer;
    if (!gesture || !store.inGesture || this.from?.patches !== network.patches) this.from = network;
    const from = this.from ?? network;
    const desk = networkDesk(designer);
    const { vertices } = desk.picksOf(network);
    const before = middleOf(from, vertices)[axis] ?? 0;
    const by = value - before;
    const way = [0, 1, 2].map((each) => (each === axis ? by : 0)) as unknown as Triple;
    const next = moved(from, vertices, shiftExactly(way), desk.settings.mirror);
    if (next === from && by !== 0) designer.notices.say(words.objections.collapsed);
    else if (by !== 0 && middleOf(next, vertices)[axis] === before) designer.notices.say(words.inMirror);
    designer.apply(
      changeNetwork(designer.state, () => unlessStill(next, network), gesture ? `place ${axis}` : undefined),
    );
  }

  static override readonly styles = [
    base,
    fields,
    cells,
    css`
      :host {
        display: block;
      }
      .three {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
        padding-top: 10px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-network-place": PasuNetworkPlace;
  }
}
