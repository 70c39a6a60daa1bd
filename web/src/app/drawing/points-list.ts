/** The points of what is drawn, as numbers: for keys alone, and for whoever knows how wide it is to be. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Knot, Spot } from "../../document/drawn/knot";
import {
  addKnot,
  knotsOn,
  measured,
  moveKnot,
  placed,
  removeKnot,
  type Sheet,
  type Side,
  sharpenKnot,
  sidesDrawn,
} from "../../document/drawn/sheet";
import type { Unit } from "../../document/types";
import { cells } from "../../ui/cells";
import { checks } from "../../ui/checks";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { drawing as words } from "../../words/english/drawing";
import { pointName, SheetEvent } from "./drawing-board";

/** Steps of a number in the height of the pot. */
const STEPS = 200;

const DIGITS = 4;

@customElement("pasu-points")
export class PasuPoints extends LitElement {
  @property({ attribute: false }) sheet!: Sheet;
  @property() unit: Unit = "cm";

  override render() {
    const { sheet } = this;
    return sidesDrawn(sheet).map(
      (side) => html`
        ${sheet.left === null ? nothing : html`<h4>${words.sides[side]}</h4>`}
        <ol>
          ${knotsOn(sheet, side).map((knot, index) => this.point(side, knot, index))}
        </ol>
      `,
    );
  }

  private point(side: Side, knot: Knot, index: number) {
    const { sheet } = this;
    const name = pointName(sheet, side, index);
    const { radius, height } = measured(sheet, knot);
    const count = knotsOn(sheet, side).length;
    return html`<li>
      <strong>${name}</strong>
      ${this.number(words.of(words.radius, name), words.radius, radius, side, index, (value) => placed(sheet, side, value, height))}
      ${this.number(words.of(words.up, name), words.up, height, side, index, (value) => placed(sheet, side, radius, value))}
      <label class="check">
        <input
          type="checkbox"
          aria-label=${words.sharpOf(name)}
          .checked=${knot.sharp}
          @change=${(event: Event) => this.tell(sharpenKnot(this.sheet, side, index, (event.target as HTMLInputElement).checked))}
        />
        <span aria-hidden="true">${words.sharp}</span>
      </label>
      <span class="edit">
        <button class="button bare" type="button" aria-label=${words.add(name)} title=${words.add(name)} ?disabled=${index === count - 1} @click=${() => this.tell(addKnot(this.sheet, side, index))}>
          ${icon("add")}
        </button>
        <button class="button bare" type="button" aria-label=${words.remove(name)} title=${words.remove(name)} ?disabled=${count <= 2} @click=${() => this.tell(removeKnot(this.sheet, side, index))}>
          ${icon("remove")}
        </button>
      </span>
    </li>`;
  }

  private number(
    label: string,
    short: string,
    value: number,
    side: Side,
    index: number,
    place: (value: number) => Spot,
  ) {
    return html`<span class="cell"><span aria-hidden="true">${short}</span><pasu-number
      compact
      .label=${label}
      .unit=${this.unit}
      .value=${Number(value.toPrecision(DIGITS))}
      .step=${this.sheet.height / STEPS}
      @number-change=${({ value: chosen, gesture }: NumberChangeEvent) => this.tell(moveKnot(this.sheet, side, index, place(chosen)), !gesture)}
      @number-done=${() => this.tell(this.sheet)}
    ></pasu-number></span>`;
  }

  private tell(sheet: Sheet, settled = true): void {
    this.dispatchEvent(new SheetEvent(sheet, settled));
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
      h4 {
        padding: 6px 0 4px;
        font-size: 0.92rem;
      }
      ol {
        display: grid;
        gap: 8px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 4px 8px;
        padding: 8px 12px;
        border-radius: 12px;
        background: var(--well);
      }
      strong {
        grid-column: 1 / -1;
        font-size: 0.9rem;
      }
      .edit {
        display: flex;
        justify-content: flex-end;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-points": PasuPoints;
  }
}
