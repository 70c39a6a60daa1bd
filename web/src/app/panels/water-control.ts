/** How high the water stands: poured in and out, moved by a slider, its volume beside it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { DesignerElement } from "../../element/designer-element";
import { fillAfter } from "../../element/water-keys";
import { toggleOverlay } from "../../state/actions";
import { setFill, setWater } from "../../state/wall-actions";
import { base, buttons } from "../../ui/styles";
import { localVolumeWords } from "../../words/customary";
import { page } from "../../words/english/page";
import { water as words } from "../../words/english/water";
import { lengthWords } from "../../words/quantities";
import { refusalWords } from "../../words/refusals";

@customElement("pasu-water")
export class PasuWater extends DesignerElement {
  override render() {
    const { designer } = this;
    const { session, design } = designer.state;
    const range = designer.made?.waterRange;
    const measures = designer.made?.measures.value;
    if (!measures) return nothing;
    const { fill } = session;
    const unit = unitOf(design);
    return html`<section aria-labelledby="water">
      <div class="bar">
        <h3 id="water">${words.heading}</h3>
        ${
          range
            ? html`<button
                class="button outlined"
                type="button"
                aria-pressed=${fill === null ? "false" : "true"}
                @click=${() => designer.apply(setWater(designer.state, fill === null))}
              >
                ${fill === null ? words.fill : words.pour}
              </button>`
            : nothing
        }
      </div>
      ${
        range && fill !== null
          ? html`<input
                type="range"
                aria-label=${words.level}
                min="0"
                max="1"
                step="any"
                .value=${String(fill)}
                aria-valuetext=${this.words()}
                @input=${(event: Event) => designer.apply(setFill(designer.state, Number((event.target as HTMLInputElement).value)))}
                @keydown=${this.key}
              />
              <p class="volume" data-volume>${this.words()}</p>
              <p class="hint">
                ${words.sentences([
                  words.deep(lengthWords(fill * (range.high - range.low), unit, 3)),
                  fill < 1 ? words.toBrim(localVolumeWords(measures.capacity?.brim.value ?? 0, unit, 3)) : words.isBrim,
                ])}
              </p>
              <label>
                <input
                  type="checkbox"
                  .checked=${session.overlays.cut}
                  @change=${() => designer.apply(toggleOverlay(designer.state, "cut"))}
                />
                <span>${words.cut}</span>
              </label>`
          : html`<p class="hint">${designer.made?.holds ?? page.checking}</p>`
      }
    </section>`;
  }

  private words(): string {
    const { made } = this.designer;
    const water = made?.water;
    if (water?.problem) return refusalWords(water.problem, this.designer.state.design);
    const volume = water?.value?.volume ?? null;
    return volume !== null && water?.of && made?.isOfNow(water)
      ? localVolumeWords(volume, unitOf(water.of), 4)
      : words.coming;
  }

  /** The browser's own steps of a slider without steps differ from one to the next. */
  private readonly key = (event: KeyboardEvent): void => {
    const { designer } = this;
    const fill = fillAfter(event, designer.store.session.fill);
    if (fill === null) return;
    event.preventDefault();
    designer.apply(setFill(designer.state, fill));
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      .bar {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      h3 {
        font-size: 1rem;
        font-weight: 650;
      }
      label {
        display: flex;
        align-items: center;
        gap: 10px;
        min-height: var(--touch);
        width: fit-content;
        cursor: pointer;
      }
      [type="checkbox"] {
        width: 18px;
        height: 18px;
        margin: 0;
        accent-color: var(--accent);
      }
      [type="range"] {
        width: 100%;
        height: 34px;
        margin: 0;
        accent-color: var(--accent);
        touch-action: pan-y;
      }
      .volume {
        font-size: 1.25rem;
        font-variant-numeric: tabular-nums;
      }
      .hint {
        color: var(--soft);
        font-size: 0.92rem;
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-water": PasuWater;
  }
}
