/** The slider that mixes the pot on the stage with another. However often it is moved, all of it is one step that undo takes back. */

import { batch } from "@preact/signals-core";
import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Design } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { isolated } from "../../language";
import { card } from "../../ui/card";
import "../../ui/number-field";
import type { NumberChangeEvent, PasuNumber } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { mix as words } from "../../words/english/mix";
import { page } from "../../words/english/page";
import { whyWords } from "../../words/refusals";
import { type Mix, mixOf } from "../../work/mix";

/** What the pot is mixed with. */
export interface Other {
  readonly design: Design;
  readonly title: string;
}

interface Mixed {
  readonly design: Design;
  readonly percent: number;
}

@customElement("pasu-mix")
export class PasuMix extends DesignerElement {
  @property({ attribute: false }) other: Other | null = null;
  /** Null until both pots have been read. */
  @state() private mix: Mix | null = null;
  @query("pasu-number") private readonly field!: PasuNumber | null;
  /** The pot as it was before. */
  private mine: Design | null = null;
  /** The pot as it was mixed last, and with how much. */
  private last: Mixed | null = null;
  /** The same as it was when the hand last let go; null where nothing was mixed in. */
  private settled: Mixed | null = null;

  override willUpdate(changed: PropertyValues): void {
    const { design } = this.designer.store;
    if (changed.has("other") && this.other) {
      this.mine = design;
      this.last = null;
      this.settled = null;
      this.mix = null;
      void this.read(design, this.other);
      return;
    }
    // Whoever changes the pot otherwise, or opens another, has had enough of mixing.
    if (design !== this.mine && design !== this.last?.design) this.dispatchEvent(new Event("mix-closed"));
  }

  override render() {
    const { other, mix } = this;
    if (!other) return nothing;
    return html`<section aria-labelledby="mixed">
      <h3 id="mixed">${words.of(page.quoted(isolated(other.title)))}</h3>
      ${mix ? this.body(mix) : html`<p>${page.checking}</p>`}
    </section>`;
  }

  override updated(changed: PropertyValues): void {
    if (changed.has("mix") && this.mix) void this.enter();
  }

  /** What was pressed to come here is gone. */
  private async enter(): Promise<void> {
    await this.field?.updateComplete;
    (this.field ?? this.renderRoot.querySelector("button"))?.focus();
  }

  private body(mix: Mix) {
    const done = mix.state === "done";
    return html`
      ${
        done
          ? html`<pasu-number
              .label=${words.share}
              .unit=${"%"}
              .help=${words.help}
              .value=${this.percent}
              .min=${0}
              .max=${100}
              .within=${[0, 100]}
              .step=${1}
              .explain=${this.designer.store.session.explain}
              @number-change=${(event: NumberChangeEvent) => this.take(mix.at, event)}
              @number-done=${this.rest}
              @number-cancel=${this.cancel}
            ></pasu-number>`
          : html`<p role="alert">${mix.state === "refused" ? words.refused(whyWords(mix.refusal)) : words[mix.state]}</p>`
      }
      <div class="acts">
        ${done ? html`<button class="button primary" type="button" @click=${this.close}>${words.keep}</button>` : nothing}
        <button class="button outlined" type="button" @click=${this.leave}>${words.leave}</button>
      </div>
    `;
  }

  private get percent(): number {
    const { last } = this;
    return last && last.design === this.designer.store.design ? last.percent : 0;
  }

  private async read(before: Design, other: Other): Promise<void> {
    const mix = await mixOf(this.designer.solver, before, other.design);
    if (this.other === other) this.mix = mix;
  }

  private take(at: (share: number) => Design, { value: percent, gesture }: NumberChangeEvent): void {
    const { designer, mine } = this;
    const { store } = designer;
    batch(() => {
      // The step of an earlier drag makes room for this one's.
      if (!store.inGesture && store.design !== mine) store.undo();
      designer.apply({ design: at(percent / 100), undo: "merge", key: "mix" });
      this.last = { design: store.design, percent };
      if (!gesture) this.rest();
    });
    this.requestUpdate();
  }

  /** A drag that ended where it began was none. */
  private readonly rest = (): void => {
    const { store } = this.designer;
    this.settled = store.design === this.mine ? null : this.last;
    if (store.inGesture && !this.settled) store.cancelGesture();
    else store.endGesture();
  };

  /** The finger was lost to scrolling: what was mixed before it came is there again. */
  private readonly cancel = (): void => {
    const { designer, settled } = this;
    batch(() => {
      designer.store.cancelGesture();
      if (settled) designer.apply({ design: settled.design, undo: "step" });
      this.last = settled;
    });
    this.requestUpdate();
  };

  private readonly leave = (): void => {
    const { store } = this.designer;
    if (store.design !== this.mine) store.undo();
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("mix-closed"));
  };

  static override readonly styles = [base, buttons, card];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-mix": PasuMix;
  }
}
