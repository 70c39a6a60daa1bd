/** How large the finished pot is, in which unit: each number is typed and the pot takes that size. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Walls } from "../../document/scaled";
import type { Measures, Unit } from "../../document/types";
import { millilitres } from "../../document/volume";
import { parseVolume } from "../../document/volume-units";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber, parseLength } from "../../number";
import { resize, setUnit } from "../../state/scale-actions";
import { checks } from "../../ui/checks";
import { base, fields } from "../../ui/styles";
import { customaryWords } from "../../words/customary";
import { quantities } from "../../words/english/quantities";
import { size as words } from "../../words/english/size";
import { lengthWords } from "../../words/quantities";
import { numberProblemWords } from "../../words/typed";
import { factorFor, type Sized, sizeOf } from "../../work/sizing";

/** Digits as in the caption and among the measures; and of what was typed here. */
const DIGITS: Readonly<Record<Sized, number>> = { height: 3, width: 3, capacity: 4 };
const TYPED_DIGITS = 7;

/** A size this near to what was typed, as a share of it, is that. */
const SAME = 1e-6;

/** The panel asks for itself, whatever is asked meanwhile. */
const TRIAL = "size trial";

@customElement("pasu-size")
export class PasuSize extends DesignerElement {
  @state() private walls: Walls = "scale";
  @state() private problem: { readonly of: Sized; readonly text: string } | null = null;
  @state() private trying = false;
  /** What was typed here, in model units. */
  private readonly typed = new Map<Sized, number>();

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.designer.made?.maker.cancel(TRIAL);
  }

  override render() {
    const { designer } = this;
    const { design } = designer.state;
    const { made } = designer;
    // While it is measured a field keeps the focus that it has.
    const waits = made !== null && !made.isOfNow(made.measures);
    const measures = waits ? null : (made?.measures.value ?? null);
    const wall = design.parts.find((part) => part.wall)?.wall;
    const unit = unitOf(design);
    return html`<section aria-labelledby="size">
      <div class="bar">
        <h3 id="size">${words.heading}</h3>
        <select
          class="field"
          aria-label=${words.unit}
          @change=${(event: Event) =>
            designer.apply(setUnit(designer.state, (event.target as HTMLSelectElement).value as Unit))}
        >
          ${Object.entries(words.units).map(
            ([name, label]) => html`<option value=${name} .selected=${unit === name}>${label}</option>`,
          )}
        </select>
      </div>
      <div class="sizes">
        ${(["height", "width", "capacity"] as const).map((sized) => this.field(sized, measures, waits))}
      </div>
      ${this.problem ? html`<p id="problem" class="problem" role="alert">${this.problem.text}</p>` : nothing}
      ${
        wall
          ? html`<label class="check">
              <input
                type="checkbox"
                .checked=${this.walls === "scale"}
                @change=${(event: Event) => {
                  this.walls = (event.target as HTMLInputElement).checked ? "scale" : "stay";
                }}
              /><span>${words.wallScales}</span>
              <span class="hint">${this.walls === "stay" ? words.wallStays(lengthWords(wall.thickness, unit, 3)) : ""}</span>
            </label>`
          : nothing
      }
    </section>`;
  }

  private field(sized: Sized, measures: Measures | null, waits: boolean) {
    const unit = unitOf(this.designer.state.design);
    const size = measures && sizeOf(measures, sized);
    const volume = sized === "capacity" && size !== null ? millilitres(size, unit) : null;
    const litres = volume !== null && volume >= 999.5;
    const shown = volume === null ? size : litres ? volume / 1000 : volume;
    const text = shown === null ? "" : formatNumber(shown, this.digits(sized, size));
    const wrong = this.problem?.of === sized;
    return html`<label>
      <span>${words.names[sized]}</span>
      <span class="typed"
        ><input
          class="field"
          type="text"
          autocomplete="off"
          spellcheck="false"
          .value=${text}
          ?disabled=${shown === null && !waits}
          ?readonly=${waits || this.trying}
          aria-invalid=${wrong ? "true" : "false"}
          aria-describedby=${wrong ? "problem" : nothing}
          @change=${(event: Event) => void this.take(sized, event.target as HTMLInputElement, text, litres ? "l" : "ml")}
        /><span class="unit" aria-hidden="true">${sized === "capacity" ? (litres ? quantities.litres : quantities.millilitres) : quantities.units[unit]}</span></span
      >
      ${volume !== null && unit === "in" ? html`<span class="hint">${customaryWords(volume)}</span>` : nothing}
    </label>`;
  }

  /** A size that was typed is shown as it was typed. */
  private digits(sized: Sized, size: number | null): number {
    const typed = this.typed.get(sized) ?? Number.NaN;
    return size !== null && Math.abs(size - typed) <= SAME * typed ? TYPED_DIGITS : DIGITS[sized];
  }

  private async take(sized: Sized, input: HTMLInputElement, before: string, volume: "l" | "ml"): Promise<void> {
    const { designer, walls } = this;
    const { design } = designer.state;
    const unit = unitOf(design);
    const { made } = designer;
    const measures = made?.measures.value;
    if (input.value === before || !made || !measures || !made.isOfNow(made.measures)) return;
    const typed = sized === "capacity" ? parseVolume(input.value, volume) : parseLength(input.value, unit);
    const size = "problem" in typed ? 0 : sized === "capacity" ? typed.value / millilitres(1, unit) : typed.value;
    if (!(size > 0)) {
      this.problem = { of: sized, text: "problem" in typed ? numberProblemWords(typed.problem) : words.positive };
      return;
    }
    this.problem = null;
    this.trying = true;
    const factor = await factorFor(design, measures, { sized, size, walls }, async (trial) => {
      const outcome = await made.maker.ask({ kind: "measure", design: trial, product: "pot", fill: null }, TRIAL);
      return outcome.state === "done" ? outcome.value : null;
    });
    this.trying = false;
    input.value = before;
    if (design !== designer.state.design) return;
    if (factor === null) {
      this.problem = { of: sized, text: words.tooSmall };
      return;
    }
    this.typed.set(sized, size);
    designer.apply(resize(designer.state, factor, walls));
  }

  static override readonly styles = [
    base,
    fields,
    checks,
    css`
      section {
        display: grid;
        gap: 9px;
      }
      .bar {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      h3 {
        font-size: 1rem;
        font-weight: 650;
      }
      .sizes {
        display: grid;
        grid-template-columns: repeat(auto-fit, minmax(5.5rem, 1fr));
        gap: 9px;
      }
      .sizes label {
        display: grid;
        gap: 3px;
        align-content: start;
      }
      .typed {
        position: relative;
      }
      .typed .field {
        width: 100%;
        padding-right: 32px;
        font-variant-numeric: tabular-nums;
      }
      .unit {
        position: absolute;
        right: 9px;
        top: 50%;
        translate: 0 -50%;
        color: var(--soft);
        font-size: 0.86em;
        pointer-events: none;
      }
      .hint {
        color: var(--soft);
        font-size: 0.86rem;
      }
      .problem {
        color: var(--warn);
        font-size: 0.92rem;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-size": PasuSize;
  }
}
