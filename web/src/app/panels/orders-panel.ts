/** Second, mixed and fourth order: what each can and cannot do, switching the open design, and seeing two side by side. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { convertible, ORDER_KINDS } from "../../document/orders";
import type { Conversion, OrderKind, Shape } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { compareWith } from "../../state/actions";
import { switchOrder } from "../../state/shape-actions";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";
import { orders } from "../../words/english/orders";
import { parameters } from "../../words/english/parameters";
import { whyWords } from "../../words/refusals";

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
      designer.notices.say(orders.notSwitched(whyWords(outcome.refusal)));
      return;
    }
    const { state } = designer;
    if (state.design.parts[state.part]?.shape === shape) designer.apply(switchOrder(state, outcome.value.shape));
  }

  override render() {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    if (!shape) return nothing;
    if (shape.kind === "boundary-value") return html`<p class="lead">${orders.allFree}</p>`;
    if (shape.kind === "rings") return html`<p class="lead">${orders.rings}</p>`;
    if (shape.kind === "vertex-frame") return html`<p class="lead">${orders.network}</p>`;
    if (shape.kind === "blend") return html`<p class="lead">${orders.blend}</p>`;
    if (shape.kind === "octant") return html`<p class="lead">${orders.octant}</p>`;
    return html`
      <p class="lead">${orders.lead}</p>
      ${this.problem()}
      ${ORDER_KINDS.map((kind) => this.card(shape, kind))}
    `;
  }

  private problem() {
    const problem = this.designer.comparison.problem;
    return problem
      ? html`<p class="problem" role="status">${icon("warn")}<span>${whyWords(problem)}</span></p>`
      : nothing;
  }

  private card(shape: Shape, kind: OrderKind) {
    const { designer } = this;
    const here = shape.kind === kind;
    const compared = designer.store.session.compare === kind;
    const [title, note] = [parameters.kinds[kind], orders.notes[kind]];
    const lost = this.known?.of === shape ? (this.known.converted.get(kind)?.lost ?? []) : [];
    return html`<section aria-labelledby=${kind} class=${here ? "here" : ""}>
      <header>
        <h3 id=${kind}>${title}</h3>
        ${here ? html`<span class="tag">${orders.thisPot}</span>` : nothing}
      </header>
      <p class="source">${parameters.sources[kind]}</p>
      <ul>
        ${note.can.map((text) => html`<li>${icon("check")}<span>${text}</span></li>`)}
        ${note.cannot.map((text) => html`<li class="cannot">${icon("close")}<span><span class="spoken">${orders.not}</span>${text}</span></li>`)}
      </ul>
      ${lost.length === 0 ? nothing : html`<p class="lost">${orders.ifYouSwitch(lost.map((loss) => orders.losses[loss]))}</p>`}
      ${
        here
          ? nothing
          : html`<div class="choices">
              <button
                class="button outlined"
                type="button"
                aria-pressed=${compared ? "true" : "false"}
                aria-label=${compared ? orders.stopWith(title) : orders.compareWith(title)}
                @click=${() => designer.apply(compareWith(compared ? null : kind))}
              >
                <span>${compared ? orders.stop : orders.compare}</span>
              </button>
              <button
                class="button outlined"
                type="button"
                aria-label=${orders.switchTo(title)}
                @click=${() => this.switchTo(shape, kind)}
              >
                <span>${orders.switch}</span>
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
