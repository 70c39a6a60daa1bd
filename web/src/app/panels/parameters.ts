/** The parameters of the selected part, made from its family's schema and grouped as a potter thinks. */

import { computed, type ReadonlySignal } from "@preact/signals-core";
import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { unitOf } from "../../document/look";
import { pathText } from "../../document/path";
import {
  type Family,
  type Field,
  familyOf,
  fieldValue,
  GROUPS,
  type Group,
  type Row,
  rowsOf,
  sizeFactor,
} from "../../document/schema";
import type { Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { toggleExplain } from "../../state/actions";
import { resetFields, setFields, setLock } from "../../state/shape-actions";
import { icon } from "../../ui/icons";
import { lock } from "../../ui/lock";
import "../../ui/number-field";
import type { NumberChangeEvent, NumberResetEvent } from "../../ui/number-field";
import { base, buttons, disclosure, pointed } from "../../ui/styles";
import { page } from "../../words/english/page";
import { parameters } from "../../words/english/parameters";
import { fieldWords } from "../../words/parameters";
import { explainButton } from "./explain-button";

const NEVER = 1e-12;

@customElement("pasu-parameters")
export class PasuParameters extends DesignerElement {
  /** Those alone, without a word about the family; all of them, with it, where there is none. */
  @property({ attribute: false }) groups: readonly Group[] | null = null;
  /** Whether rings are looked for instead of it. */
  @state() private freeing = false;
  /** Whether it is about to become patches. */
  @state() private weaving = false;
  /** What has cards of its own draws these again, and none of this. */
  readonly #kind = computed(() => this.#shape.value?.kind);
  /** The same while the part alone is moved. */
  readonly #shape: ReadonlySignal<Shape | undefined> = computed(() => {
    const { design, part } = this.designer.store;
    return design.parts[part]?.shape;
  });
  readonly #opened = computed(() => this.designer.origin.design.parts[this.designer.store.part]?.shape);
  readonly #isOpen = computed(() => this.designer.surface.shown?.solved.facts?.closed === false);
  readonly #unit = computed(() => unitOf(this.designer.store.design));

  override render() {
    const kind = this.#kind.value;
    if (kind === undefined) return nothing;
    if (kind === "rings") {
      this.fetch("pasu-ring-cards", () => import("./ring-cards"));
      return html`<pasu-ring-cards .designer=${this.designer}></pasu-ring-cards>${this.patching()}`;
    }
    if (kind === "vertex-frame") {
      this.fetch("pasu-network-panel", () => import("./network-panel"));
      return html`<pasu-network-panel .designer=${this.designer}></pasu-network-panel>`;
    }
    if (kind === "octant") {
      this.fetch("pasu-octant", () => import("./octant-panel"));
      return html`<pasu-octant .designer=${this.designer}></pasu-octant>`;
    }
    if (kind === "blend") {
      this.fetch("pasu-blend-cards", () => import("./blend-cards"));
      return html`<pasu-blend-cards .designer=${this.designer}></pasu-blend-cards>`;
    }
    const shape = this.#shape.value;
    if (!shape) return nothing;
    const family = familyOf(kind);
    if (!family) {
      this.fetch("pasu-modes", () => import("./modes-table"));
      const ringed = shape.kind === "boundary-value" && (shape.rings ?? []).length > 0;
      if (ringed) this.fetch("pasu-written-rings", () => import("./written-rings"));
      return html`${this.offer()}${ringed ? html`<pasu-written-rings .designer=${this.designer}></pasu-written-rings>` : nothing}<pasu-modes .designer=${this.designer}></pasu-modes>`;
    }
    return html`
      ${this.groups ? nothing : this.intro(family)}
      ${this.groups ? nothing : this.openNote(shape)}
      ${(this.groups ?? GROUPS).map((group) => {
        const rows = rowsOf(family, group);
        if (rows.length === 0) return nothing;
        return html`<details open>
          <summary><h3>${parameters.groups[group].name}</h3><span>${parameters.groups[group].help}</span></summary>
          ${repeat(
            rows,
            (row) => `${family.kind} ${row.id}`,
            (row) => this.row(family, row, shape),
          )}
        </details>`;
      })}
      ${this.groups ? nothing : this.offer()}
    `;
  }

  /** A form that is none of rings may become one. */
  private offer() {
    if (this.freeing)
      return html`<pasu-free-card .designer=${this.designer} @free-closed=${this.closeFree}></pasu-free-card>`;
    return html`<div class="offer">
        <p>${parameters.freeAbout}</p>
        <button class="button outlined" type="button" @click=${this.openFree}>${parameters.free}</button>
      </div>
      ${this.patching()}`;
  }

  /** Any form may become patches. */
  private patching() {
    if (this.weaving)
      return html`<pasu-patch-card .designer=${this.designer} @patch-closed=${() => this.weave(false)}></pasu-patch-card>`;
    return html`<button class="button outlined patching" type="button" @click=${() => this.weave(true)}>${parameters.patches}</button>`;
  }

  private async weave(on: boolean): Promise<void> {
    try {
      if (on) await import("./patch-card");
      this.weaving = on;
    } catch {
      this.designer.notices.say(page.unfetched);
    }
    await this.updateComplete;
    if (!on) this.renderRoot.querySelector<HTMLElement>(".patching")?.focus();
  }

  private readonly openFree = async (): Promise<void> => {
    try {
      await import("./free-card");
      this.freeing = true;
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  };

  /** The focus stays where the card was: on the button that opened it, or on what has come in its place. */
  private readonly closeFree = async (): Promise<void> => {
    this.freeing = false;
    await this.updateComplete;
    const offer = this.renderRoot.querySelector<HTMLElement>(".offer button");
    if (offer) offer.focus();
    else {
      await import("./ring-cards");
      const cards = this.renderRoot.querySelector("pasu-ring-cards");
      await cards?.updateComplete;
      cards?.renderRoot.querySelector("button")?.focus();
    }
  };

  private intro(family: Family) {
    return html`<div class="intro">
        <p>${parameters.kinds[family.kind]} <span>${parameters.sources[family.kind]}</span></p>
        ${explainButton(this.designer.store.session.explain, () => this.designer.apply(toggleExplain(this.designer.state)))}
    </div>`;
  }

  private openNote(shape: Shape) {
    if (!this.#isOpen.value) return nothing;
    const why = shape.kind === "bloor-wilson" ? parameters.opensByDints : parameters.opensByPetals;
    return html`<p class="notice" role="note">${why}</p>`;
  }

  private row(family: Family, row: Row, shape: Shape) {
    const [first, second] = row.fields;
    if (!second) return this.number(family, [first], shape, "");
    const pair = [first, second] as const;
    const apart =
      Math.abs(fieldValue(shape, first) - fieldValue(shape, second)) > NEVER ||
      this.designer.store.session.unlocked.includes(row.id);
    return html`<div class="pair">
      ${
        apart
          ? html`${this.number(family, [first], shape, parameters.inX)}${this.number(family, [second], shape, parameters.inY)}`
          : this.number(family, pair, shape, "")
      }
      <button
        class="button lock"
        type="button"
        aria-pressed=${apart ? "false" : "true"}
        aria-label=${parameters.sameOf(fieldWords(family.kind, first.key).name)}
        @click=${() => this.designer.apply(setLock(this.designer.state, pair, apart))}
      >
        ${icon(apart ? "unlocked" : "locked")}<span>${parameters.same}</span>
      </button>
    </div>`;
  }

  private number(family: Family, fields: readonly Field[], shape: Shape, qualifier: string) {
    const [field] = fields;
    if (!field) return nothing;
    const { designer } = this;
    const { name, help } = fieldWords(family.kind, field.key);
    // The ranges go by the pot that was opened: no number moves the range of another.
    const origin = this.originOf(shape);
    const isLength = field.dimension === "length";
    const factor = isLength ? sizeFactor(family, origin) : 1;
    const symbol = fields.length > 1 ? (field.symbol.split("_")[0] ?? "") : field.symbol;
    return html`<pasu-number
      data-field=${field.key}
      data-at=${fields.map(({ path }) => pathText(path)).join(" ")}
      .label=${name}
      .qualifier=${qualifier}
      .symbol=${symbol}
      .unit=${isLength ? this.#unit.value : ""}
      .help=${help}
      .problem=${this.problemAt(...fields.map(({ path }) => path))}
      .value=${fieldValue(shape, field)}
      .min=${factor * field.min}
      .max=${factor * field.max}
      .step=${factor * field.step}
      .explain=${designer.store.session.explain}
      .opened=${fieldValue(origin, field)}
      .paper=${fieldValue(family.reset, field)}
      data-family=${family.kind}
      @number-change=${(event: NumberChangeEvent) =>
        designer.apply(setFields(designer.state, fields, event.value, event.gesture))}
      @number-done=${() => designer.store.endGesture()}
      @number-cancel=${() => designer.store.cancelGesture()}
      @number-reset=${({ to }: NumberResetEvent) =>
        designer.apply(resetFields(designer.state, fields, to === "opened" ? origin : family.reset))}
    ></pasu-number>`;
  }

  private originOf(shape: Shape): Shape {
    const opened = this.#opened.value;
    return opened?.kind === shape.kind ? opened : shape;
  }

  static override readonly styles = [
    base,
    buttons,
    disclosure,
    lock,
    pointed,
    css`
      :host {
        display: block;
      }
      .intro {
        display: flex;
        align-items: center;
        justify-content: space-between;
        gap: 10px;
        padding-bottom: 6px;
      }
      .intro p {
        font-weight: 600;
      }
      .intro span {
        display: block;
        color: var(--soft);
        font-size: 0.86rem;
        font-weight: 400;
      }
      .notice {
        margin: 4px 0 8px;
        padding: 8px 12px;
        border-radius: 9px;
        background: var(--warn-wash);
        color: var(--warn);
        font-size: 0.92rem;
      }
      details {
        border-top: 1px solid var(--line);
        padding: 4px 0 10px;
      }
      .offer {
        border-top: 1px solid var(--line);
        padding: 12px 0 14px;
      }
      .patching {
        margin-bottom: 14px;
      }
      .offer p {
        padding-bottom: 8px;
        color: var(--soft);
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-parameters": PasuParameters;
  }
}
