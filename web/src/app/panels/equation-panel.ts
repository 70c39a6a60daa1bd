/** The equation of the selected part beside its numbers: the differential equation, what is given at the edges, the closed form, and the orders that it can be switched to. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { pathText } from "../../document/path";
import type { Group } from "../../document/schema";
import { familyOf } from "../../document/schema";
import type { Part, TwoSided } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { type Closed, closed, type Solved } from "../../equation/closed";
import { differential } from "../../equation/differential";
import { type Edge, edges } from "../../equation/edges";
import { latexOf } from "../../equation/latex";
import { problemOf } from "../../equation/posed";
import type { Problem } from "../../equation/problem";
import type { Formula, Hand } from "../../equation/writer";
import { decimal } from "../../language";
import { formatNumber } from "../../number";
import { icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { equation } from "../../words/english/equation";
import { numbersWords, rootsWords } from "../../words/equation";
import { whyWords } from "../../words/refusals";
import { type FormulaChooseEvent, type FormulaPointEvent, PasuFormula } from "./formula";
import "./orders-panel";
import "./parameters";
import "./rings-table";

const DIGITS = 5;
/** Of many waves and rings so many are written until somebody asks for all. */
const FEW = 6;
const MANY = 200;

const OF_EQUATION: readonly Group[] = ["equation", "force"];
const OF_EDGES: readonly Group[] = ["rim", "foot", "height", "wall"];

interface Written {
  readonly shape: TwoSided;
  readonly all: boolean;
  readonly problem: Problem;
  readonly pde: readonly Formula[];
  readonly given: readonly Edge[];
  readonly form: Closed;
}

@customElement("pasu-equation")
export class PasuEquation extends DesignerElement {
  @state() private all = false;
  /** What the browser would not copy. */
  @state() private uncopied: string | null = null;
  @state() private copied = false;
  private copiedOf: TwoSided | null = null;
  private last: Written | null = null;
  @query(".latex") private readonly latex!: HTMLTextAreaElement | null;

  /** At most once a frame, however fast the hand is. */
  protected override async scheduleUpdate(): Promise<void> {
    if (this.hasUpdated) await new Promise((next) => requestAnimationFrame(next));
    super.scheduleUpdate();
  }

  private get shape(): TwoSided | null {
    const shape = this.selected?.shape;
    return shape && shape.kind !== "vertex-frame" && shape.kind !== "blend" && shape.kind !== "octant" ? shape : null;
  }

  /** What is said of a shape that is no surface between two ends. */
  private without() {
    const kind = this.selected?.shape.kind;
    if (kind === undefined) return nothing;
    if (kind === "octant") return html`<p class="lead">${equation.octant}</p>`;
    return html`<p class="lead">${kind === "blend" ? equation.blend : equation.network}</p>`;
  }

  private get selected(): Part | null {
    const { design, part } = this.designer.state;
    return design.parts[part] ?? null;
  }

  override render() {
    const { shape } = this;
    if (!shape) return this.without();
    const { pde, given, problem } = this.written(shape);
    return html`
      <div
        @formula-point=${this.point}
        @formula-choose=${this.choose}
        @pointerover=${this.touch}
        @pointerleave=${this.leave}
        @focusin=${this.touch}
        @focusout=${this.leave}
      >
        <p class="lead">${equation.lead}</p>
        <div class="tools">
          <button class="button outlined" type="button" @click=${this.copy}>
            ${icon(this.copied ? "check" : "copy")}<span>${this.copied ? equation.copied : equation.copy}</span>
          </button>
          <p class="note">${equation.digits(DIGITS)}</p>
        </div>
        ${this.fallback()}
        <section aria-labelledby="pde">
          <h3 id="pde">${equation.pde}</h3>
          <p class="note">${equation.pdeLead}</p>
          ${pde.map((each) => this.formula(each, equation.formulas.pde))}
          ${this.numbers(shape, OF_EQUATION)}
        </section>
        <section aria-labelledby="edges">
          <h3 id="edges">${equation.edges}</h3>
          <p class="note">${equation.edgesLead}${problem.rings.length === 0 ? nothing : html` ${equation.ringsLead}`}</p>
          ${given.map((edge) => this.edge(problem, edge))}
          ${this.more(problem.rings.length + 2 - given.length, problem.rings.length)}
          ${familyOf(shape.kind) ? this.numbers(shape, OF_EDGES) : this.table(shape)}
        </section>
        <section aria-labelledby="closed">
          <h3 id="closed">${equation.closed}</h3>
          ${this.closedForm(shape)}
        </section>
        <section aria-labelledby="order">
          <h3 id="order">${equation.order}</h3>
          <pasu-orders .designer=${this.designer}></pasu-orders>
        </section>
      </div>
      ${this.help(shape)}
    `;
  }

  private formula(formula: Formula, label: string) {
    return html`<pasu-formula
      .formula=${formula}
      .label=${label}
      .pointed=${this.designer.pointed.places}
    ></pasu-formula>`;
  }

  /** The fields of a family that stand in the formulas above them. */
  private numbers(shape: TwoSided, groups: readonly Group[]) {
    const family = familyOf(shape.kind);
    if (!family?.fields.some(({ group }) => groups.includes(group))) return nothing;
    return html`<pasu-parameters .designer=${this.designer} .groups=${groups}></pasu-parameters>`;
  }

  /** The numbers of rings and of modes as they stand in the formulas; what a potter calls them is elsewhere. */
  private table({ kind }: TwoSided) {
    const { designer } = this;
    return html`<details open>
      <summary>${equation.numbers}</summary>
      ${kind === "rings" ? html`<pasu-rings .designer=${designer}></pasu-rings>` : html`<pasu-parameters .designer=${designer}></pasu-parameters>`}
    </details>`;
  }

  private edge({ hoops }: Problem, { place, u, sharp, formula }: Edge) {
    const number = formatNumber(u.value, DIGITS);
    const inner = sharp ? equation.atSharp : equation.at;
    const named = !hoops ? inner : place === "start" ? equation.foot : place === "end" ? equation.rim : inner;
    const name = named(number);
    return html`<h4>${name}</h4>${this.formula(formula, name)}`;
  }

  /** All that is written of a shape; while something is only pointed at it stays what it is. */
  private written(shape: TwoSided): Written {
    const { all } = this;
    if (this.last?.shape !== shape || this.last.all !== all) {
      const hand: Hand = { digits: DIGITS, decimal: decimal(0.5, 1).charAt(1), marked: true, most: all ? MANY : FEW };
      const problem = problemOf(shape);
      const pde = differential(problem, hand);
      this.last = { shape, all, problem, pde, given: edges(problem, hand), form: closed(problem, hand) };
    }
    return this.last;
  }

  private closedForm(shape: TwoSided) {
    const { problem: refused } = this.designer.surface;
    // What is refused of another part, or of the wall, leaves this equation as it is.
    if (refused?.path.startsWith(pathText(["parts", this.designer.state.part, "shape"])))
      return html`<p class="problem">${icon("warn")}<span>${equation.unsolved(whyWords(refused))}</span></p>`;
    const { form } = this.written(shape);
    return html`
      <p class="note">${equation.closedLead}</p>
      ${form.sums.map((each, index) => this.formula(each, equation.formulas.sum("xyz".charAt(index))))}
      <ol>
        ${form.solved.map((each) => this.mode(each))}
      </ol>
      ${this.more(form.hidden, form.solved.length)}
      ${
        form.systems.length === 0
          ? nothing
          : html`<h4>${equation.where}</h4>
            <p class="note">${equation.whereLead}</p>
            ${form.systems.map((each) => this.formula(each, equation.formulas.system))}`
      }
    `;
  }

  private mode({ index, roots, formula, open }: Solved) {
    return html`<li>
      ${this.formula(formula, equation.formulas.mode(index))}
      <p class="roots">${rootsWords(roots, DIGITS)}${open ? html` ${equation.open}` : nothing}</p>
    </li>`;
  }

  /** Where not all of something is written, or was not before somebody asked. */
  private more(hidden: number, shown: number) {
    if (hidden === 0 && !(this.all && shown > FEW)) return nothing;
    return html`<button
      class="button outlined"
      type="button"
      aria-expanded=${this.all ? "true" : "false"}
      @click=${() => {
        this.all = !this.all;
      }}
    >
      ${this.all ? equation.fewer : equation.more(hidden)}
    </button>`;
  }

  /** What is pointed at, at the foot of the panel, and for whoever hears it. */
  private help(shape: TwoSided) {
    const { places } = this.designer.pointed;
    const words = places.length === 0 ? "" : numbersWords(shape, places);
    return html`<p class="help" role="status" ?data-empty=${words === ""}>${words}</p>`;
  }

  private readonly point = ({ places }: FormulaPointEvent): void => {
    const { pointed } = this.designer;
    if (places.length > 0) pointed.point("formula", places);
    else pointed.leave("formula");
  };

  /** The hand or the focus is at a field, or at something else. */
  private readonly touch = (event: Event): void => {
    const { pointed } = this.designer;
    for (const each of event.composedPath()) {
      if (each instanceof PasuFormula) return;
      if (each instanceof HTMLElement && each.dataset.at !== undefined) {
        pointed.point("field", each.dataset.at.split(" "));
        return;
      }
    }
    pointed.leave("field");
  };

  private readonly leave = (): void => this.designer.pointed.leave("field");

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.leave();
    this.designer.pointed.leave("formula");
  }

  private get fields(): HTMLElement[] {
    return [...this.renderRoot.querySelectorAll("pasu-parameters, pasu-rings")].flatMap((table) => fieldsIn(table));
  }

  override updated(): void {
    const places = this.designer.pointed.elsewhere("field");
    for (const each of this.fields) {
      const at = each.dataset.at?.split(" ") ?? [];
      each.toggleAttribute(
        "data-pointed",
        places.some((place) => at.includes(place)),
      );
    }
  }

  /** Goes to the field of a number: the first of those that it is made of that has one. */
  private readonly choose = ({ places }: FormulaChooseEvent): void => {
    const { fields: all } = this;
    const found = places.flatMap((place) => all.filter((each) => each.dataset.at?.split(" ").includes(place)));
    found[0]?.focus();
  };

  private readonly copy = async (): Promise<void> => {
    const { shape } = this;
    if (!shape) return;
    const text = latexOf(shape, equation);
    try {
      await navigator.clipboard.writeText(text);
      this.copied = true;
      this.uncopied = null;
      this.designer.notices.say(equation.copied);
    } catch {
      this.uncopied = text;
      await this.updateComplete;
      this.latex?.select();
    }
  };

  override willUpdate(): void {
    // It is of another pot, or of this one as it was.
    if (this.shape !== this.copiedOf) {
      this.copiedOf = this.shape;
      this.copied = false;
      this.uncopied = null;
    }
  }

  private fallback() {
    if (this.uncopied === null) return nothing;
    return html`<label class="uncopied"
      ><span>${equation.notCopied}</span
      ><textarea class="field latex" rows="5" readonly aria-label=${equation.latex} .value=${this.uncopied}></textarea
    ></label>`;
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      :host {
        display: block;
      }
      .lead,
      .note {
        color: var(--soft);
        text-wrap: pretty;
      }
      .note {
        font-size: 0.88rem;
      }
      .tools {
        display: flex;
        align-items: center;
        flex-wrap: wrap;
        gap: 8px 12px;
        padding: 10px 0 4px;
      }
      .tools .note {
        flex: 1 1 12rem;
      }
      section {
        padding: 12px 0 6px;
        border-top: 1px solid var(--line);
      }
      section:first-of-type {
        margin-top: 8px;
      }
      h3 {
        font-size: 1.02rem;
        font-weight: 650;
      }
      h4 {
        padding-top: 8px;
        font-size: 0.9rem;
        font-weight: 600;
      }
      ol {
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        padding: 2px 0 8px;
      }
      .roots {
        padding: 0 4px;
        color: var(--soft);
        font-size: 0.86rem;
      }
      summary {
        min-height: var(--touch);
        align-content: center;
        font-weight: 600;
        cursor: pointer;
      }
      .problem {
        display: flex;
        gap: 8px;
        color: var(--warn);
      }
      .uncopied {
        display: grid;
        gap: 4px;
      }
      .latex {
        width: 100%;
        font-family: ui-monospace, monospace;
        font-size: 0.82rem;
      }
      .help {
        position: sticky;
        z-index: 2;
        bottom: 0;
        margin: 8px -6px 0;
        padding: 8px 12px;
        border: 1px solid var(--accent);
        border-radius: 10px;
        background: var(--sheet);
        box-shadow: 0 3px 14px var(--shadow);
        pointer-events: none;
      }
      .help[data-empty] {
        visibility: hidden;
      }
    `,
  ];
}

/** Everything in there that can be pointed at, in what it holds too. */
function fieldsIn(element: Element): HTMLElement[] {
  const root = element.shadowRoot;
  if (!root) return [];
  const own = [...root.querySelectorAll<HTMLElement>("[data-at]")];
  return [...own, ...[...root.querySelectorAll("pasu-modes")].flatMap(fieldsIn)];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-equation": PasuEquation;
  }
}
