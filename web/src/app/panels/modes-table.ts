/** Free boundary data: for each component its equation and the modes of its edges, to add to, edit and remove. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import {
  AXES,
  type Axis,
  datumNames,
  datumPath,
  MAX_MODES,
  withForce,
  withMode,
  withOrder,
  withoutMode,
} from "../../document/boundary-value";
import { numberAt, type Path } from "../../document/path";
import type { BoundaryValue, Mode, Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber, parseNumber } from "../../number";
import { editShape } from "../../state/shape-actions";
import { cells } from "../../ui/cells";
import { icon } from "../../ui/icons";
import { base, buttons, disclosure, fields, pointed } from "../../ui/styles";
import { modes } from "../../words/english/modes";
import { numberProblemWords } from "../../words/typed";
import { shapeNumber } from "./shape-number";

const WAVES = ["cos", "sin"] as const;
/** Long series (an imported outline) are shown page by page. */
const PAGE = 24;

@customElement("pasu-modes")
export class PasuModes extends DesignerElement {
  @state() private shownModes: Readonly<Record<Axis, number>> = { x: PAGE, y: PAGE, z: PAGE };
  @state() private forceProblem: { readonly key: string; readonly message: string } | null = null;

  override render() {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    if (shape?.kind !== "boundary-value") return nothing;
    return html`
      <p class="intro">
        <strong>${modes.lead}</strong> ${AXES.some((axis) => shape[axis].order === 4) ? modes.wavesAndSlopes : modes.waves}
      </p>
      ${shape.rings === undefined || shape.rings.length === 0 ? nothing : html`<p class="intro">${modes.rings(shape.rings.length)}</p>`}
      ${this.span(shape)} ${AXES.map((axis) => this.component(shape, axis))}
    `;
  }

  private span(shape: BoundaryValue) {
    const round = shape.span === "2pi";
    return html`<div class="line">
      <label>
        <span>${modes.span}</span>
        <select
          class="field"
          @change=${(event: Event) => {
            const full = (event.target as HTMLSelectElement).value === "2pi";
            this.edit((now) => ({ ...now, span: full ? "2pi" : 1 }));
          }}
        >
          <option value="2pi" .selected=${round}>2π</option>
          <option value="number" .selected=${!round}>${modes.aNumber}</option>
        </select>
      </label>
      ${round ? nothing : this.number(modes.spanNumber, ["span"], Number(shape.span))}
    </div>`;
  }

  private component(shape: BoundaryValue, axis: Axis) {
    const component = shape[axis];
    const shown = this.shownModes[axis];
    const hidden = component.modes.length - shown;
    return html`<details open>
      <summary><h3>${modes.axes[axis]}</h3><span>${modes.summary(component.order, component.modes.length)}</span></summary>
      <div class="equation">
        <label>
          <span>${modes.order}</span>
          <select
            class="field"
            aria-label=${modes.orderOf(axis)}
            @change=${(event: Event) => {
              const order = (event.target as HTMLSelectElement).value === "4" ? 4 : 2;
              this.edit((now) => withOrder(now, axis, order));
            }}
          >
            <option value="2" .selected=${component.order === 2}>2</option>
            <option value="4" .selected=${component.order === 4}>4</option>
          </select>
        </label>
        ${(["s", "t", ...(component.order === 4 ? ["w"] : [])] as const).map(
          (name) =>
            html`<span class="cell"><span aria-hidden="true">${name}</span>${this.number(modes.weightOf(name, axis), [axis, name], numberAt(component, [name], 0))}</span>`,
        )}
      </div>
      <ol>
        ${component.modes.slice(0, shown).map((mode, index) => this.mode(shape, axis, mode, index))}
      </ol>
      ${
        hidden > 0
          ? html`<button
              class="button outlined"
              type="button"
              @click=${() => {
                this.shownModes = { ...this.shownModes, [axis]: shown + PAGE };
              }}
            >
              ${modes.showMore(Math.min(hidden, PAGE), hidden)}
            </button>`
          : nothing
      }
      <button
        class="button outlined"
        type="button"
        ?disabled=${component.modes.length >= MAX_MODES}
        @click=${() => {
          this.edit((now) => withMode(now, axis));
          this.shownModes = { ...this.shownModes, [axis]: Math.max(shown, component.modes.length + 1) };
        }}
      >
        ${icon("add")}<span>${modes.add(axis)}</span>
      </button>
    </details>`;
  }

  private mode(shape: BoundaryValue, axis: Axis, mode: Mode, index: number) {
    return html`<li>
      <div class="head">
        <span class="cell"><span aria-hidden="true">n</span>${this.number(modes.frequency(index + 1, axis), [axis, "modes", index, "n"], mode.n)}</span>
        <button
          class="button bare"
          type="button"
          aria-label=${modes.removeMode(index + 1, axis)}
          title=${modes.remove}
          @click=${() => this.edit((now) => withoutMode(now, axis, index))}
        >
          ${icon("close")}
        </button>
      </div>
      ${WAVES.filter((wave) => wave === "cos" || mode.n !== 0).map(
        (wave) => html`<fieldset>
          <legend>${mode.n === 0 ? modes.constant : modes[wave]}</legend>
          ${datumNames(shape[axis]).map((name) => {
            const label = modes.datumOf(modes.data[name], wave, formatNumber(mode.n), axis);
            return html`<span class="cell"
              ><span aria-hidden="true">${modes.data[name]}</span>${this.number(
                label,
                datumPath(axis, index, wave, name),
                numberAt(mode, [wave, name], 0),
              )}</span
            >`;
          })}
          ${this.force(axis, mode, index, wave)}
        </fieldset>`,
      )}
    </li>`;
  }

  private force(axis: Axis, mode: Mode, index: number, wave: "cos" | "sin") {
    const key = `${axis}-${index}-${wave}`;
    const problem = this.forceProblem?.key === key ? this.forceProblem.message : "";
    const text = (mode[wave]?.force ?? []).map((value) => formatNumber(value)).join("; ");
    return html`<label class="cell wide">
      <span>${modes.force}</span>
      <input
        class="field"
        type="text"
        autocomplete="off"
        spellcheck="false"
        aria-label=${modes.forceOf(wave, formatNumber(mode.n), axis)}
        aria-invalid=${problem === "" ? "false" : "true"}
        aria-describedby=${problem === "" ? nothing : `problem-${key}`}
        .value=${text}
        @change=${(event: Event) => this.typedForce(key, axis, index, wave, (event.target as HTMLInputElement).value)}
      />
      ${problem === "" ? nothing : html`<span id="problem-${key}" class="problem">${problem}</span>`}
    </label>`;
  }

  private typedForce(key: string, axis: Axis, index: number, wave: "cos" | "sin", text: string): void {
    const force: number[] = [];
    for (const piece of text.split(";").filter((each) => each.trim() !== "")) {
      const typed = parseNumber(piece);
      if ("problem" in typed) {
        this.forceProblem = { key, message: numberProblemWords(typed.problem) };
        return;
      }
      force.push(typed.value);
    }
    this.forceProblem = null;
    this.edit((now) => withForce(now, axis, index, wave, force));
  }

  private number(label: string, path: Path, value: number) {
    return shapeNumber(this.designer, label, path, value, this.problemAt(path));
  }

  private edit(change: (shape: BoundaryValue) => BoundaryValue): void {
    this.designer.apply(
      editShape(this.designer.state, (shape: Shape) => (shape.kind === "boundary-value" ? change(shape) : shape)),
    );
  }

  static override readonly styles = [
    base,
    buttons,
    cells,
    disclosure,
    fields,
    pointed,
    css`
      :host {
        display: block;
      }
      .intro {
        padding-bottom: 8px;
        color: var(--soft);
      }
      .intro strong {
        color: var(--ink);
      }
      .line,
      .equation {
        display: grid;
        grid-template-columns: repeat(4, minmax(0, 1fr));
        gap: 8px;
        align-items: end;
        padding: 4px 0 8px;
      }
      .line {
        grid-template-columns: 1fr 1fr;
      }
      label {
        display: grid;
        gap: 3px;
        min-width: 0;
        color: var(--soft);
        font-size: 0.82rem;
      }
      .line pasu-number {
        padding: 0;
      }
      .field {
        width: 100%;
        font-size: 0.94rem;
        border-color: var(--line);
      }
      details {
        border-top: 1px solid var(--line);
        padding: 4px 0 12px;
      }
      ol {
        display: grid;
        gap: 10px;
        margin: 0 0 10px;
        padding: 0;
        list-style: none;
      }
      li {
        padding: 8px 12px 12px;
        border-radius: 12px;
        background: var(--well);
      }
      .head {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      .head .cell {
        grid-template-columns: auto 96px;
        align-items: center;
        gap: 8px;
        font: italic 1rem var(--font-brand);
      }
      .head pasu-number {
        font: 0.94rem var(--font);
      }
      fieldset {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 6px 8px;
        margin: 4px 0 0;
        padding: 0;
        border: 0;
        min-width: 0;
      }
      legend {
        padding: 4px 0;
        font-size: 0.86rem;
        font-weight: 600;
      }
      .wide {
        grid-column: 1 / -1;
      }
      .problem {
        color: var(--warn);
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-modes": PasuModes;
  }
}
