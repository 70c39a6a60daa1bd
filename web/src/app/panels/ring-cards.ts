/** The rings of a pot, from the rim to the foot: each a card in a potter's words. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { curveUnder } from "../../document/curves";
import { unitOf } from "../../document/look";
import {
  countsOf,
  type Hoop,
  isCounted,
  madeRound,
  restOf,
  SWING_NAMES,
  type Swing,
  type SwingName,
  swingOf,
  withFreeEnd,
  withMean,
  withSharp,
  withSwing,
} from "../../document/ring-numbers";
import type { Rings } from "../../document/types";
import { heightOf, widthOf } from "../../document/whole-pot";
import { DesignerElement } from "../../element/designer-element";
import { togglePulling } from "../../state/actions";
import { changeRing, changeRings, removeRing } from "../../state/ring-actions";
import { cells } from "../../ui/cells";
import { checks } from "../../ui/checks";
import "../../ui/menu";
import "../../ui/number-field";
import { icon } from "../../ui/icons";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure } from "../../ui/styles";
import { rings as words } from "../../words/english/rings";
import "./whole-pot-card";

/** What sliders reach, as shares of the height and the width of the pot. */
const REACH = 1.5;
/** Steps of a slider in its reach, about. */
const STEPS = 300;

@customElement("pasu-ring-cards")
export class PasuRingCards extends DesignerElement {
  @state() private numbers = false;
  /** How many and how turned what has gone to nothing was, so that it comes back so: by ring and name. */
  private readonly remembered = new Map<string, Swing>();
  /** Sliders keep their reach under the hand. */
  private reach: { readonly radius: number; readonly height: number } | null = null;

  override render() {
    const { design, part, session } = this.designer.state;
    const shape = design.parts[part]?.shape;
    if (shape?.kind !== "rings") return nothing;
    if (!this.designer.store.inGesture || !this.reach) this.reach = reachOf(shape);
    return html`
      <div class="intro">
        <p><strong>${words.lead}</strong> ${words.about}</p>
        <button
          class="button outlined"
          type="button"
          aria-pressed=${session.pulling ? "true" : "false"}
          @click=${() => this.designer.apply(togglePulling(this.designer.state))}
        >
          ${icon("pull")}<span>${words.pull}</span>
        </button>
      </div>
      <pasu-whole-pot .designer=${this.designer}></pasu-whole-pot>
      <ol>
        ${repeat(
          shape.rings.map((ring, index) => ({ ring, index })).reverse(),
          ({ ring }) => ring.u,
          ({ ring, index }) => this.card(shape, ring, index),
        )}
      </ol>
      <details class="numbers" @toggle=${this.openNumbers}>
        <summary><h3>${words.numbers}</h3><span>${words.numbersAbout}</span></summary>
        ${this.numbers ? html`<pasu-rings .designer=${this.designer}></pasu-rings>` : nothing}
      </details>
    `;
  }

  private card(shape: Rings, ring: Hoop, index: number) {
    const last = shape.rings.length - 1;
    const name = index === 0 ? words.foot : index === last ? words.rim : words.ring(index);
    const between = index > 0 && index < last;
    const end = index === 0 ? "foot" : index === last ? "rim" : null;
    const tags = tagsOf(ring);
    const { radius, height } = this.reach ?? reachOf(shape);
    const low = shape.rings[0]?.z.mean ?? 0;
    return html`<li>
      <div class="head">
        <h3>${name} <span>${tags.length === 0 ? nothing : words.like(tags)}</span></h3>
        <pasu-menu data-ring=${index} label=${words.does(name)} icon="more" bare once>
          ${index < last ? this.item("up", words.above, () => this.add(shape, index)) : nothing}
          ${index > 0 ? this.item("down", words.below, () => this.add(shape, index - 1)) : nothing}
          ${tags.length > 0 ? this.item("reset", words.makeRound, () => this.change(index, madeRound)) : nothing}
          ${end && shape[end] ? this.item("reset", words.freeEnd, () => this.designer.apply(changeRings(this.designer.state, (pot) => withFreeEnd(pot, end)))) : nothing}
          ${between ? this.item("remove", words.remove, () => void this.takeAway(index)) : nothing}
        </pasu-menu>
      </div>
      ${this.length(words.radius, name, index, "r", ring.r.mean, [0, radius])}
      ${this.length(words.height, name, index, "z", ring.z.mean, [low, low + height])}
      ${
        between
          ? html`<label class="check">
              <input
                type="checkbox"
                .checked=${ring.sharp ?? false}
                @change=${(event: Event) => this.change(index, (each) => withSharp(each, (event.target as HTMLInputElement).checked))}
              />
              ${words.sharp}
            </label>`
          : nothing
      }
      <details>
        <summary>${words.swingsOf}</summary>
        ${SWING_NAMES.map((each) => this.swing(ring, index, name, each))}
        ${restOf(ring) === 0 ? nothing : html`<p class="rest">${words.pulled(restOf(ring))}</p>`}
      </details>
    </li>`;
  }

  /** The focus goes to the ring below: what it was on has gone with its card. */
  private async takeAway(index: number): Promise<void> {
    this.designer.apply(removeRing(this.designer.state, index));
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>(`pasu-menu[data-ring="${index - 1}"]`)?.focus();
  }

  private item(sign: "up" | "down" | "reset" | "remove", label: string, act: () => void) {
    return html`<button class="button item" type="button" @click=${act}>${icon(sign)}<span>${label}</span></button>`;
  }

  private length(
    label: string,
    name: string,
    index: number,
    of: "r" | "z",
    value: number,
    [min, max]: readonly [number, number],
  ) {
    return html`<pasu-number
      .label=${label}
      .qualifier=${name}
      .unit=${unitOf(this.designer.store.design)}
      .value=${value}
      .min=${min}
      .max=${max}
      .step=${stepOf(max - min)}
      .problem=${this.problemAt(["rings", index, of, "mean"])}
      @number-change=${({ value: mean, gesture }: NumberChangeEvent) =>
        this.change(index, (ring) => withMean(ring, of, mean), gesture ? of : undefined)}
      @number-done=${() => this.designer.store.endGesture()}
      @number-cancel=${() => this.designer.store.cancelGesture()}
    ></pasu-number>`;
  }

  private swing(ring: Hoop, index: number, ringName: string, name: SwingName) {
    const found = swingOf(ring, name);
    const key = `${this.designer.store.part} ${ring.u} ${name}`;
    const before = this.remembered.get(key);
    const swing = found.size === 0 && before ? { ...before, size: 0 } : found;
    const set = (next: Swing, gesture: boolean, what: string) => {
      this.remembered.set(key, next);
      this.requestUpdate();
      // How many there would be, and how turned, is no change of the pot while there are none.
      if (next.size === 0 && found.size === 0) return;
      this.change(index, (each) => withSwing(each, name, found, next), gesture ? `${name} ${what}` : undefined);
    };
    const unit = unitOf(this.designer.store.design);
    return html`<div class="swing" role="group" aria-label=${words.of(words.swings[name], ringName)}>
      <h4>${words.swings[name]}</h4>
      ${
        isCounted(name)
          ? this.cell(
              words.count,
              name,
              ringName,
              swing.n,
              "",
              1,
              (n, gesture) => set({ ...swing, n }, gesture, "n"),
              countsOf(name),
            )
          : html`<span></span>`
      }
      ${this.cell(
        words.sizes[name],
        name,
        ringName,
        swing.size,
        unit,
        stepOf(this.reach?.radius ?? 1) * 2,
        (size, gesture) => set({ ...swing, size }, gesture, "size"),
      )}
      ${this.cell(words.turn, name, ringName, swing.turn, words.degree, 1, (turn, gesture) =>
        set({ ...swing, turn }, gesture, "turn"),
      )}
    </div>`;
  }

  private cell(
    label: string,
    name: SwingName,
    ring: string,
    value: number,
    unit: string,
    step: number,
    set: (value: number, gesture: boolean) => void,
    counts?: readonly [least: number, most: number],
  ) {
    return html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${words.of(words.of(label, words.swings[name]), ring)}
        .unit=${unit}
        .value=${value}
        .step=${step}
        .within=${counts}
        .counted=${counts !== undefined}
        @number-change=${(event: NumberChangeEvent) => set(event.value, event.gesture)}
        @number-done=${() => this.designer.store.endGesture()}
        @number-cancel=${() => this.designer.store.cancelGesture()}
      ></pasu-number
    ></span>`;
  }

  private change(index: number, edit: (ring: Hoop) => Hoop, key?: string): void {
    this.designer.apply(changeRing(this.designer.state, index, edit, key));
  }

  /** Puts a ring half way to the next. */
  private async add(shape: Rings, below: number): Promise<void> {
    const { designer } = this;
    const [low, high] = [shape.rings[below]?.u ?? 0, shape.rings[below + 1]?.u ?? 1];
    const u = Number(((low + high) / 2).toPrecision(4));
    const id = designer.store.ids[designer.store.part];
    if (curveUnder(shape, u)) designer.notices.say(words.noRoom);
    else if (id !== undefined) await (await designer.openPull())?.putRing(id, u);
  }

  private readonly openNumbers = (event: Event): void => {
    if (!(event.target as HTMLDetailsElement).open || this.numbers) return;
    this.numbers = true;
    void import("./rings-table");
  };

  static override readonly styles = [
    base,
    buttons,
    cells,
    checks,
    disclosure,
    css`
      :host {
        display: block;
      }
      .intro {
        display: grid;
        justify-items: start;
        gap: 8px;
        padding-bottom: 10px;
        color: var(--soft);
      }
      .intro strong {
        color: var(--ink);
      }
      ol {
        display: grid;
        gap: 10px;
        margin: 10px 0;
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
      h3 span {
        color: var(--soft);
        font-weight: 400;
        font-size: 0.86rem;
      }
      h4 {
        font-size: 0.88rem;
        font-weight: 600;
        padding-bottom: 8px;
      }
      .item {
        justify-content: flex-start;
      }
      li summary {
        color: var(--soft);
        font-size: 0.88rem;
      }
      .numbers {
        border-top: 1px solid var(--line);
      }
      .numbers h3 {
        color: var(--ink);
      }
      .swing {
        display: grid;
        grid-template-columns: 58px repeat(3, minmax(0, 1fr));
        align-items: end;
        gap: 6px 8px;
        padding-bottom: 8px;
      }
      .rest {
        padding-bottom: 8px;
        color: var(--soft);
        font-size: 0.86rem;
      }
    `,
  ];
}

/** What a ring is like that is not round and level. */
function tagsOf(ring: Hoop): readonly string[] {
  const named = SWING_NAMES.flatMap((name) => {
    const { size, n } = swingOf(ring, name);
    return size === 0 ? [] : [words.tags[name](n)];
  });
  // Of what a hand has pulled the names say little.
  return restOf(ring) > 0 ? [words.pulledTag] : named;
}

function reachOf(shape: Rings): { readonly radius: number; readonly height: number } {
  const [height, width] = [Math.abs(heightOf(shape)), widthOf(shape)];
  const size = Math.max(height, width) || 1;
  return { radius: (REACH * (width || size)) / 2, height: REACH * (height || size) };
}

/** A round step, of which some hundreds make the reach of a slider. */
function stepOf(reach: number): number {
  return 10 ** Math.floor(Math.log10(Math.max(reach, Number.MIN_VALUE) / STEPS) + 0.5);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-ring-cards": PasuRingCards;
  }
}
