/** The two sections of a blend, the upper one first: each a card with its drawing and its numbers. Below them how the equation is solved. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { agreed, clashOf, type Remedy, remediesOf } from "../../document/blend/agreement";
import { COUNTS, figureOf, type Ornament, restOf } from "../../document/blend/figure";
import {
  ENDS,
  type End,
  FORMS,
  type Form,
  isClosed,
  numberOf,
  reachOf,
  refigured,
  reformed,
  type SectionKey,
  sizeFactor,
  withNumber,
} from "../../document/blend/section";
import { SECTION } from "../../document/blend/tables.gen";
import { unitOf } from "../../document/look";
import { type Path, pathText } from "../../document/path";
import type { Blend, Section } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { toggleExplain } from "../../state/actions";
import { changeBlend, changeSection } from "../../state/blend-actions";
import { cells } from "../../ui/cells";
import "../../ui/number-field";
import { intro } from "../../ui/intro";
import type { NumberChangeEvent, NumberResetEvent } from "../../ui/number-field";
import { base, buttons, fields, pointed } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { page } from "../../words/english/page";
import { lengthWords } from "../../words/quantities";
import { whyWords } from "../../words/refusals";
import { drawingStyles, sectionDrawing } from "../drawing/section-drawing";
import "./blend-inside";
import "./blend-solving";
import { explainButton } from "./explain-button";

const DEGREES = 180;
/** What petals are drawn to, in percent of the radius. */
const DEEPEST = 50;

@customElement("pasu-blend-cards")
export class PasuBlendCards extends DesignerElement {
  /** The section that is being drawn. */
  @state() private drawing: { readonly end: End; readonly name: string } | null = null;
  /** How many there were and how they were turned where corners and petals have gone to nothing, by part and end. */
  private readonly remembered = new Map<string, Ornament>();

  override render() {
    const { design, part } = this.designer.state;
    const blend = design.parts[part]?.shape;
    if (blend?.kind !== "blend") return nothing;
    // The ranges go by the blend that was opened: no number moves the range of another.
    const origin = this.originOf(blend);
    const factor = sizeFactor(origin);
    const upper: End = blend.start.z > blend.end.z ? "start" : "end";
    const reach = Math.max(...ENDS.map((end) => reachOf(blend[end])));
    const order: readonly End[] = [upper, upper === "start" ? "end" : "start"];
    return html`
      <div class="intro">
        <p><strong>${words.lead}</strong> ${words.about}</p>
        ${explainButton(this.designer.store.session.explain, () => this.designer.apply(toggleExplain(this.designer.state)))}
      </div>
      ${this.clash(blend)}
      <ol>
        ${order.map((end) => this.card(blend, origin, end, end === upper ? "upper" : "lower", factor, reach))}
      </ol>
      <pasu-blend-solving .designer=${this.designer}></pasu-blend-solving>
      <pasu-blend-inside .designer=${this.designer}></pasu-blend-inside>
      ${
        this.drawing
          ? html`<pasu-section-dialog
              .designer=${this.designer}
              .end=${this.drawing.end}
              .name=${this.drawing.name}
              @section-closed=${() => {
                this.drawing = null;
              }}
            ></pasu-section-dialog>`
          : nothing
      }
    `;
  }

  /** Said as soon as it is so, not only when it is to be made. */
  private clash(blend: Blend) {
    const clash = clashOf(blend);
    const agree = (remedy: Remedy) =>
      this.designer.apply(changeBlend(this.designer.state, (each) => agreed(each, remedy)));
    return html`<div class="clash" role="status" ?hidden=${clash === null}>
      ${
        clash === null
          ? nothing
          : html`<p>${words.clashes[clash]}</p>
            ${remediesOf(blend).map(
              (remedy) =>
                html`<button class="button outlined" type="button" @click=${() => agree(remedy)}>${words.remedies[clash][remedy]}</button>`,
            )}`
      }
    </div>`;
  }

  private async openDrawing(end: End, name: string): Promise<void> {
    try {
      await import("../drawing/section-dialog");
      this.drawing = { end, name };
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  }

  private originOf(blend: Blend): Blend {
    const { origin, state } = this.designer;
    const opened = origin.design.parts[state.part]?.shape;
    return opened?.kind === "blend" ? opened : blend;
  }

  private card(blend: Blend, origin: Blend, end: End, which: "upper" | "lower", factor: number, reach: number) {
    const [name, short] = [words[which], words.short[which]];
    const section = blend[end];
    const other = blend[end === "start" ? "end" : "start"];
    const { form } = section;
    return html`<li data-end=${end}>
      <div class="head">
        <div>
          <h3>${name}</h3>
          <label>
            <span class="spoken">${words.of(words.form, name)}</span>
            <select
              class="field"
              .value=${form}
              @change=${(event: Event) => this.change(end, (each) => reformed(each, (event.target as HTMLSelectElement).value as Form))}
            >
              ${FORMS.map((each) => html`<option value=${each} .selected=${each === form}>${words.forms[each]}</option>`)}
            </select>
          </label>
          <button class="button outlined draw" type="button" aria-label=${words.drawItOf(name)} @click=${() => void this.openDrawing(end, name)}>
            ${words.drawIt}
          </button>
          ${this.problem(this.problemWithin([end]))}
        </div>
        <div class="drawing">${sectionDrawing(section, other, reach, this.drawn(section))}</div>
      </div>
      ${SECTION.map((field) => this.number(field, section, origin[end], end, short, factor))}
      ${
        isClosed(form)
          ? this.figure(section, origin[end], end, short)
          : html`<div class="offer">
              <p>${words.asOutlineAbout}</p>
              <button class="button outlined" type="button" @click=${() => this.change(end, (each) => reformed(each, "outline"))}>
                ${words.asOutline}
              </button>
            </div>`
      }
    </li>`;
  }

  private drawn(section: Section): string {
    const unit = unitOf(this.designer.store.design);
    const [width, depth] = (["radius-0", "radius-1"] as const).map((key) =>
      lengthWords(2 * numberOf(section, key), unit),
    );
    return words.drawing(words.forms[section.form], width ?? "", depth ?? "");
  }

  private number(
    field: (typeof SECTION)[number],
    section: Section,
    opened: Section,
    end: End,
    name: string,
    factor: number,
  ) {
    const { designer } = this;
    const { key } = field;
    const told = words.fields[key];
    const size = field.dimension === "length" ? factor : 1;
    return html`<pasu-number
      data-field="${end}-${key}"
      data-at=${pathText([end, ...field.path])}
      .label=${told.name}
      .qualifier=${name}
      .symbol=${field.symbol}
      .unit=${field.dimension === "length" ? unitOf(designer.store.design) : ""}
      .help=${told.help}
      .explain=${designer.store.session.explain}
      .problem=${this.problemAt([end, ...field.path])}
      .value=${numberOf(section, key)}
      .opened=${numberOf(opened, key)}
      .min=${size * field.min}
      .max=${size * field.max}
      .step=${size * field.step}
      @number-change=${({ value, gesture }: NumberChangeEvent) => this.set(end, key, value, gesture)}
      @number-done=${() => designer.store.endGesture()}
      @number-cancel=${() => designer.store.cancelGesture()}
      @number-reset=${(_: NumberResetEvent) => this.set(end, key, numberOf(opened, key), false)}
    ></pasu-number>`;
  }

  private set(end: End, key: SectionKey, value: number, gesture: boolean): void {
    this.change(end, (section) => withNumber(section, key, value), gesture ? key : undefined);
  }

  /** What a closed section is beside its size: turned, with corners, with petals. */
  private figure(section: Section, opened: Section, end: End, name: string) {
    const { designer } = this;
    const isOutline = section.form === "outline";
    const turn = isOutline ? figureOf(section).turn : 0;
    const before = opened.form === "outline" ? figureOf(opened).turn : 0;
    const set = (value: number, gesture: boolean) =>
      this.change(end, (each) => refigured(each, { turn: value }), gesture ? "turn" : undefined);
    const rest = isOutline ? restOf(section) : 0;
    return html`<pasu-number
        data-field="${end}-turn"
        .label=${words.turn}
        .qualifier=${name}
        .unit=${words.degree}
        .help=${words.turnHelp}
        .explain=${designer.store.session.explain}
        .value=${turn}
        .opened=${before}
        .min=${-DEGREES}
        .max=${DEGREES}
        .step=${1}
        @number-change=${({ value, gesture }: NumberChangeEvent) => set(value, gesture)}
        @number-done=${() => designer.store.endGesture()}
        @number-cancel=${() => designer.store.cancelGesture()}
        @number-reset=${() => set(before, false)}
      ></pasu-number>
      ${rest > 0 ? html`<p class="rest">${words.rest(rest)}</p>` : this.ornament(section, end, name)}`;
  }

  private ornament(section: Section, end: End, name: string) {
    const found = section.form === "outline" ? figureOf(section).ornament : null;
    const isPlain = found === null || (found.petals === 0 && found.corners === 0);
    const key = `${this.designer.store.ids[this.designer.store.part] ?? 0} ${end}`;
    const before = this.remembered.get(key) ?? found;
    const ornament: Ornament = isPlain ? { count: COUNTS[0] + 1, turn: 0, ...before, petals: 0, corners: 0 } : found;
    const set = (change: Partial<Ornament>, gesture: boolean) => {
      const next = { ...ornament, ...change };
      this.remembered.set(key, next);
      this.requestUpdate();
      // How many there would be, and how turned, is no change while there are none.
      if (isPlain && next.petals === 0 && next.corners === 0) return;
      this.change(
        end,
        (each) => refigured(each, { ornament: next }),
        gesture ? `ornament ${Object.keys(change).join()}` : undefined,
      );
    };
    const cell = (
      label: string,
      value: number,
      unit: string,
      to: (value: number) => Partial<Ornament>,
      within?: readonly [least: number, most: number],
    ) => html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${words.of(label, name)}
        .unit=${unit}
        .value=${value}
        .step=${1}
        .within=${within}
        .counted=${within === COUNTS}
        @number-change=${(event: NumberChangeEvent) => set(to(event.value), event.gesture)}
        @number-done=${() => this.designer.store.endGesture()}
        @number-cancel=${() => this.designer.store.cancelGesture()}
      ></pasu-number
    ></span>`;
    return html`<div class="ornament" role="group" aria-label=${words.of(words.ornament, name)}>
      ${cell(words.count, ornament.count, "", (count) => ({ count }), COUNTS)}
      ${cell(words.petals, percent(ornament.petals), "%", (value) => ({ petals: value / 100 }), [0, DEEPEST])}
      ${cell(words.corners, percent(ornament.corners), "%", (value) => ({ corners: value / 100 }), [0, 100])}
      ${cell(words.place, ornament.turn, words.degree, (turn) => ({ turn }))}
    </div>`;
  }

  private change(end: End, edit: (section: Section) => Section, key?: string): void {
    this.designer.apply(changeSection(this.designer.state, end, edit, key));
  }

  private problem(text: string) {
    return text === "" ? nothing : html`<p class="problem" role="status">${text}</p>`;
  }

  /** The solver's objection, when it names a section, or what of it has no field. */
  private problemWithin(path: Path): string {
    const { state, surface } = this.designer;
    const { problem } = surface;
    if (!problem) return "";
    const place = pathText(["parts", state.part, "shape", ...path]);
    const isIn =
      problem.path === place || problem.path.startsWith(`${place}.x`) || problem.path.startsWith(`${place}.y`);
    return isIn ? whyWords(problem) : "";
  }

  static override readonly styles = [
    base,
    intro,
    buttons,
    fields,
    pointed,
    cells,
    drawingStyles,
    css`
      :host {
        display: block;
      }
      .clash {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        margin-bottom: 10px;
        padding: 10px 12px;
        border: 1px solid var(--warn);
        border-radius: 12px;
      }
      .clash[hidden] {
        display: none;
      }
      .clash p {
        flex: 1 0 100%;
        font-size: 0.92rem;
        text-wrap: pretty;
      }
      ol {
        display: grid;
        gap: 10px;
        margin: 0 0 10px;
        padding: 0;
        list-style: none;
      }
      li {
        padding: 10px 12px;
        border: 1px solid var(--line);
        border-radius: 12px;
      }
      .head {
        display: grid;
        grid-template-columns: minmax(0, 1fr) 104px;
        gap: 12px;
        align-items: start;
        padding-bottom: 6px;
      }
      h3 {
        padding-bottom: 8px;
        font-size: 0.95rem;
        font-weight: 650;
      }
      select {
        width: 100%;
      }
      .draw {
        width: 100%;
        margin-top: 8px;
      }
      .drawing {
        border-radius: 10px;
        background: var(--well);
      }
      .problem {
        padding-top: 6px;
        color: var(--warn);
        font-size: 0.88rem;
      }
      .ornament {
        display: grid;
        grid-template-columns: repeat(4, minmax(0, 1fr));
        align-items: end;
        gap: 6px 8px;
        padding: 8px 0 4px;
      }
      .rest,
      .offer p {
        padding: 6px 0;
        color: var(--soft);
        font-size: 0.88rem;
        text-wrap: pretty;
      }
    `,
  ];
}

function percent(share: number): number {
  return Number((100 * share).toPrecision(8));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-blend-cards": PasuBlendCards;
  }
}
