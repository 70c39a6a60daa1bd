/** What is done to all rings of a pot at once, on sliders. They start where the pot is: what is done to it elsewhere is where they start again. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Rings } from "../../document/types";
import { changed, heightOf, PETALS_AT, type PetalsAt, UNCHANGED, type Whole, widthOf } from "../../document/whole-pot";
import { DesignerElement } from "../../element/designer-element";
import { changeRings } from "../../state/ring-actions";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, disclosure } from "../../ui/styles";
import { rings as words } from "../../words/english/rings";

/** A slider of a share, from less to more. */
type ShareName = "lean" | "oval" | "taper" | "depth";
const SHARES: readonly { readonly name: ShareName; readonly most: number; readonly least: number }[] = [
  { name: "lean", least: -0.6, most: 0.6 },
  { name: "oval", least: -0.5, most: 0.5 },
  { name: "taper", least: -1, most: 1 },
];
const DEEPEST = 0.5;
const MOST_PETALS = 24;
const DEEPEST_FLUTES = 0.3;
const FLUTES = { least: 6, most: 32 } as const;
const MOST_TWIST = 180;

@customElement("pasu-whole-pot")
export class PasuWholePot extends DesignerElement {
  /** The pot before the sliders, what they say, and the pot that they made of it. */
  private held: { readonly from: Rings; readonly whole: Whole; readonly made: Rings } | null = null;

  override render() {
    const shape = this.shape;
    if (!shape) return nothing;
    const held = this.heldOf(shape);
    const { whole } = held;
    const unit = unitOf(this.designer.store.design);
    const [height, width] = [heightOf(held.from), widthOf(held.from)];
    return html`<details>
      <summary><h3>${words.whole}</h3><span>${words.wholeAbout}</span></summary>
      ${height === 0 ? nothing : this.number(words.height, words.help.height, unit, whole.height * height, [0, 2 * height], (value) => ({ height: value / height }))}
      ${width === 0 ? nothing : this.number(words.across, words.help.across, unit, whole.width * width, [0, 2 * width], (value) => ({ width: value / width }))}
      ${this.number(words.twist, words.help.twist, words.degree, whole.twist, [-MOST_TWIST, MOST_TWIST], (twist) => ({ twist }))}
      ${SHARES.map(({ name, least, most }) =>
        this.number(labelOf(name), helpOf(name), "%", 100 * whole[name], [100 * least, 100 * most], (value) => ({
          [name]: value / 100,
        })),
      )}
      ${this.number(words.depth, words.help.depth, "%", 100 * whole.depth, [0, 100 * DEEPEST], (value) => ({ depth: value / 100 }))}
      ${this.number(words.petals, words.help.petals, "", whole.petals, [2, MOST_PETALS], (petals) => ({ petals }), [1, MOST_PETALS])}
      ${choices<PetalsAt>(
        words.petalsAt,
        PETALS_AT.map((value) => ({ value, label: words.places[value] })),
        whole.at,
        (at) => this.change({ at }, false),
      )}
      ${this.number(words.fluteDepth, words.help.fluteDepth, "%", 100 * whole.flutes, [0, 100 * DEEPEST_FLUTES], (value) => ({ flutes: value / 100 }))}
      ${this.number(words.flutes, words.help.flutes, "", whole.fluteCount, [FLUTES.least, FLUTES.most], (fluteCount) => ({ fluteCount }), [FLUTES.least, FLUTES.most])}
    </details>`;
  }

  private get shape(): Rings | null {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    return shape?.kind === "rings" ? shape : null;
  }

  /** What the sliders began with: where the pot is another one by now, that. How many petals and flutes there would be, and where, stays. */
  private heldOf(shape: Rings): NonNullable<typeof this.held> {
    if (this.held?.made !== shape) {
      const { petals, at, fluteCount } = this.held?.whole ?? UNCHANGED;
      this.held = { from: shape, whole: { ...UNCHANGED, petals, at, fluteCount }, made: shape };
    }
    return this.held;
  }

  private number(
    label: string,
    help: string,
    unit: string,
    value: number,
    [min, max]: readonly [number, number],
    set: (value: number) => Partial<Whole>,
    counts?: readonly [least: number, most: number],
  ) {
    return html`<pasu-number
      .label=${label}
      .qualifier=${""}
      .help=${help}
      .unit=${unit}
      .value=${Number(value.toPrecision(10))}
      .min=${min}
      .max=${max}
      .within=${counts}
      .counted=${counts !== undefined}
      .step=${unit === "" || unit === "%" || unit === words.degree ? 1 : 10 ** Math.floor(Math.log10(max / 200) + 0.5)}
      @number-change=${(event: NumberChangeEvent) => this.change(set(event.value), event.gesture)}
      @number-done=${() => this.designer.store.endGesture()}
      @number-cancel=${() => this.designer.store.cancelGesture()}
    ></pasu-number>`;
  }

  private change(change: Partial<Whole>, gesture: boolean): void {
    const { shape, designer } = this;
    if (!shape) return;
    const { from, whole: before } = this.heldOf(shape);
    const whole = { ...before, ...change };
    designer.apply(
      changeRings(
        designer.state,
        () => changed(from, whole),
        gesture ? `whole:${Object.keys(change).join()}` : undefined,
      ),
    );
    // As the store has it: frozen, and the same object.
    this.held = { from, whole, made: this.shape ?? from };
    this.requestUpdate();
  }

  static override readonly styles = [
    base,
    choiceStyles,
    disclosure,
    css`
      :host {
        display: block;
      }
      details {
        padding: 0 12px;
        border-radius: 12px;
        background: var(--well);
      }
      details[open] {
        padding-bottom: 12px;
      }
    `,
  ];
}

function labelOf(name: ShareName): string {
  return name === "oval" ? words.swings.oval : words[name];
}

function helpOf(name: ShareName): string {
  return words.help[name];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-whole-pot": PasuWholePot;
  }
}
