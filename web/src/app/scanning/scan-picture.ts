/**
 * A scan from the side, its widest place at the right to begin with, and the rings at their mean. Once these are found the scan is coloured by how far it is from them; until then, darker is what is within
 * the least radius of every level.
 */

import { css, html, LitElement, nothing, type PropertyValues, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { colourAt, DIVERGING } from "../../document/maps";
import type { Hoop } from "../../document/ring-numbers";
import { directionsOf, frontOf, piecesSeen, seenAt, widestOf } from "../../document/scanned/seen";
import type { Levels, Unit } from "../../document/types";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { colourRamp, rampLegend, rampStyles } from "../../ui/ramp";
import { base } from "../../ui/styles";
import { rings as ringWords } from "../../words/english/rings";
import { scan as words } from "../../words/english/scan";
import { spokenLength } from "../../words/quantities";

/** Rings that were found for a scan, and how far it is from them. */
export interface Fitted {
  readonly rings: readonly Hoop[];
  readonly away: Float32Array;
  /** How many times as large as the scan they are. */
  readonly times: number;
  /** What the ends of the colours stand for, to either side of 0. */
  readonly most: number;
  /** How far off anything is. */
  readonly greatest: number;
}

const SIZE = 320;
const MARGIN = 24;
/** Pixels of the colours to a unit of the picture. */
const FINE = 2;
const DIGITS = 2;

@customElement("pasu-scan-picture")
export class PasuScanPicture extends LitElement {
  @property({ attribute: false }) levels!: Levels;
  @property({ attribute: false }) fitted: Fitted | null = null;
  @property() unit: Unit = "cm";
  /** By how much it is turned, in degrees. */
  @state() private turn = 0;
  @query("canvas") private readonly canvas!: HTMLCanvasElement | null;

  /** How far out the scan reaches and in which direction, which every point of the picture asks for. */
  private widest = 0;
  private front = 0;

  override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has("levels")) return;
    this.widest = widestOf(this.levels);
    this.front = frontOf(this.levels);
  }

  override render() {
    const { levels, fitted } = this;
    const spot = (radius: number, height: number) => this.spot(radius, height).join(" ");
    const around = (of: (section: Float64Array, side: 1 | -1) => number) => {
      const side = (way: 1 | -1) =>
        Array.from(levels.heights, (height, i) => spot(way * of(levels.radii[i] as Float64Array, way), height));
      return `M${side(1).join("L")}L${side(-1).reverse().join("L")}Z`;
    };
    const { right } = this;
    const whole = around((section, side) => seenAt(section, right + (side === 1 ? 0 : directionsOf(levels) / 2)));
    const core = around((section) => section.reduce((a, b) => Math.min(a, b)));
    return html`<div class="sheet">
        ${fitted ? html`<canvas width=${FINE * SIZE} height=${FINE * SIZE}></canvas>` : nothing}
        <svg viewBox="0 0 ${SIZE} ${SIZE}" role="img" aria-label=${fitted ? words.pictureOff : words.picture}>
          <path class=${fitted ? "outline" : "whole"} d=${whole} />
          ${fitted ? nothing : svg`<path class="core" d=${core} />`}
          ${fitted ? this.hoops(fitted).map((line) => svg`<path class="hoop" d=${line} />`) : nothing}
        </svg>
      </div>
      ${fitted ? this.legend(fitted) : nothing}
      <pasu-number
        .label=${words.turn}
        .unit=${ringWords.degree}
        .value=${this.turn}
        .min=${0}
        .max=${360}
        .step=${5}
        @number-change=${({ value }: NumberChangeEvent) => {
          this.turn = ((value % 360) + 360) % 360;
        }}
      ></pasu-number>`;
  }

  private hoops({ rings, times }: Fitted): readonly string[] {
    return rings.map(({ r, z }) => {
      const [radius, height] = [r.mean / times, z.mean / times];
      return `M${this.spot(-radius, height).join(" ")}L${this.spot(radius, height).join(" ")}`;
    });
  }

  private legend({ most, greatest }: Fitted) {
    const length = spokenLength(most, this.unit, DIGITS);
    const [inside, outside] = [words.inside(length), words.outside(length)];
    const beyond = greatest > most ? "≥ " : "";
    return html`<div class="legend">
      ${rampLegend(words.colours(length, length), [inside, "0", `${beyond}${outside}`])}
      <p class="about">${words.coloursAbout}</p>
    </div>`;
  }

  override updated(changed: PropertyValues): void {
    if (changed.has("fitted")) colourRamp(this, DIVERGING);
    this.paint();
  }

  private paint(): void {
    const { canvas, fitted, levels, right } = this;
    const context = canvas?.getContext("2d");
    if (!context || !fitted) return;
    context.setTransform(FINE, 0, 0, FINE, 0, 0);
    context.clearRect(0, 0, SIZE, SIZE);
    context.lineWidth = 0.6;
    for (const { corners, away } of piecesSeen(levels, fitted.away, right)) {
      const colour = `rgb(${colourAt(DIVERGING, 0.5 + away / (2 * fitted.most)).join(" ")})`;
      context.fillStyle = colour;
      // What lies between two pieces is neither's.
      context.strokeStyle = colour;
      context.beginPath();
      for (const [across, up] of corners) context.lineTo(...this.spot(across, up));
      context.closePath();
      context.fill();
      context.stroke();
    }
  }

  /** The direction that is seen at the right. */
  private get right(): number {
    return this.front + (this.turn * directionsOf(this.levels)) / 360;
  }

  private spot(across: number, up: number): [number, number] {
    const { height } = this.levels;
    const scale = (SIZE - 2 * MARGIN) / Math.max(height, 2 * this.widest);
    const rounded = (value: number) => Math.round(10 * value) / 10;
    return [rounded(SIZE / 2 + scale * across), rounded(SIZE / 2 + scale * (height / 2 - up))];
  }

  static override readonly styles = [
    base,
    rampStyles,
    css`
      :host {
        display: block;
        margin: 12px 0 8px;
      }
      .sheet {
        position: relative;
        width: min(100%, max(12rem, 86dvh - 28rem));
        aspect-ratio: 1;
        margin: 0 auto;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--paper);
        overflow: hidden;
      }
      canvas,
      svg {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      .whole,
      .outline {
        fill: var(--accent-wash);
        stroke: var(--accent);
        stroke-width: 1;
      }
      .outline {
        fill: none;
        stroke: var(--soft);
      }
      .core {
        fill: var(--accent);
        opacity: 0.35;
      }
      .hoop {
        fill: none;
        stroke: #1c1b19;
        stroke-width: 1.2;
        opacity: 0.65;
      }
      .legend {
        padding: 10px 0 4px;
      }
      .about {
        padding-top: 2px;
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-scan-picture": PasuScanPicture;
  }
}
