/** The handle by which the water on the stage is moved up and down: by the pointer, and by keys as a slider. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../document/look";
import type { Hold } from "../render/made/made";
import { setFill } from "../state/wall-actions";
import { base } from "../ui/styles";
import { localVolumeWords } from "../words/customary";
import { page } from "../words/english/page";
import { DesignerElement } from "./designer-element";
import { fillAfter } from "./water-keys";

@customElement("pasu-water-handle")
export class PasuWaterHandle extends DesignerElement {
  private held: Hold | null = null;
  /** Where the drag began: on the screen, and how full the pot was. */
  private from: { readonly y: number; readonly fill: number; readonly perFill: number } | null = null;

  /** Moves it to where the water is; away at null. */
  hold(hold: Hold | null): void {
    this.held = hold;
    // With every frame: what is away already is not touched.
    if (this.hidden !== (hold === null)) this.hidden = hold === null;
    if (hold) this.style.setProperty("transform", `translate(${hold.x.toFixed(1)}px, ${hold.y.toFixed(1)}px)`);
  }

  override render() {
    const { fill } = this.designer.store.session;
    const words = this.words();
    return html`<div
        role="slider"
        tabindex="0"
        aria-label=${page.waterOnStage}
        aria-orientation="vertical"
        aria-valuemin="0"
        aria-valuemax="100"
        aria-valuenow=${Math.round(100 * (fill ?? 0))}
        aria-valuetext=${words}
        @keydown=${this.key}
        @pointerdown=${this.down}
        @pointermove=${this.move}
        @pointerup=${this.up}
        @pointercancel=${this.up}
      ></div>
      <span aria-hidden="true">${words}</span>`;
  }

  private words(): string {
    const water = this.designer.made?.water;
    const volume = water?.value?.volume ?? null;
    return volume !== null && water?.of ? localVolumeWords(volume, unitOf(water.of), 3) : "";
  }

  private readonly key = (event: KeyboardEvent): void => {
    const { designer } = this;
    const fill = fillAfter(event, designer.store.session.fill);
    if (fill === null) return;
    event.preventDefault();
    event.stopPropagation();
    designer.apply(setFill(designer.state, fill));
  };

  private readonly down = (event: PointerEvent): void => {
    const range = this.designer.made?.waterRange;
    const fill = this.designer.store.session.fill;
    if (!range || !this.held || fill === null || event.button !== 0) return;
    event.preventDefault();
    const target = event.currentTarget as HTMLElement;
    target.setPointerCapture(event.pointerId);
    target.focus();
    this.from = { y: event.clientY, fill, perFill: this.held.perUnit * (range.high - range.low) };
  };

  private readonly move = (event: PointerEvent): void => {
    if (!this.from) return;
    const { y, fill, perFill } = this.from;
    const { designer } = this;
    designer.apply(setFill(designer.state, fill + (y - event.clientY) / perFill));
  };

  private readonly up = (): void => {
    this.from = null;
  };

  static override readonly styles = [
    base,
    css`
      :host {
        position: absolute;
        z-index: 3;
        top: 0;
        left: 0;
        width: 0;
        height: 0;
      }
      :host([hidden]) {
        display: none;
      }
      div {
        position: absolute;
        inset: -22px;
        width: 44px;
        height: 44px;
        border-radius: 50%;
        cursor: ns-resize;
        touch-action: none;
      }
      div::before {
        content: "";
        position: absolute;
        inset: 9px;
        border: 2.5px solid var(--sheet);
        border-radius: 50% 50% 50% 8%;
        rotate: 45deg;
        background: #2f7fa8;
        box-shadow: 0 1px 5px var(--shadow);
      }
      div:focus-visible {
        outline-offset: -4px;
      }
      span {
        position: absolute;
        left: 24px;
        top: 0;
        translate: 0 -50%;
        padding: 2px 8px;
        border-radius: 9px;
        background: var(--sheet);
        font-size: 0.86rem;
        font-weight: 600;
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
        pointer-events: none;
      }
      span:empty {
        display: none;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-water-handle": PasuWaterHandle;
  }
}
