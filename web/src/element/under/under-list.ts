/** Lists the parts that lie under a point of the stage, from front to back, also those that are hidden by others: choosing one selects it. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { type Pierced, piercedBy } from "../../document/pierced";
import type { Design, Refusal } from "../../document/types";
import { isolated } from "../../language";
import type { Stage } from "../../render/stage";
import { Probe } from "../../render/under/probe";
import { alsoSelect, selectedIds, selectParts } from "../../state/seen-actions";
import { base, buttons } from "../../ui/styles";
import { under as words } from "../../words/english/under";
import { partName } from "../../words/parts";
import { lengthWords } from "../../words/quantities";
import { refusalWords } from "../../words/refusals";
import { DesignerElement } from "../designer-element";
import type { Spot } from "./ask";

const DIGITS = 2;
/** Between the point and the list, and between that and the edge of the stage, in pixels. */
const GAP = 10;

@customElement("pasu-under")
export class PasuUnder extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  /** The point of the stage, in CSS pixels from its upper left. */
  @property({ attribute: false }) at: Spot = { x: 0, y: 0 };
  /** Null until it is known. */
  @state() private found: readonly Pierced[] | null = null;
  @state() private problem: Refusal | null = null;
  @query(".list") private readonly list!: HTMLElement;
  private of: Design | null = null;
  private asked = 0;
  /** Whether the focus is where it belongs already. */
  private focused = false;

  override connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("pointerdown", this.pressed, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("pointerdown", this.pressed, { capture: true });
    this.asked += 1;
    // What was outlined while it was pointed at.
    this.outline(null);
  }

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("at") || changed.has("stage")) void this.look();
  }

  override render() {
    const { design } = this.designer.store;
    const { found, problem, of } = this;
    return html`
      <span class="point" aria-hidden="true"></span>
      <div class="list" @keydown=${this.key}>
        <p class="heading" id="heading">${words.heading}</p>
        ${
          problem
            ? html`<p role="status">${refusalWords(problem, design)}</p>`
            : found === null
              ? html`<p role="status">${words.looking}</p>`
              : found.length === 0
                ? html`<p role="status">${words.nothing}</p>`
                : html`<div role="menu" aria-labelledby="heading" aria-describedby="keys">
                    ${found.map((each, at) => this.item(each, at, of ?? design))}
                  </div>`
        }
        <p id="keys" class="spoken">${words.keys}</p>
      </div>
    `;
  }

  override updated(): void {
    // What was asked of another design says nothing of this one.
    if (this.of && this.designer.store.design !== this.of) this.close();
    this.stand();
    if (this.found === null || this.focused) return;
    this.focused = true;
    const [first] = this.items();
    (first ?? this.list).focus();
  }

  private item({ part, behind }: Pierced, at: number, design: Design) {
    const id = this.designer.store.ids[part];
    const chosen = id !== undefined && selectedIds(this.designer.state).includes(id);
    return html`<button
      class="button"
      type="button"
      role="menuitemradio"
      aria-checked=${chosen ? "true" : "false"}
      tabindex=${at === 0 ? 0 : -1}
      @click=${(event: MouseEvent) => this.choose(part, event.shiftKey || event.ctrlKey || event.metaKey)}
      @focus=${() => this.outline(part)}
      @pointerenter=${() => this.outline(part)}
    >
      <span>${isolated(partName(part, design.parts[part]?.name))}</span>
      ${at === 0 ? nothing : html`<small>${words.behind(lengthWords(behind, unitOf(design), DIGITS))}</small>`}
    </button>`;
  }

  /** Asks what lies there; the newest question alone is answered. */
  private async look(): Promise<void> {
    this.asked += 1;
    const { asked, designer, stage, at } = this;
    const { design } = designer.store;
    this.of = design;
    this.found = null;
    this.problem = null;
    this.focused = false;
    if (!stage) return;
    const { tool, giveBack } = stage.lend((bench) => new Probe(bench));
    giveBack();
    const ray = tool.ray(at.x, at.y);
    const made = ray && (await designer.openMade());
    if (asked !== this.asked) return;
    if (!ray || !made) {
      this.close();
      return;
    }
    const outcome = await made.maker.ask({ kind: "pick", design, ray });
    if (asked !== this.asked || outcome.state === "superseded") return;
    if (outcome.state === "refused") {
      this.problem = outcome.refusal;
      this.found = [];
      return;
    }
    const { ids, session } = designer.store;
    const hidden = (part: number) => session.hidden.includes(ids[part] ?? -1);
    this.found = piercedBy(outcome.value, ({ part, point }) => !hidden(part) && !tool.isCut(part, point));
  }

  private choose(part: number, also: boolean): void {
    const { designer } = this;
    const id = designer.store.ids[part];
    if (id !== undefined) designer.apply(also ? alsoSelect(designer.state, id) : selectParts(id));
    this.close();
  }

  /** Outlines a part of the list on the stage, or again what is selected. */
  private outline(part: number | null): void {
    const { designer, stage } = this;
    const id = part === null ? undefined : designer.store.ids[part];
    stage?.select(id === undefined ? selectedIds(designer.store) : [id]);
  }

  /** Stands beside the point, within the stage. */
  private stand(): void {
    const { width, height } = this.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = this.list;
    const { x, y } = this.at;
    const left = x + GAP + offsetWidth > width - GAP ? x - GAP - offsetWidth : x + GAP;
    const within = (value: number, most: number) => Math.max(GAP, Math.min(value, most - GAP));
    this.list.style.setProperty("left", `${within(left, width - offsetWidth)}px`);
    this.list.style.setProperty("top", `${within(y + GAP, height - offsetHeight)}px`);
    const point = this.renderRoot.querySelector<HTMLElement>(".point");
    point?.style.setProperty("translate", `${x.toFixed(1)}px ${y.toFixed(1)}px`);
  }

  private items(): readonly HTMLButtonElement[] {
    return [...this.renderRoot.querySelectorAll<HTMLButtonElement>("[role=menuitemradio]")];
  }

  private readonly key = (event: KeyboardEvent): void => {
    const items = this.items();
    const now = items.indexOf(this.shadowRoot?.activeElement as HTMLButtonElement);
    const to = { ArrowDown: now + 1, ArrowUp: now - 1, Home: 0, End: items.length - 1 }[event.key];
    if (event.key === "Escape" || event.key === "Tab") this.close();
    else if (event.key === "Enter" && event.shiftKey)
      items[now]?.dispatchEvent(new MouseEvent("click", { shiftKey: true }));
    else if (to !== undefined && items.length > 0) items[(to + items.length) % items.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  private readonly pressed = (event: Event): void => {
    if (!event.composedPath().includes(this)) this.close();
  };

  private close(): void {
    this.dispatchEvent(new Event("under-closed"));
  }

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        position: absolute;
        z-index: 7;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
      }
      .point {
        position: absolute;
        top: -5px;
        left: -5px;
        width: 10px;
        height: 10px;
        border: 2px solid var(--accent);
        border-radius: 50%;
        box-shadow: 0 0 0 2px var(--sheet);
      }
      .list {
        position: absolute;
        min-width: 180px;
        max-width: min(320px, calc(100% - 20px));
        max-height: calc(100% - 20px);
        padding: 8px 6px 6px;
        overflow-y: auto;
        overscroll-behavior: contain;
        border: 1px solid var(--line);
        border-radius: 12px;
        background: var(--sheet);
        box-shadow: 0 12px 40px var(--shadow);
        pointer-events: auto;
      }
      .heading {
        padding: 0 10px 4px;
        color: var(--soft);
        font-size: 0.86rem;
        font-weight: 600;
      }
      .list > p[role="status"] {
        padding: 4px 10px 8px;
        color: var(--soft);
      }
      [role="menu"] {
        display: grid;
      }
      .button {
        justify-content: space-between;
        gap: 18px;
        overflow-wrap: anywhere;
        text-align: start;
        white-space: normal;
      }
      small {
        flex: none;
        color: var(--soft);
        font-size: 0.84rem;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-under": PasuUnder;
  }
}
