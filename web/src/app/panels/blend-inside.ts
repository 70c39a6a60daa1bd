/** What a blend is like within: a button that shows it on the stage, three sliders, and the legend of its colours. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { scaleOfInside } from "../../document/blend/inside-scale";
import { INSIDE_MAPS, isRound, SHOWN, uncut } from "../../document/blend/looking";
import type { Blend, Triple } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber } from "../../number";
import { insidePart, toggleInside } from "../../state/seen-actions";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { colourRamp, rampLegend, rampStyles } from "../../ui/ramp";
import { base, buttons, disclosure } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { refusalWords } from "../../words/refusals";
import { type InsideDesk, insideDesk, type Seen } from "../../work/inside-desk";

const DIGITS = 3;
const STEP = 0.01;

@customElement("pasu-blend-inside")
export class PasuBlendInside extends DesignerElement {
  /** The slider that was given a number beyond the solid. */
  @state() private wrong: number | null = null;

  override render() {
    const { designer } = this;
    const { design, part } = designer.state;
    const blend = design.parts[part]?.shape;
    if (blend?.kind !== "blend") return nothing;
    const open = insidePart(designer.state) === designer.store.ids[part];
    return html`<details>
      <summary><h3>${words.inside}</h3><span>${words.insideAbout}</span></summary>
      <p class="about">${words.insideLead}</p>
      <button
        class="button outlined"
        type="button"
        aria-pressed=${open ? "true" : "false"}
        @click=${() => designer.apply(toggleInside(designer.state))}
      >
        ${words.lookInside}
      </button>
      ${open ? this.looking(blend, insideDesk(designer)) : nothing}
    </details>`;
  }

  private looking(blend: Blend, desk: InsideDesk) {
    const { look, seen, problem } = desk;
    const whole = uncut(blend);
    const labels = words.insideAt[isRound(blend) ? "round" : "square"];
    return html`
      ${choices(
        words.shown,
        SHOWN.map((value) => ({ value, label: words.showns[value].name, note: words.showns[value].help })),
        look.shown,
        (shown) => desk.set({ shown }),
      )}
      ${
        look.shown === "joined"
          ? nothing
          : look.at.map((value, axis) => {
              const set = (to: number) => {
                const fits = to >= 0 && to <= 1;
                this.wrong = fits ? null : axis;
                if (fits) desk.set({ at: look.at.map((each, at) => (at === axis ? to : each)) as unknown as Triple });
              };
              return html`<pasu-number
          .label=${labels[axis] ?? ""}
          .value=${value}
          .opened=${whole[axis] ?? 1}
          .min=${0}
          .max=${1}
          .step=${STEP}
          .problem=${this.wrong === axis ? words.insideRange : ""}
          @number-change=${(event: NumberChangeEvent) => set(event.value)}
          @number-reset=${() => set(whole[axis] ?? 1)}
        ></pasu-number>`;
            })
      }
      ${choices(
        words.colours,
        INSIDE_MAPS.map((value) => ({
          value,
          label: words.insideMaps[value].name,
          note: words.insideMaps[value].help,
        })),
        look.map,
        (map) => desk.set({ map }),
      )}
      <div class="legend" role="status">
        ${problem ? html`<p class="warn">${refusalWords(problem, this.designer.store.design)}</p>` : seen ? this.legend(seen) : nothing}
      </div>
    `;
  }

  private legend({ blend, look, inside }: Seen) {
    const { map } = look;
    const { low, high } = scaleOfInside(map, inside);
    const [from, middle, to] = [low, (low + high) / 2, high].map(short);
    const [u, v, w] = inside.worstAt.map(short);
    const grey = [blend.start, blend.end].some(({ form }) => form === "disc-in-square");
    if (inside.holds) return html`<p>${words.insideHolds(short(Math.max(inside.worst, inside.greatest)))}</p>`;
    const worst = words.insideWorst[map](short(inside.worst), words.insidePlace(u ?? "", v ?? "", w ?? ""));
    return html`
      ${rampLegend(words.insideColours(words.insideMaps[map].name, from ?? "", to ?? ""), [
        `${inside.least < low ? "≤ " : ""}${from}`,
        middle ?? "",
        `${inside.greatest > high ? "≥ " : ""}${to}`,
      ])}
      <p>${words.insideHere(short(inside.least), short(inside.greatest))} ${worst}</p>
      ${
        map === "residual"
          ? nothing
          : html`<p class=${inside.folded ? "warn" : ""}>${inside.folded ? words.insideFolded : words.insideSound}</p>`
      }
      ${grey ? html`<p>${words.insideGrey}</p>` : nothing}
    `;
  }

  override updated(): void {
    const { seen } = insideDesk(this.designer);
    if (seen) colourRamp(this, scaleOfInside(seen.look.map, seen.inside).ramp);
  }

  static override readonly styles = [
    base,
    buttons,
    choiceStyles,
    disclosure,
    rampStyles,
    css`
      :host {
        display: block;
      }
      details {
        border-top: 1px solid var(--line);
        padding-bottom: 8px;
      }
      .about {
        padding-bottom: 10px;
      }
      .about,
      .legend {
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
      .legend {
        padding-top: 14px;
      }
      .legend p {
        padding-top: 4px;
      }
      .warn {
        color: var(--warn);
      }
    `,
  ];
}

/** Few digits: these are colours. */
function short(value: number): string {
  return formatNumber(Number(value.toPrecision(DIGITS)));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-blend-inside": PasuBlendInside;
  }
}
