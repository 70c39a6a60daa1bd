/** A scan from the side, with its widest place at the right; darker is what is within the least radius of every level. Rings are seen at their mean. */

import { css, html, LitElement, svg } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Hoop } from "../../document/ring-numbers";
import type { Levels } from "../../document/scanned/levels";
import { DIRECTIONS } from "../../document/scanned/section";
import { frontOf, seenAt, widestOf } from "../../document/scanned/seen";
import { base } from "../../ui/styles";
import { scan as words } from "../../words/english/scan";

const SIZE = 320;
const MARGIN = 24;

@customElement("pasu-scan-picture")
export class PasuScanPicture extends LitElement {
  @property({ attribute: false }) levels!: Levels;
  @property({ attribute: false }) rings: readonly Hoop[] = [];
  /** How many times as large as the scan the rings are. */
  @property({ type: Number }) times = 1;

  override render() {
    const { levels, rings, times } = this;
    const scale = (SIZE - 2 * MARGIN) / Math.max(levels.height, 2 * widestOf(levels));
    const foot = (SIZE + scale * levels.height) / 2;
    const spot = (radius: number, height: number) =>
      `${(SIZE / 2 + scale * radius).toFixed(1)} ${(foot - scale * height).toFixed(1)}`;
    const around = (of: (section: Float64Array, side: 1 | -1) => number) => {
      const side = (way: 1 | -1) =>
        levels.heights.map((height, i) => spot(way * of(levels.radii[i] as Float64Array, way), height));
      return `M${side(1).join("L")}L${side(-1).reverse().join("L")}Z`;
    };
    const front = frontOf(levels);
    const whole = around((section, side) => seenAt(section, front + (side === 1 ? 0 : DIRECTIONS / 2)));
    const core = around((section) => section.reduce((a, b) => Math.min(a, b)));
    return html`<svg viewBox="0 0 ${SIZE} ${SIZE}" role="img" aria-label=${words.picture}>
      <path class="whole" d=${whole} />
      <path class="core" d=${core} />
      ${rings.map(({ r, z }) => {
        const [radius, height] = [r.mean / times, z.mean / times];
        return svg`<path class="hoop" d="M${spot(-radius, height)}L${spot(radius, height)}" />`;
      })}
    </svg>`;
  }

  static override readonly styles = [
    base,
    css`
      :host {
        display: block;
        margin: 12px 0 8px;
      }
      svg {
        display: block;
        width: min(100%, max(12rem, 86dvh - 28rem));
        margin: 0 auto;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
      }
      .whole {
        fill: var(--accent-wash);
        stroke: var(--accent);
        stroke-width: 1;
      }
      .core {
        fill: var(--accent);
        opacity: 0.35;
      }
      .hoop {
        fill: none;
        stroke: var(--ink);
        stroke-width: 1.6;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-scan-picture": PasuScanPicture;
  }
}
