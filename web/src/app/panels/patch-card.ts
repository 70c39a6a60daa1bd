/** A form as a network of patches, offered in its place: through how many, and how far it is off, before it is taken. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { faultOf } from "../../document/network/network";
import { spanOf } from "../../document/network/span";
import type { Part, Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import type { WovenShape } from "../../maker/woven";
import { formatNumber } from "../../number";
import { card } from "../../ui/card";
import { cells } from "../../ui/cells";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { told } from "../../ui/told";
import { typing } from "../../ui/typing";
import { boundWords } from "../../words/bound";
import { networks as words } from "../../words/english/networks";
import { whyWords } from "../../words/refusals";
import { Seeking } from "../seeking";

const PAUSE_MS = 120;
/** Nobody needs more than these either way. */
const MOST = 120;

interface Found extends WovenShape {
  readonly from: Shape;
}

@customElement("pasu-patch-card")
export class PasuPatchCard extends DesignerElement {
  private readonly seeking = new Seeking<Found>(this, PAUSE_MS);
  @state() private rows = 6;
  /** As many as the waves of the form take until somebody says otherwise. */
  @state() private columns: number | null = null;
  /** Which count was typed to what none can be. */
  @state() private astray: "rows" | "columns" | null = null;
  private asked: Shape | null = null;

  override willUpdate(): void {
    const { store } = this.designer;
    const shape = this.chosen?.shape ?? null;
    if (!shape || shape === this.asked || store.inGesture) return;
    this.ask(shape);
  }

  override render() {
    return html`<section aria-labelledby="become" tabindex="-1">
      <h3 id="become">${words.become}</h3>
      <p class="lead">${words.becomeAbout}</p>
      <div class="two">${this.count(words.columns, "columns", 3)}${this.count(words.rows, "rows", 1)}</div>
      <p class="found" role="status">${this.told()}</p>
      <div class="acts">
        <button class="button primary" type="button" ?disabled=${this.useful === null} @click=${this.use}>${words.use}</button>
        <button class="button outlined" type="button" @click=${this.leave}>${words.leave}</button>
      </div>
    </section>`;
  }

  /** What was pressed to come here is gone. A field would bring up the keys of a phone. */
  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>("section")?.focus();
  }

  private get chosen(): Part | undefined {
    const { design, part } = this.designer.state;
    return design.parts[part];
  }

  private count(label: string, key: "rows" | "columns", least: number) {
    return html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${label}
        .value=${this[key] ?? this.seeking.ready?.columns ?? 0}
        .step=${1}
        .problem=${this.astray === key ? words.noSuchCount(formatNumber(least), formatNumber(MOST)) : ""}
        @input=${this.typing}
        @number-change=${({ value }: NumberChangeEvent) => {
          // What is typed stays as it is: a digit alone may be on the way to a number that can be.
          const isOne = Number.isInteger(value) && value >= least && value <= MOST;
          this.astray = isOne ? null : key;
          if (!isOne) return;
          this[key] = value;
          if (this.asked) this.ask(this.asked);
        }}
      ></pasu-number
    ></span>`;
  }

  private readonly typing = typing(() => {
    this.astray = null;
  });

  private get useful(): Found | null {
    const { ready } = this.seeking;
    return ready && faultOf(ready.shape) === null ? ready : null;
  }

  private told() {
    const { coming, found } = this.seeking;
    if (coming || found === null) return words.comparing;
    if (found.state === "superseded") return nothing;
    if (found.state === "refused") return html`<span class="warn">${whyWords(found.refusal)}</span>`;
    if (!this.useful) return html`<span class="warn">${words.cannot}</span>`;
    return this.apart(found.value.distance);
  }

  private ask(from: Shape): void {
    const { designer, rows, columns } = this;
    this.asked = from;
    this.seeking.soon(async () => {
      const made = await designer.openMade();
      if (!made) {
        this.leave();
        return null;
      }
      // Alone, and as it is before it is placed.
      const design = { pasu: 1, parts: [{ shape: from }] } as const;
      const found = await made.maker.ask({ kind: "woven", design, part: 0, rows, columns, span: spanOf(from) });
      return found.state === "done" ? { state: "done", value: { ...found.value, from } } : found;
    });
  }

  private readonly use = (): void => {
    const { designer, useful } = this;
    const { design, part } = designer.state;
    const before = design.parts[part];
    if (!useful || !before) return;
    if (before.shape !== useful.from) {
      designer.notices.say(words.changed);
      return;
    }
    const { wall: _, ...rest } = before;
    const parts = design.parts.map((each, place) => (place === part ? { ...rest, shape: useful.shape } : each));
    designer.apply({ design: { ...design, parts }, undo: "step" });
    designer.notices.say(this.apart(useful.distance));
    const root = this.getRootNode() as ShadowRoot;
    this.leave();
    void focusOnNetwork(root);
  };

  /** How far what is so far off before placement is where the part stands. */
  private apart(distance: number): string {
    const { design, part } = this.designer.state;
    const scale = design.parts[part]?.place?.scale ?? [1];
    return words.apart(boundWords(Math.max(...scale.map(Math.abs)) * distance, unitOf(design)));
  }

  private readonly leave = (): void => {
    this.dispatchEvent(new Event("patch-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    card,
    cells,
    told,
    css`
      p {
        padding: 4px 0 6px;
      }
      .two {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 8px;
        align-items: start;
      }
    `,
  ];
}

/** The card is gone with the form: the focus goes on to what stands in its place. */
async function focusOnNetwork(root: ShadowRoot): Promise<void> {
  await import("./network-panel");
  const panel = root.querySelector("pasu-network-panel");
  await panel?.updateComplete;
  panel?.renderRoot.querySelector("button")?.focus();
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-patch-card": PasuPatchCard;
  }
}
