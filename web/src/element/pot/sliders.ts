/** The parameters that an element shows, as sliders. */

import { css, html, LitElement, nothing } from "lit";
import { property } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { unitOf } from "../../document/look";
import { pathText, setPath } from "../../document/path";
import { type Field, fieldValue, sizeFactor, withField } from "../../document/schema";
import type { Design, Refusal, Shape } from "../../document/types";
import "../../ui/number-field";
import type { NumberChangeEvent, NumberResetEvent } from "../../ui/number-field";
import { base } from "../../ui/styles";
import { parameters } from "../../words/english/parameters";
import { fieldWords } from "../../words/parameters";
import { whyWords } from "../../words/refusals";
import { familyIn } from "./controls";

/** What a hand does with them. */
export interface Hand {
  set(design: Design): void;
  done(): void;
  cancel(): void;
}

const SHAPE = ["parts", 0, "shape"] as const;

export class PasuPotSliders extends LitElement {
  @property({ attribute: false }) design: Design | null = null;
  /** What was opened: a reset leads there, and the ranges go by it. */
  @property({ attribute: false }) origin: Design | null = null;
  @property({ attribute: false }) fields: readonly Field[] = [];
  /** The solver's objection to the design. */
  @property({ attribute: false }) problem: Refusal | null = null;
  @property({ attribute: false }) hand: Hand | null = null;

  override render() {
    const { design } = this;
    const shape = design?.parts[0]?.shape;
    if (!design || !shape) return html``;
    const opened = this.origin?.parts[0]?.shape;
    const origin = opened?.kind === shape.kind ? opened : shape;
    return html`${repeat(
      this.fields,
      ({ key }) => `${shape.kind} ${key}`,
      (field) => this.#number(design, shape, origin, field),
    )}`;
  }

  #number(design: Design, shape: Shape, origin: Shape, field: Field) {
    const family = familyIn(design);
    if (!family) return nothing;
    const { name, help } = fieldWords(family.kind, field.key);
    const isLength = field.dimension === "length";
    const factor = isLength ? sizeFactor(family, origin) : 1;
    const objection = this.problem?.path === pathText([...SHAPE, ...field.path]) ? whyWords(this.problem) : "";
    const set = (value: number) => this.hand?.set(setPath(design, SHAPE, withField(shape, field, value)));
    return html`<pasu-number
      .label=${name}
      .qualifier=${qualifierOf(field)}
      .symbol=${field.symbol}
      .unit=${isLength ? unitOf(design) : ""}
      .help=${help}
      .problem=${objection}
      .value=${fieldValue(shape, field)}
      .min=${factor * field.min}
      .max=${factor * field.max}
      .step=${factor * field.step}
      .opened=${fieldValue(origin, field)}
      @number-change=${({ value }: NumberChangeEvent) => set(value)}
      @number-done=${() => this.hand?.done()}
      @number-cancel=${() => this.hand?.cancel()}
      @number-reset=${({ to }: NumberResetEvent) => {
        if (to !== "opened") return;
        set(fieldValue(origin, field));
        this.hand?.done();
      }}
    ></pasu-number>`;
  }

  static override readonly styles = [
    base,
    css`
      :host {
        display: grid;
        grid-template-columns: repeat(auto-fit, minmax(min(240px, 100%), 1fr));
        align-content: start;
        column-gap: 22px;
        padding: 6px 14px 10px;
        background: var(--sheet);
        border-top: 1px solid var(--line);
      }
    `,
  ];
}

/** Of a parameter with an x and a y. */
function qualifierOf({ pair, symbol }: Field): string {
  if (pair === undefined) return "";
  return symbol.endsWith("x") ? parameters.inX : parameters.inY;
}

// A page may hold two versions of the element, of which the first is there.
if (!customElements.get("pasu-pot-sliders")) customElements.define("pasu-pot-sliders", PasuPotSliders);

declare global {
  interface HTMLElementTagNameMap {
    "pasu-pot-sliders": PasuPotSliders;
  }
}
