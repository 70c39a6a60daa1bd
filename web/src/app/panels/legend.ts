/** The colours of a map with the numbers that they stand for. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { type ColourMap, scaleOf } from "../../document/maps";
import type { Unit } from "../../document/types";
import type { Lined, Painted } from "../../maker/messages";
import { colourRamp, rampLegend, rampStyles } from "../../ui/ramp";
import { base } from "../../ui/styles";
import { maps } from "../../words/english/maps";
import { mapNote, mapWords } from "../../words/maps";

@customElement("pasu-legend")
export class PasuLegend extends LitElement {
  @property({ attribute: false }) map!: ColourMap;
  @property({ attribute: false }) painted: Painted | null = null;
  /** What is known of the inside; null where the map has nothing of its own there, or not yet. */
  @property({ attribute: false }) lined: Lined | null = null;
  @property() unit: Unit = "cm";

  override render() {
    const { map, painted, unit } = this;
    if (!painted) return html`<p class="note">${mapNote(map.name)}</p>`;
    const scale = scaleOf(map, painted.low, painted.high);
    const { low, high } = scale;
    const words = (value: number) => mapWords(map.name, value, unit);
    const on = map.name === "overhang" || this.lined ? maps.onOutside : maps.onPot;
    const [below, above] = [words(painted.least) !== words(low), words(painted.greatest) !== words(high)];
    return html`
      ${rampLegend(maps.colours(maps.names[map.name], words(low), words(high)), [
        `${painted.least < low && below ? "≤ " : ""}${words(low)}`,
        words((low + high) / 2),
        `${painted.greatest > high && above ? "≥ " : ""}${words(high)}`,
      ])}
      <p class="note">${on(mapNote(map.name, scale), words(painted.least), words(painted.greatest))} ${this.within(words)}</p>
    `;
  }

  private within(words: (value: number) => string) {
    if (!this.lined) return nothing;
    const { range } = this.lined;
    if (!range) return maps.notInside;
    const numbers =
      this.map.name === "thickness" ? maps.insideSame : maps.inside(words(range.least), words(range.greatest));
    return html`${numbers} ${maps.insideSeen}`;
  }

  override updated(): void {
    const { map, painted } = this;
    const { ramp } = painted ? scaleOf(map, painted.low, painted.high) : map;
    colourRamp(this, ramp);
  }

  static override readonly styles = [
    base,
    rampStyles,
    css`
      :host {
        display: block;
      }
      .note {
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-legend": PasuLegend;
  }
}
