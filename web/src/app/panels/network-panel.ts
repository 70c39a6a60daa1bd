/** A network: what is picked of it, how a hand moves that, and what is built with it. */

import { computed } from "@preact/signals-core";
import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { DOINGS, TOUCHES, WAYS } from "../../document/network/grasping";
import { AXES, type Axis } from "../../document/network/moving";
import { edgesThrough, type Network, patchesRound } from "../../document/network/network";
import {
  everything,
  NOTHING,
  type Picks,
  ringThrough,
  withPatch,
  withVertices,
} from "../../document/network/selection";
import { type Building, bridged, extruded, filled, removed, split } from "../../document/network/topology";
import { DesignerElement } from "../../element/designer-element";
import { togglePulling } from "../../state/actions";
import { changeNetwork } from "../../state/network-actions";
import { cells } from "../../ui/cells";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/number-field";
import { formatNumber } from "../../number";
import { intro } from "../../ui/intro";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure, fields } from "../../ui/styles";
import { typing } from "../../ui/typing";
import { networks as words } from "../../words/english/networks";
import { framedNetwork, type NetworkDesk, networkDesk, networkOf, stepOf } from "../../work/network-desk";
import { openObj, saveObj } from "../../work/network-files";
import { CommandEvent } from "../command";
import "./network-patch";
import "./network-place";
import "./network-whole";

const BUILDS = {
  extrude: (network, picks) => extruded(network, picks.vertices),
  split: (network, picks) => split(network, picks.vertices),
  bridge: (network, picks) => bridged(network, picks.vertices),
  fill: (network, picks) => filled(network, picks.vertices),
  remove: (network, picks) => removed(network, picks.patches),
} as const satisfies Readonly<Record<string, (network: Network, picks: Picks) => Building>>;

type Build = keyof typeof BUILDS;

@customElement("pasu-network-panel")
export class PasuNetworkPanel extends DesignerElement {
  /** What was picked before a number was typed: digits on the way to it are numbers of others, which are not picked beside it. */
  private typedFrom: Picks | null = null;
  /** Which number was typed that nothing has, while that was picked. */
  @state() private astray: { readonly label: string; readonly picks: Picks } | null = null;
  /** Whether a grid without a step was typed. */
  @state() private isTooLittle = false;
  readonly #unit = computed(() => unitOf(this.designer.store.design));

  override render() {
    const { session } = this.designer.store;
    const network = framedNetwork(this.designer);
    if (!network) return nothing;
    const picks = this.desk.picksOf(network);
    return html`
      <div class="intro">
        <p><strong>${words.lead}</strong> ${words.about(network.patches.length, network.vertices.length)}</p>
        <button
          class="button outlined"
          type="button"
          aria-pressed=${session.pulling ? "true" : "false"}
          @click=${() => this.designer.apply(togglePulling(this.designer.state))}
        >
          ${words.onStage}
        </button>
      </div>
      ${this.picking(network, picks)} ${this.moving(network)}
      <section aria-label=${words.build}>
        <h3>${words.build}</h3>
        <div class="acts">
          ${(Object.keys(BUILDS) as Build[]).map(
            (build) => html`<button
              class="button outlined"
              type="button"
              data-build=${build}
              title=${words.builds[build].help}
              @click=${() => this.build(build)}
            >
              ${words.builds[build].name}
            </button>`,
          )}
        </div>
      </section>
      <pasu-network-patch .designer=${this.designer}></pasu-network-patch>
      <pasu-network-whole .designer=${this.designer}></pasu-network-whole>
      <section aria-label=${words.beside}>
        <h3>${words.beside}</h3>
        <p class="told">${words.besideAbout}</p>
        <div class="acts">
          <button
            class="button outlined"
            type="button"
            data-command="patches"
            @click=${() => this.dispatchEvent(new CommandEvent("patches"))}
          >
            ${words.besideOpen}
          </button>
        </div>
      </section>
      <section aria-label=${words.file}>
        <h3>${words.file}</h3>
        <p class="told">${words.fileAbout}</p>
        <div class="acts">
          <button class="button outlined" type="button" @click=${this.save}>${words.saveObj}</button>
          <button class="button outlined" type="button" @click=${() => void openObj(this.designer)}>${words.openObj}</button>
        </div>
      </section>
    `;
  }

  private get desk(): NetworkDesk {
    return networkDesk(this.designer);
  }

  /** With its points where they are now. */
  private get network(): Network | null {
    return networkOf(this.designer);
  }

  private readonly save = (): void => {
    const { network } = this;
    if (network) saveObj(this.designer, network);
  };

  private picking(network: Network, picks: Picks) {
    const { vertices, patches } = picks;
    const { several } = this.desk.settings;
    const pick = (next: Picks) => this.desk.pick(network, next);
    const acts = [
      ["all", () => everything(network), ""],
      ["none", () => NOTHING, ""],
      ["ring", () => this.ring(network, picks), words.ringHelp],
      ["patchOf", () => this.round(network, picks), words.patchOfHelp],
    ] as const;
    const [vertex, patch] = [lastOf(vertices), lastOf(patches)];
    return html`<section aria-label=${words.pick}>
      <h3>${words.pick}</h3>
      <div class="acts">
        ${acts.map(
          ([name, next, help]) =>
            html`<button class="button outlined" type="button" data-pick=${name} title=${help || nothing} @click=${() => pick(next())}>
              ${words[name]}
            </button>`,
        )}
        <button
          class="button outlined"
          type="button"
          data-pick="several"
          title=${words.severalHelp}
          aria-pressed=${several ? "true" : "false"}
          @click=${() => this.desk.set({ several: !several })}
        >
          ${words.several}
        </button>
      </div>
      <p class="told" role="status">
        ${vertices.size === 0 ? words.pickedNone : words.picked(vertices.size, patches.size)}
      </p>
      <div class="two">
        ${this.cell(
          network,
          words.numberOfPoint,
          vertex,
          network.vertices.length,
          words.noSuchPoint,
          picks,
          (one, from) => {
            pick(withVertices(from, [one], several));
          },
        )}
        ${this.cell(
          network,
          words.numberOfPatch,
          patch,
          network.patches.length,
          words.noSuchPatch,
          picks,
          (one, from) => {
            pick(several && from.patches.has(one) ? from : withPatch(network, from, one, several));
          },
        )}
      </div>
    </section>`;
  }

  /** What cannot be picked is said why, as of what cannot be built. */
  private ring(network: Network, picks: Picks): Picks {
    if (edgesThrough(network, picks.vertices).length === 0) this.designer.notices.say(words.objections["no-edge"]);
    return ringThrough(network, picks);
  }

  private round(network: Network, picks: Picks): Picks {
    if (picks.vertices.size === 0) this.designer.notices.say(words.objections["no-point"]);
    return patchesOf(network, picks);
  }

  /** What is picked by its number, of so many that are counted from 1; empty where nothing is picked. */
  private cell(
    network: Network,
    label: string,
    one: number | undefined,
    count: number,
    noSuch: (most: string) => string,
    picks: Picks,
    set: (one: number, from: Picks) => void,
  ) {
    const { astray } = this;
    return html`<span class="cell"
      ><span aria-hidden="true">${label}</span
      ><pasu-number
        compact
        .label=${label}
        .blank=${one === undefined}
        .value=${(one ?? -1) + 1}
        .step=${1}
        .problem=${astray?.label === label && astray.picks === picks ? noSuch(formatNumber(count)) : ""}
        @input=${one === undefined ? nothing : this.typing}
        @number-change=${({ value }: NumberChangeEvent) => {
          const isOne = Number.isInteger(value) && value >= 1 && value <= count;
          this.typedFrom ??= picks;
          const from = this.typedFrom;
          this.astray = isOne ? null : { label, picks: from };
          if (isOne) set(value - 1, from);
          else if (picks !== from) this.desk.pick(network, from);
        }}
        @number-done=${() => {
          this.typedFrom = null;
        }}
      ></pasu-number
    ></span>`;
  }

  private readonly typing = typing(() => {
    this.astray = null;
  });

  private moving(network: Network) {
    const { desk } = this;
    const { motion, way, touch, grid, meet, mirror } = desk.settings;
    const step = stepOf(desk.settings, network);
    const unit = this.#unit.value;
    const named = <T extends string>(all: readonly T[], names: Readonly<Record<T, string>>) =>
      all.map((value) => ({ value, label: names[value] }));
    return html`<section aria-label=${words.move}>
      <h3>${words.move}</h3>
      ${choices(words.motion, named(DOINGS, words.motions), motion, (next) => desk.set({ motion: next }))}
      ${choices(words.way, named(WAYS, words.ways), way, (next) => desk.set({ way: next }))}
      ${choices(words.touch, named(TOUCHES, words.touches), touch, (next) => desk.set({ touch: next }))}
      <div class="snaps">
        <label class="check">
          <input type="checkbox" .checked=${grid} @change=${() => desk.set({ grid: !grid })} /><span>${words.grid}</span>
        </label>
        <pasu-number
          compact
          .label=${words.gridStep}
          .unit=${unit}
          .value=${step}
          .step=${Number((step / 5).toPrecision(1))}
          .problem=${this.isTooLittle ? words.tooLittle : ""}
          @number-change=${({ value }: NumberChangeEvent) => {
            this.isTooLittle = !(value > 0);
            if (value > 0) desk.set({ step: value });
          }}
        ></pasu-number>
        <label class="check">
          <input type="checkbox" .checked=${meet} @change=${() => desk.set({ meet: !meet })} /><span>${words.meet}</span>
        </label>
      </div>
      <label class="mirror">
        <span>${words.mirror}</span>
        <select class="field" .value=${mirror ?? ""} @change=${(event: Event) => this.mirror(event)}>
          <option value="" .selected=${mirror === null}>${words.noMirror}</option>
          ${AXES.map((axis) => html`<option value=${axis} .selected=${axis === mirror}>${words.mirrors[axis]}</option>`)}
        </select>
      </label>
      <pasu-network-place .designer=${this.designer}></pasu-network-place>
    </section>`;
  }

  private mirror(event: Event): void {
    const { value } = event.target as HTMLSelectElement;
    this.desk.set({ mirror: AXES.find((axis): axis is Axis => axis === value) ?? null });
  }

  private build(build: Build): void {
    const { network, desk, designer } = this;
    if (!network) return;
    const building = BUILDS[build](network, desk.picksOf(network));
    if ("refused" in building) {
      designer.notices.say(words.objections[building.refused]);
      return;
    }
    desk.pick(network, desk.picksOf(network));
    designer.apply(changeNetwork(designer.state, () => building.network));
    const now = this.network;
    if (now) desk.pick(now, { vertices: building.picked, patches: new Set() });
    designer.notices.say(words.built[build]);
  }

  static override readonly styles = [
    base,
    intro,
    buttons,
    fields,
    cells,
    disclosure,
    choiceStyles,
    css`
      :host {
        display: block;
      }
      .choices div {
        grid-template-columns: repeat(auto-fit, minmax(3.6rem, 1fr));
        gap: 6px;
      }
      .choices label {
        padding: 6px 4px;
        text-align: center;
      }
      section {
        padding: 10px 0 12px;
        border-top: 1px solid var(--line);
      }
      h3 {
        padding-bottom: 8px;
        font-size: 0.95rem;
        font-weight: 650;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
      }
      .told {
        padding: 8px 0;
        color: var(--soft);
        font-size: 0.92rem;
        text-wrap: pretty;
      }
      .two {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        align-items: start;
        gap: 8px;
      }
      .snaps {
        display: grid;
        grid-template-columns: auto minmax(0, 8rem);
        align-items: center;
        gap: 4px 12px;
        padding: 8px 0;
      }
      .check {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 32px;
      }
      @media (pointer: coarse) {
        .check {
          min-height: var(--touch);
        }
        .snaps {
          grid-template-columns: auto minmax(0, 1fr);
        }
      }
      .mirror {
        display: flex;
        align-items: center;
        gap: 10px;
      }
      .mirror .field {
        flex: 1;
        min-width: 0;
      }
    `,
  ];
}

/** What was picked last. */
function lastOf(all: ReadonlySet<number>): number | undefined {
  let last: number | undefined;
  for (const one of all) last = one;
  return last;
}

/** The patches of which a point is picked, with all their points. */
function patchesOf(network: Network, { vertices }: Picks): Picks {
  const patches = new Set(patchesRound(network, vertices));
  return { patches, vertices: new Set([...patches].flatMap((patch) => network.patches[patch]?.frame ?? [])) };
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-network-panel": PasuNetworkPanel;
  }
}
