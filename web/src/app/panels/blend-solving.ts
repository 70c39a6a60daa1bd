/** How the equation of a blend is solved, for those who ask: folded until then. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import {
  methodOf,
  methodsFor,
  termsOf,
  termsUsed,
  unseenOf,
  weightsOf,
  withEnoughTerms,
  withMethod,
  withTerm,
  withWeight,
} from "../../document/blend/solving";
import { WEIGHTS } from "../../document/blend/tables.gen";
import { type Path, pathText } from "../../document/path";
import type { Blend } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { changeBlend } from "../../state/blend-actions";
import { cells } from "../../ui/cells";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure } from "../../ui/styles";
import { blends as words } from "../../words/english/blends";
import { page } from "../../words/english/page";
import { whyWords } from "../../words/refusals";

@customElement("pasu-blend-solving")
export class PasuBlendSolving extends DesignerElement {
  @state() private comparing = false;

  override render() {
    const { design, part } = this.designer.state;
    const blend = design.parts[part]?.shape;
    if (blend?.kind !== "blend") return nothing;
    const method = methodOf(blend);
    const used = termsUsed(method);
    return html`<details>
      <summary><h3>${words.solving}</h3><span>${words.solvingAbout}</span></summary>
      ${this.weights(blend)}
      ${choices(
        words.method,
        methodsFor(blend).map((value) => ({
          value,
          label: words.methods[value].name,
          note: words.methods[value].help,
        })),
        method,
        (chosen) => this.change((each) => withMethod(each, chosen)),
      )}
      ${
        used === 0
          ? nothing
          : html`<div class="terms" role="group" aria-label=${words.terms}>
              <h4>${words.terms}</h4>
              ${termsOf(blend)
                .slice(0, used)
                .map((value, index) => this.term(value, index))}
            </div>`
      }
      ${this.unseen(blend)}
      ${
        this.comparing
          ? html`<pasu-blend-methods .designer=${this.designer}></pasu-blend-methods>`
          : html`<button class="button outlined compare" type="button" @click=${() => void this.compare()}>${words.compareMethods}</button>`
      }
    </details>`;
  }

  /** Said as soon as it is so, with what would help. */
  private unseen(blend: Blend) {
    const unseen = unseenOf(blend);
    const enough = withEnoughTerms(blend);
    return html`<div class="unseen" role="status" ?hidden=${unseen === null}>
      ${
        unseen === null
          ? nothing
          : html`<p>${words.unseen(unseen.waves, unseen.terms)}</p>
              ${
                enough === null
                  ? nothing
                  : html`<button class="button outlined" type="button" @click=${() => this.change((each) => withEnoughTerms(each) ?? each)}>${words.enoughTerms(2 * unseen.waves)}</button>`
              }
              ${
                methodsFor(blend).includes("exact")
                  ? html`<button class="button outlined" type="button" @click=${() => this.change((each) => withMethod(each, "exact"))}>${words.solveExactly}</button>`
                  : nothing
              }`
      }
    </div>`;
  }

  private async compare(): Promise<void> {
    try {
      await import("./blend-methods");
      this.comparing = true;
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  }

  private weights(blend: Blend) {
    const { designer } = this;
    const opened = designer.origin.design.parts[designer.store.part]?.shape;
    const before = weightsOf(opened?.kind === "blend" ? opened : blend);
    const weights = weightsOf(blend);
    return html`<p class="about">${methodOf(blend) === "exact" ? words.weightsHelp : words.insideOnly}</p>
      ${WEIGHTS.map((field, index) => {
        const set = (value: number, gesture: boolean) =>
          this.change((each) => withWeight(each, index, value), gesture ? field.key : undefined);
        return html`<pasu-number
          data-field=${field.key}
          data-at=${pathText(field.path)}
          .label=${words.weight[index] ?? ""}
          .symbol=${field.symbol}
          .value=${weights[index] ?? 1}
          .opened=${before[index] ?? 1}
          .min=${field.min}
          .max=${field.max}
          .step=${field.step}
          .problem=${this.problemOf(field.path)}
          @number-change=${({ value, gesture }: NumberChangeEvent) => set(value, gesture)}
          @number-done=${() => designer.store.endGesture()}
          @number-cancel=${() => designer.store.cancelGesture()}
          @number-reset=${() => set(before[index] ?? 1, false)}
        ></pasu-number>`;
      })}`;
  }

  private term(value: number, index: number) {
    const label = words.along[index] ?? "";
    return html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${words.of(words.terms, label)}
        .value=${value}
        .step=${1}
        .problem=${this.problemOf(["terms", index])}
        @number-change=${(event: NumberChangeEvent) =>
          this.change((each) => withTerm(each, index, event.value), event.gesture ? `terms ${index}` : undefined)}
        @number-done=${() => this.designer.store.endGesture()}
        @number-cancel=${() => this.designer.store.cancelGesture()}
      ></pasu-number
    ></span>`;
  }

  private change(edit: (blend: Blend) => Blend, key?: string): void {
    this.designer.apply(changeBlend(this.designer.state, edit, key));
  }

  private problemOf(path: Path): string {
    const { state, surface } = this.designer;
    const { problem } = surface;
    return problem?.path === pathText(["parts", state.part, "shape", ...path]) ? whyWords(problem) : "";
  }

  static override readonly styles = [
    base,
    buttons,
    choiceStyles,
    disclosure,
    cells,
    css`
      :host {
        display: block;
      }
      details {
        border-top: 1px solid var(--line);
        padding-bottom: 8px;
      }
      .compare {
        margin-top: 14px;
      }
      .unseen {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        margin-top: 12px;
        padding: 10px 12px;
        border: 1px solid var(--warn);
        border-radius: 12px;
      }
      .unseen[hidden] {
        display: none;
      }
      .unseen p {
        flex: 1 0 100%;
        font-size: 0.92rem;
        text-wrap: pretty;
      }
      .about {
        color: var(--soft);
        font-size: 0.86rem;
        padding-bottom: 6px;
        text-wrap: pretty;
      }
      .terms {
        display: grid;
        grid-template-columns: 58px repeat(3, minmax(0, 1fr));
        align-items: end;
        gap: 6px 8px;
        padding-top: 12px;
      }
      h4 {
        font-size: 0.88rem;
        font-weight: 600;
        padding-bottom: 8px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-blend-solving": PasuBlendSolving;
  }
}
