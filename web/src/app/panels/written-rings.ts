/** The rings of boundary data that are written out, each a card: radius, height, place, sharp, and away with it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { BoundaryValue } from "../../document/types";
import { type Mean, meanOf, withMean, withPlace, withSharpRing } from "../../document/written-rings";
import { DesignerElement } from "../../element/designer-element";
import { changeWritten, removeRing } from "../../state/ring-actions";
import { cells } from "../../ui/cells";
import { checks } from "../../ui/checks";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { rings as words } from "../../words/english/rings";

type Ring = NonNullable<BoundaryValue["rings"]>[number];

/** Lengths have no more digits than anybody reads. */
const DIGITS = 8;

@customElement("pasu-written-rings")
export class PasuWrittenRings extends DesignerElement {
  override render() {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    const rings = shape?.kind === "boundary-value" ? (shape.rings ?? []) : [];
    if (shape?.kind !== "boundary-value" || rings.length === 0) return nothing;
    return html`<ol>
      ${rings.map((ring, index) => this.card(shape, ring, index))}
    </ol>`;
  }

  private card(shape: BoundaryValue, ring: Ring, index: number) {
    const name = words.ring(index + 1);
    return html`<li>
      <div class="head">
        <h3>${name}</h3>
        <button class="button bare" type="button" aria-label=${words.of(words.remove, name)} title=${words.remove} @click=${() => this.designer.apply(removeRing(this.designer.state, index + 1))}>
          ${icon("remove")}
        </button>
      </div>
      <div class="numbers">
        ${this.mean(shape, index, "radius")} ${this.mean(shape, index, "height")}
        ${this.number(words.place, name, "", ring.u, this.problemAt(["rings", index, "u"]), (now, value) => withPlace(now, index, value))}
      </div>
      <label class="check">
        <input
          type="checkbox"
          .checked=${ring.sharp ?? false}
          @change=${(event: Event) => {
            const { checked } = event.target as HTMLInputElement;
            this.designer.apply(changeWritten(this.designer.state, (now) => withSharpRing(now, index, checked)));
          }}
        />
        ${words.sharp}
      </label>
    </li>`;
  }

  private mean(shape: BoundaryValue, index: number, of: Mean) {
    const value = meanOf(shape, index, of);
    if (value === null) return nothing;
    const unit = unitOf(this.designer.store.design);
    return this.number(words[of], words.ring(index + 1), unit, value, "", (now, next) =>
      withMean(now, index, of, next),
    );
  }

  private number(
    label: string,
    name: string,
    unit: string,
    value: number,
    problem: string,
    set: (shape: BoundaryValue, value: number) => BoundaryValue,
  ) {
    const { designer } = this;
    return html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${words.of(label, name)}
        .unit=${unit}
        .value=${Number(value.toPrecision(DIGITS))}
        .step=${unit === "" ? 0.01 : 0.1}
        .problem=${problem}
        @number-change=${(event: NumberChangeEvent) =>
          designer.apply(
            changeWritten(
              designer.state,
              (now) => set(now, event.value),
              event.gesture ? `${name} ${label}` : undefined,
            ),
          )}
        @number-done=${() => designer.store.endGesture()}
        @number-cancel=${() => designer.store.cancelGesture()}
      ></pasu-number
    ></span>`;
  }

  static override readonly styles = [
    base,
    buttons,
    cells,
    checks,
    css`
      :host {
        display: block;
      }
      ol {
        display: grid;
        gap: 10px;
        margin: 4px 0 14px;
        padding: 0;
        list-style: none;
      }
      li {
        padding: 4px 12px 6px;
        border: 1px solid var(--line);
        border-radius: 12px;
      }
      .head {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      h3 {
        font-size: 0.95rem;
        font-weight: 650;
      }
      .numbers {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 6px 8px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-written-rings": PasuWrittenRings;
  }
}
