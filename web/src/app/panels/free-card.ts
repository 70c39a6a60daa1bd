/** A form as rings, offered in its place: with how many, and how far it is off, before it is taken. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import type { Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import "../../ui/number-field";
import type { NumberChangeEvent, PasuNumber } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { freeing as words } from "../../words/english/freeing";
import { cannotWords } from "../../words/freeing";
import { spokenLength } from "../../words/quantities";
import { type Freed, finenessOf, freed, takeFreed } from "../../work/freeing";
import type { Outcome } from "../../worker/port";

/** What the slider reaches to either side of what is good to begin with. */
const REACH = 20;

/** Lengths that say how far off: more digits are of no use. */
const DIGITS = 2;

@customElement("pasu-free-card")
export class PasuFreeCard extends DesignerElement {
  /** Null while it is not known. */
  @state() private found: Outcome<Freed> | null = null;
  private first = 0;
  private tolerance = 0;
  /** What was asked for. */
  private asked: Shape | null = null;

  override willUpdate(): void {
    const { store, extents } = this.designer;
    const shape = store.design.parts[store.part]?.shape ?? null;
    if (this.first === 0) {
      this.first = finenessOf(extents);
      this.tolerance = this.first;
    }
    // While a hand changes it there is nothing to make rings of.
    if (shape && shape !== this.asked && !store.inGesture) this.ask(shape);
  }

  override render() {
    const unit = unitOf(this.designer.store.design);
    return html`<section aria-labelledby="free">
      <h3 id="free">${words.heading}</h3>
      <p>${words.lead}</p>
      <pasu-number
        .label=${words.tolerance}
        .unit=${unit}
        .help=${words.toleranceHelp}
        .value=${this.tolerance}
        .min=${this.first / REACH}
        .max=${this.first * REACH}
        .step=${this.first / REACH}
        .explain=${this.designer.store.session.explain}
        @number-change=${this.change}
      ></pasu-number>
      <p class="found" role="status">${this.told()}</p>
      <div class="acts">
        <button class="button primary" type="button" ?disabled=${this.found?.state !== "done"} @click=${this.use}>${words.use}</button>
        <button class="button outlined" type="button" @click=${this.leave}>${words.leave}</button>
      </div>
    </section>`;
  }

  override firstUpdated(): void {
    void this.enter();
  }

  /** What was pressed to come here is gone. */
  private async enter(): Promise<void> {
    const field = this.renderRoot.querySelector<PasuNumber>("pasu-number");
    await field?.updateComplete;
    field?.focus();
  }

  private told() {
    const unit = unitOf(this.designer.store.design);
    switch (this.found?.state) {
      case "done": {
        const { shape, distance } = this.found.value;
        const rings = shape.rings.length;
        return distance === 0 ? words.exact(rings) : words.found(rings, spokenLength(distance, unit, DIGITS));
      }
      case "refused":
        return html`<span class="warn">${cannotWords(this.found.refusal, unit)}</span>`;
      case "superseded":
        return nothing;
      default:
        return words.coming;
    }
  }

  private ask(shape: Shape): void {
    this.asked = shape;
    this.found = null;
    void this.seek(shape, this.tolerance);
  }

  private async seek(shape: Shape, tolerance: number): Promise<void> {
    const { designer } = this;
    const made = await designer.openMade();
    if (!made) {
      this.dispatchEvent(new Event("free-closed"));
      return;
    }
    const found = await freed(made.maker, designer.store, tolerance);
    if (this.asked === shape && this.tolerance === tolerance && found.state !== "superseded") this.found = found;
  }

  private readonly change = ({ value }: NumberChangeEvent): void => {
    if (!(value > 0) || !this.asked) return;
    this.tolerance = value;
    this.ask(this.asked);
  };

  private readonly use = (): void => {
    const { found, designer } = this;
    if (found?.state !== "done") return;
    const { shape, distance } = found.value;
    if (takeFreed(designer.store, found.value)) {
      const unit = unitOf(designer.store.design);
      const rings = shape.rings.length;
      designer.notices.say(
        distance === 0 ? words.exact(rings) : words.done(rings, spokenLength(distance, unit, DIGITS)),
      );
      this.leave();
    } else designer.notices.say(words.changed);
  };

  private readonly leave = (): void => {
    this.dispatchEvent(new Event("free-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      section {
        margin: 4px 0 14px;
        padding: 12px 14px 14px;
        border-radius: 12px;
        background: var(--well);
      }
      h3 {
        font-size: 1rem;
        font-weight: 650;
      }
      p {
        padding: 4px 0 6px;
        color: var(--soft);
        text-wrap: pretty;
      }
      .found {
        color: var(--ink);
        font-weight: 600;
      }
      .warn {
        color: var(--warn);
        font-weight: 400;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        padding-top: 4px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-free-card": PasuFreeCard;
  }
}
