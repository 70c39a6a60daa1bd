/** A form as rings, offered in its place: with how many, and how far it is off, before it is taken. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { sizeOf } from "../../document/extents";
import { unitOf } from "../../document/look";
import type { Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { card } from "../../ui/card";
import "../../ui/number-field";
import type { NumberChangeEvent, PasuNumber } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { told } from "../../ui/told";
import { boundWords } from "../../words/bound";
import { freeing as words } from "../../words/english/freeing";
import { cannotWords } from "../../words/freeing";
import { type Freed, finenessOf, freed, takeFreed } from "../../work/freeing";
import { Seeking } from "../seeking";

/** What the slider reaches to either side of what is good to begin with. */
const REACH = 20;

/** Rings are not sought at every movement of the slider. */
const PAUSE_MS = 120;

@customElement("pasu-free-card")
export class PasuFreeCard extends DesignerElement {
  private readonly rings = new Seeking<Freed>(this, PAUSE_MS);
  private first = 0;
  @state() private tolerance = 0;
  /** What was asked for. */
  private asked: Shape | null = null;

  override willUpdate(): void {
    const { store, extents } = this.designer;
    const shape = store.design.parts[store.part]?.shape ?? null;
    if (this.first === 0) {
      this.first = finenessOf(sizeOf(extents));
      this.tolerance = this.first;
    }
    // While a hand changes it there is nothing to make rings of.
    if (shape && shape !== this.asked && !store.inGesture) this.ask(shape);
  }

  override render() {
    const unit = unitOf(this.designer.store.design);
    return html`<section aria-labelledby="free">
      <h3 id="free">${words.heading}</h3>
      <p class="lead">${words.lead}</p>
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
        <button class="button primary" type="button" ?disabled=${this.rings.ready === null} @click=${this.use}>${words.use}</button>
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
    const { coming, found } = this.rings;
    if (coming || found === null) return words.coming;
    if (found.state === "superseded") return nothing;
    if (found.state === "refused") return html`<span class="warn">${cannotWords(found.refusal, unit)}</span>`;
    const { shape, distance } = found.value;
    const rings = shape.rings.length;
    return distance === 0 ? words.exact(rings) : words.found(rings, boundWords(distance, unit));
  }

  private ask(shape: Shape): void {
    const { designer, tolerance } = this;
    this.asked = shape;
    this.rings.soon(async () => {
      const made = await designer.openMade();
      if (made) return freed(made.maker, designer.store, tolerance);
      this.leave();
      return null;
    });
  }

  private readonly change = ({ value }: NumberChangeEvent): void => {
    if (!(value > 0) || !this.asked) return;
    this.tolerance = value;
    this.ask(this.asked);
  };

  private readonly use = (): void => {
    const { designer } = this;
    const { ready } = this.rings;
    if (!ready) return;
    const { shape, distance } = ready;
    if (takeFreed(designer.store, ready)) {
      const unit = unitOf(designer.store.design);
      const rings = shape.rings.length;
      designer.notices.say(distance === 0 ? words.exact(rings) : words.done(rings, boundWords(distance, unit)));
      this.leave();
    } else designer.notices.say(words.changed);
  };

  private readonly leave = (): void => {
    this.dispatchEvent(new Event("free-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    card,
    told,
    css`
      p {
        padding: 4px 0 6px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-free-card": PasuFreeCard;
  }
}
