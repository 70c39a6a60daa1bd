/** Second, mixed and fourth order: what each can and cannot do, switching the open design, and seeing two side by side. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { convertible, LOSS_WORDS, ORDER_KINDS, ORDER_NOTES } from "../../document/orders";
import { asSentence } from "../../document/report-words";
import { familyOf } from "../../document/schema";
import type { Conversion, OrderKind, Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { compareWith } from "../../state/actions";
import { switchOrder } from "../../state/shape-actions";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";

interface Known {
  readonly of: Shape;
  readonly converted: ReadonlyMap<OrderKind, Conversion>;
}

@customElement("pasu-orders")
export class PasuOrders extends DesignerElement {
  /** The shape in the orders that it can be switched to, as far as the solver has answered. */
  @state() private known: Known | null = null;
  private asked: Shape | null = null;

  override willUpdate(): void {
    const { design, part } = this.designer.store;
    const shape = design.parts[part]?.shape ?? null;
    if (shape === this.asked) return;
    this.asked = shape;
    if (shape && convertible(shape.kind)) void this.ask(shape);
  }

  /** What is left behind of the shape in each order. What the solver refuses is said when it is asked for. */
  private async ask(shape: Shape): Promise<void> {
    const others = ORDER_KINDS.filter((kind) => kind !== shape.kind);
    const { solver } = this.designer;
    const outcomes = await Promise.all(others.map((kind) => solver.convert(`to ${kind}`, shape, kind)));
    if (this.asked !== shape) return;
    const converted = others.flatMap((kind, index) => {
      const outcome = outcomes[index];
      return outcome?.state === "done" ? [[kind, outcome.value] as const] : [];
    });
    this.known = { of: shape, converted: new Map(converted) };
  }

  private async switchTo(shape: Shape, kind: OrderKind): Promise<void> {
    const { designer } = this;
    const outcome = await designer.solver.convert("switch", shape, kind);
    if (outcome.state === "superseded") return;
    if (outcome.state === "refused") {
      designer.notices.say(`Not switched. ${asSentence(outcome.refusal.message)}`);
      return;
    }
    const { state } = designer;
    if (state.design.parts[state.part]?.shape === shape) designer.apply(switchOrder(state, outcome.value.shape));
  }

  override render() {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    if (!shape) return nothing;
    if (shape.kind === "boundary-value") {
      return html`<p class="lead">
        This pot is made of free boundary data: the order of each direction is set with its modes, under Shape. Only the named families can be
        switched as a whole.
      </p>`;
    }
    return html`
      <p class="lead">
        The order of the equation decides how much of a wall can be chosen. Switching keeps the rim, the foot and the height, and undo brings the
        old wall back.
      </p>
      ${this.problem()}
      ${ORDER_KINDS.map((kind) => this.card(shape, kind))}
    `;
  }

  private problem() {
    const problem = this.designer.comparison.problem;
    return problem
      ? html`<p class="problem" role="status">${icon("warn")}<span>${problem.message}</span></p>`
      : nothing;
  }

  private card(shape: Shape, kind: OrderKind) {
    const { designer } = this;
    const here = shape.kind === kind;
    const compared = designer.store.session.compare === kind;
    const note = ORDER_NOTES[kind];
    const lost = this.known?.of === shape ? (this.known.converted.get(kind)?.lost ?? []) : [];
    return html`<section aria-labelledby=${kind} class=${here ? "here" : ""}>
      <header>
        <h3 id=${kind}>${note.title}</h3>
        ${here ? html`<span class="tag">This pot</span>` : nothing}
      </header>
      <p class="source">${familyOf(kind)?.source}</p>
      <ul>
        ${note.can.map((text) => html`<li>${icon("check")}<span>${text}</span></li>`)}
        ${note.cannot.map((text) => html`<li class="cannot">${icon("close")}<span><span class="spoken">Not: </span>${text}</span></li>`)}
      </ul>
      ${lost.length === 0 ? nothing : html`<p class="lost">If you switch: ${lost.map((loss) => LOSS_WORDS[loss]).join(" ")}</p>`}
      ${
        here
          ? nothing
          : html`<div class="choices">
              <button
                class="button outlined"
                type="button"
                aria-pressed=${compared ? "true" : "false"}
                @click=${() => designer.apply(compareWith(compared ? null : kind))}
              >
                <span>${compared ? "Stop comparing" : "Show side by side"}<span class="spoken"> with ${note.title}</span></span>
              </button>
              <button class="button outlined" type="button" @click=${() => this.switchTo(shape, kind)}>
                <span>Switch<span class="spoken"> to ${note.title}</span></span>
              </button>
            </div>`
      }
    </section>`;
  }

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        display: grid;
        gap: 12px;
      }
      .lead {
        color: var(--soft);
        text-wrap: pretty;
      }
      section {
        padding: 14px 16px;
        border: 1px solid var(--line);
        border-radius: 14px;
      }
      .here {
        border-color: var(--accent);
        box-shadow: inset 0 0 0 1px var(--accent);
      }
      header {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      h3 {
        font-size: 1.02rem;
        font-weight: 650;
      }
      .tag {
        padding: 1px 9px;
        border-radius: 20px;
        background: var(--accent-wash);
        color: var(--accent-strong);
        font-size: 0.82rem;
      }
      .source {
        color: var(--soft);
        font-size: 0.84rem;
      }
      ul {
        display: grid;
        gap: 4px;
        padding: 10px 0;
      }
      li {
        display: flex;
        gap: 8px;
      }
      li .icon {
        width: 17px;
        height: 17px;
        margin-top: 3px;
        color: var(--accent);
      }
      .cannot {
        color: var(--soft);
      }
      .cannot .icon {
        color: var(--edge);
      }
      .lost {
        padding-bottom: 10px;
        color: var(--warn);
        font-size: 0.9rem;
      }
      .choices {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
      }
      .problem {
        display: flex;
        gap: 8px;
        color: var(--warn);
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-orders": PasuOrders;
  }
}
