/** The numbers that all patches of a network have together: which edges look smooth, and what decides how a strip of patches bends. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Network } from "../../document/network/network";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber } from "../../number";
import { changeNetwork } from "../../state/network-actions";
import { cells } from "../../ui/cells";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, disclosure, fields } from "../../ui/styles";
import { typing } from "../../ui/typing";
import { networks as words } from "../../words/english/networks";
import { framedNetwork, networkDesk, networkOf } from "../../work/network-desk";

const DEGREE = Math.PI / 180;
/** The angle of a crease where a document gives none, in radians: frozen with version 1 of the format. */
const CREASE = 0.5;
/** What a person reads has no digits of rounding. */
const DIGITS = 6;
/** A document has so many. */
const WRITTEN = 12;

type Rule = "global" | "seed";

@customElement("pasu-network-whole")
export class PasuNetworkWhole extends DesignerElement {
  /** What was typed that cannot be. */
  @state() private astray: "crease" | "seed" | null = null;

  override render() {
    const network = framedNetwork(this.designer);
    if (!network) return nothing;
    const { rule = "global", crease = CREASE, patches } = network;
    const seed = rule === "global" ? null : rule.seed;
    const rules: readonly Rule[] = ["global", "seed"];
    return html`<details>
      <summary><h3>${words.whole}</h3><span>${words.wholeHelp}</span></summary>
      <span class="cell"
        ><span aria-hidden="true">${words.crease}</span
        ><pasu-number
          compact
          .label=${words.crease}
          .unit=${"°"}
          .value=${Number((crease / DEGREE).toPrecision(DIGITS))}
          .step=${1}
          .problem=${this.astray === "crease" ? words.noCrease : ""}
          @input=${this.typing}
          @number-change=${({ value, gesture }: NumberChangeEvent) => this.crease(value, gesture)}
          @number-done=${() => this.designer.store.endGesture()}
          @number-cancel=${() => this.designer.store.cancelGesture()}
        ></pasu-number
      ></span>
      <p class="told">${words.creaseHelp}</p>
      ${choices(
        words.rule,
        rules.map((value) => ({ value, label: words.rules[value] })),
        seed === null ? "global" : "seed",
        (next) => this.rule(next),
      )}
      ${
        seed === null
          ? nothing
          : html`<span class="cell"
              ><span aria-hidden="true">${words.seed}</span
              ><pasu-number
                compact
                .label=${words.seed}
                .value=${seed + 1}
                .step=${1}
                .problem=${this.astray === "seed" ? words.noSuchPatch(formatNumber(patches.length)) : ""}
                @input=${this.typing}
                @number-change=${({ value, gesture }: NumberChangeEvent) => this.begin(value, gesture)}
                @number-done=${() => this.designer.store.endGesture()}
                @number-cancel=${() => this.designer.store.cancelGesture()}
              ></pasu-number
            ></span>`
      }
      <p class="told">${words.ruleHelp}</p>
    </details>`;
  }

  private readonly typing = typing(() => {
    this.astray = null;
  });

  private change(edit: (network: Network) => Network, key?: string): void {
    this.designer.apply(changeNetwork(this.designer.state, edit, key));
  }

  private crease(degrees: number, gesture: boolean): void {
    const isAngle = degrees >= 0 && degrees <= 180;
    this.astray = isAngle ? null : "crease";
    if (!isAngle) return;
    const crease = Number((degrees * DEGREE).toPrecision(WRITTEN));
    this.change((network) => ({ ...network, crease }), gesture ? "crease" : undefined);
  }

  /** A walk begins with the patch that is picked, or with the first. */
  private rule(rule: Rule): void {
    const network = networkOf(this.designer);
    if (!network) return;
    this.astray = null;
    const [picked = 0] = networkDesk(this.designer).picksOf(network).patches;
    this.change((before) => ({ ...before, rule: rule === "global" ? rule : { seed: picked } }));
  }

  private begin(number: number, gesture: boolean): void {
    const count = networkOf(this.designer)?.patches.length ?? 0;
    const isOne = Number.isInteger(number) && number >= 1 && number <= count;
    this.astray = isOne ? null : "seed";
    if (!isOne) return;
    this.change((network) => ({ ...network, rule: { seed: number - 1 } }), gesture ? "seed" : undefined);
  }

  static override readonly styles = [
    base,
    fields,
    cells,
    disclosure,
    choiceStyles,
    css`
      :host {
        display: block;
      }
      details {
        padding: 4px 0 10px;
        border-top: 1px solid var(--line);
      }
      .cell {
        max-width: 12rem;
        padding-top: 10px;
      }
      h3 {
        flex: none;
      }
      .told {
        padding: 8px 0 4px;
        color: var(--soft);
        text-wrap: pretty;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-network-whole": PasuNetworkWhole;
  }
}
