/** Glaze, clay and unit, and which part of the design is being edited. */

import { css, html, nothing, unsafeCSS } from "lit";
import { customElement, state } from "lit/decorators.js";
import { isSolid } from "../../document/closes";
import { type Looked, lookOf, unitOf } from "../../document/look";
import { isOwn, swatchOf } from "../../document/swatches";
import * as tables from "../../document/tables.gen";
import type { ClayChoice, ClayName, Colour, GlazeChoice, GlazeName, Unit } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { type LookChange, setLook } from "../../state/actions";
import { setUnit } from "../../state/scale-actions";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { radios } from "../../ui/radios";
import { base, fields } from "../../ui/styles";
import { look } from "../../words/english/look";
import { quantities } from "../../words/english/quantities";

/** The colours of the tables: nothing of a document. */
const SWATCHES = unsafeCSS(
  Object.entries({ ...tables.GLAZES, ...tables.CLAYS })
    .map(([name, colour]) => `.${name} { --colour: ${colour}; }`)
    .join("\n"),
);

/** What of a look is chosen by name or colour. */
type Chosen = "glaze" | "inside" | "clay";

@customElement("pasu-look")
export class PasuLook extends DesignerElement {
  /** Whether the glaze line was last typed where there is none. */
  @state() private lineIsWrong = false;

  override render() {
    const { designer } = this;
    const { design, part } = designer.state;
    const own = design.parts[part];
    const chosen = lookOf(own);
    const hasInside = own !== undefined && (own.wall !== undefined || !isSolid(own.shape));
    return html`
      ${this.swatches(look.glaze, "glaze", entries<GlazeName>(look.glazes), chosen.glaze, look.ownGlaze)}
      ${hasInside || own?.look?.inside !== undefined ? this.within(chosen, own?.look?.inside) : nothing}
      ${chosen.glaze === "bare" ? nothing : this.line(chosen)}
      ${this.swatches(look.clay, "clay", entries<ClayName>(look.clays), chosen.clay, look.ownClay)}
      <label class="unit">
        <span>${look.unit}</span>
        <select
          class="field"
          aria-label=${look.unitOfLength}
          @change=${(event: Event) =>
            designer.apply(setUnit(designer.state, (event.target as HTMLSelectElement).value as Unit))}
        >
          ${entries<Unit>(look.units).map(
            ([unit, label]) =>
              html`<option value=${unit} .selected=${unitOf(design) === unit}>${look.unitChoice(label, quantities.units[unit])}</option>`,
          )}
        </select>
      </label>
      <p class="hint">${look.staysAsLarge}</p>
    `;
  }

  /** Everything that has a name, and behind it a colour of one's own. */
  private swatches<N extends GlazeName | ClayName>(
    legend: string,
    of: Chosen,
    names: readonly (readonly [N, string])[],
    chosen: GlazeChoice | ClayChoice,
    label: string,
  ) {
    const own = isOwn(chosen);
    return html`<fieldset>
      <legend>${legend}</legend>
      <div class="swatches">
        ${names.map(
          ([name, text]) => html`<label class="radio swatch">
            <input type="radio" name=${of} .checked=${chosen === name} @change=${() => this.choose({ [of]: name })} />
            <span class="dot ${name}"></span><span>${text}</span>
          </label>`,
        )}
        <label class="radio swatch">
          <input
            type="radio"
            name=${of}
            .checked=${own}
            @change=${() => this.choose({ [of]: swatchOf(chosen) })}
          />
          ${own ? this.colour(of, chosen, label) : html`<span class="dot any"></span>`}<span>${look.own}</span>
        </label>
      </div>
    </fieldset>`;
  }

  /** What covers the inside: a few words, for it is mostly what covers the outside. */
  private within({ inside }: Looked, said: GlazeChoice | undefined) {
    const value = said === undefined ? "" : isOwn(said) ? "own" : said;
    const choices = [["", look.asOutside], ...entries<GlazeName>(look.glazes), ["own", look.own]] as const;
    return html`<div class="line">
      <label for="inside">${look.inside}</label>
      <span class="pair">
        ${said !== undefined && isOwn(said) ? this.colour("inside", said, look.ownInside) : nothing}
        <select
          id="inside"
          class="field"
          @change=${(event: Event) => {
            const { value: next } = event.target as HTMLSelectElement;
            const own = next === "own" ? swatchOf(inside) : next === "" ? undefined : (next as GlazeName);
            this.choose({ inside: own });
          }}
        >
          ${choices.map(([name, text]) => html`<option value=${name} .selected=${value === name}>${text}</option>`)}
        </select>
      </span>
    </div>`;
  }

  private colour(of: Chosen, value: Colour, label: string) {
    const { designer } = this;
    return html`<input
      type="color"
      class="own"
      aria-label=${label}
      .value=${value}
      @input=${(event: Event) =>
        this.choose({ [of]: (event.target as HTMLInputElement).value as Colour }, `look:${of}`)}
      @change=${() => designer.store.endGesture()}
    />`;
  }

  private line({ line }: Looked) {
    const { designer } = this;
    return html`<pasu-number
      class="part"
      .label=${look.line}
      .unit=${"%"}
      .help=${look.lineHelp}
      .value=${Number((100 * line).toPrecision(12))}
      .min=${0}
      .max=${100}
      .step=${1}
      .problem=${this.lineIsWrong ? look.lineProblem : ""}
      @number-change=${({ value, gesture }: NumberChangeEvent) => {
        this.lineIsWrong = !(value >= 0 && value <= 100);
        if (this.lineIsWrong) return;
        this.choose({ line: value === 0 ? undefined : value / 100 }, gesture ? "look:line" : undefined);
      }}
      @number-done=${() => designer.store.endGesture()}
      @number-cancel=${() => designer.store.cancelGesture()}
    ></pasu-number>`;
  }

  private choose(change: LookChange, key?: string): void {
    const { designer } = this;
    designer.apply(setLook(designer.state, change, key));
  }

  static override readonly styles = [
    base,
    fields,
    radios,
    css`
      :host {
        display: block;
      }
      fieldset {
        margin: 0 0 18px;
        padding: 0;
        border: 0;
      }
      legend {
        padding: 0 0 8px;
        font-weight: 650;
      }
      .swatches {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(min(9.375rem, 100%), 1fr));
        gap: 8px;
      }
      .swatch {
        display: flex;
        align-items: center;
        gap: 10px;
        min-height: 48px;
        padding: 0 12px;
        border: 1px solid var(--line);
        border-radius: 12px;
      }
      /* Colours are what these are about, whatever colours a person has chosen for pages. */
      .dot {
        forced-color-adjust: none;
        width: 26px;
        height: 26px;
        flex: none;
        border-radius: 50%;
        background: var(--colour);
        box-shadow:
          inset 3px 3px 6px rgb(255 255 255 / 0.45),
          inset -4px -4px 8px rgb(0 0 0 / 0.28);
      }
      ${SWATCHES}
      .any {
        background: conic-gradient(#b5453c, #d9a441, #6e9a4f, #3f7f8f, #5a4f9a, #b5453c);
      }
      .own {
        position: relative;
        z-index: 1;
        width: 34px;
        height: 34px;
        flex: none;
        padding: 0;
        border: 1px solid var(--edge);
        border-radius: 50%;
        background: none;
        overflow: hidden;
        cursor: pointer;
      }
      .own::-webkit-color-swatch-wrapper {
        padding: 0;
      }
      .own::-webkit-color-swatch,
      .own::-moz-color-swatch {
        border: 0;
      }
      .swatch .own {
        margin: 0 -4px;
      }
      .line,
      .unit {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        justify-content: space-between;
        gap: 6px 12px;
      }
      .line {
        margin-bottom: 14px;
      }
      .pair {
        display: flex;
        align-items: center;
        gap: 8px;
        min-width: 0;
      }
      .part {
        display: block;
        margin-bottom: 18px;
      }
      .unit {
        padding-top: 14px;
        border-top: 1px solid var(--line);
      }
      .hint {
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.88rem;
      }
    `,
  ];
}

function entries<K extends string>(record: Readonly<Record<K, string>>): readonly (readonly [K, string])[] {
  return Object.entries(record) as [K, string][];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-look": PasuLook;
  }
}
