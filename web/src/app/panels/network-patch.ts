/** The numbers of the picked patches: how stiff they are along either way, and the forces that push them. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { unitOf } from "../../document/look";
import { AXES } from "../../document/network/moving";
import { type Network, type Patch, sizeOf } from "../../document/network/network";
import { crestOf, type Force, forceFor, heightOf, MOST_FORCES } from "../../document/network/sculpting";
import { dot, normalOn } from "../../document/network/surface";
import { outsides } from "../../document/network/topology";
import type { Pair, Triple } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber } from "../../number";
import { togglePulling } from "../../state/actions";
import { changeNetwork } from "../../state/network-actions";
import { cells } from "../../ui/cells";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import { lock } from "../../ui/lock";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure, fields } from "../../ui/styles";
import { networks as words } from "../../words/english/networks";
import { framedNetwork, networkDesk, networkOf } from "../../work/network-desk";

const ONES: Triple = [1, 1, 1];
const UNIT: Pair = [0, 1];
const UP: Triple = [0, 0, 1];
const STEPS = 100;
/** A region is no narrower either way, in shares of a patch. */
const NARROWEST = 0.001;
/** A new force pushes as far as this share of the size. */
const PUSH = 0.1;
/** A height is read as it was typed: a force has one digit more. */
const DIGITS = 5;

@customElement("pasu-network-patch")
export class PasuNetworkPatch extends DesignerElement {
  /** Which numbers are set apart for x, y and z though they are the same. */
  @state() private apart: ReadonlySet<string> = new Set();
  /** Which end of a region was typed to where none can be, and what is said of it until a number of the patch changes. */
  @state() private astray: { readonly field: string; readonly of: Patch; readonly said: string } | null = null;
  /** Of which sliders it was typed that they reach nowhere. */
  @state() private tooLittle: "magnification" | "strength" | null = null;

  override render() {
    const framed = framedNetwork(this.designer);
    if (!framed) return nothing;
    const picked = [...networkDesk(this.designer).picksOf(framed).patches];
    const patch = framed.patches[picked[0] ?? -1];
    // How far a force moves the surface goes by where the points are.
    const network = patch?.forces?.length ? (this.network ?? framed) : framed;
    return html`
      <details open>
        <summary><h3>${words.surface}</h3><span>${words.surfaceHelp}</span></summary>
        ${picked.length > 1 ? html`<p class="lead">${words.ofSeveral(formatNumber((picked[0] ?? 0) + 1), picked.length)}</p>` : nothing}
        ${patch ? this.parameters(patch) : html`<p class="lead">${words.noSurface}</p>`}
      </details>
      ${
        patch
          ? html`<details open>
              <summary><h3>${words.forces}</h3><span>${words.forcesHelp}</span></summary>
              ${(patch.forces ?? []).map((force, index) => this.force(network, picked[0] ?? 0, patch, force, index))}
              ${(patch.forces ?? []).length > 0 ? this.reach("strength") : nothing}
              <div class="acts">
                <button class="button outlined add" type="button" ?disabled=${(patch.forces ?? []).length >= MOST_FORCES} @click=${() => this.add(picked[0] ?? 0)}>
                  ${icon("add")}<span>${words.addForce}</span>
                </button>
                <button class="button outlined" type="button" @click=${this.drawRegion}>${words.region}</button>
              </div>
            </details>`
          : nothing
      }
    `;
  }

  private get network(): Network | null {
    return networkOf(this.designer);
  }

  private parameters(patch: Patch) {
    const { magnification } = networkDesk(this.designer).settings;
    return html`${(["a1", "a2"] as const).map((key) =>
      this.triple(
        key,
        words.parameters[key],
        key === "a1" ? "a_1" : "a_2",
        patch[key] ?? ONES,
        magnification,
        (next, gesture) => this.change((each) => ({ ...each, [key]: next(each[key] ?? ONES) }), gesture && key),
      ),
    )}${this.reach("magnification")}`;
  }

  /** What 1 on a slider stands for: the magnification of the paper. */
  private reach(key: "magnification" | "strength") {
    const desk = networkDesk(this.designer);
    return html`<span class="cell reach"
      ><span aria-hidden="true">${words.magnification}</span
      ><pasu-number
        compact
        .label=${words.magnification}
        .qualifier=${key === "strength" ? words.strength : ""}
        .value=${desk.settings[key]}
        .step=${1}
        .problem=${this.tooLittle === key ? words.tooLittle : ""}
        @number-change=${({ value }: NumberChangeEvent) => {
          this.tooLittle = value > 0 ? null : key;
          if (value > 0) desk.set({ [key]: value });
        }}
      ></pasu-number
    ></span>`;
  }

  private triple(
    key: string,
    label: string,
    symbol: string,
    value: Triple,
    most: number,
    set: (next: (before: Triple) => Triple, gesture: string | false) => void,
    number = "",
  ) {
    const same = value[0] === value[1] && value[1] === value[2];
    const isApart = !same || this.apart.has(key);
    // A force pushes either way: 0 is in the middle of its sliders, at one place in x, y and z.
    const pushes = number !== "";
    const slider = (axis: number | null) => html`<pasu-number
      data-field="${key}${axis === null ? "" : `-${axis}`}"
      .label=${number === "" ? label : words.ofForce(label, number)}
      .qualifier=${axis === null ? "" : words.component(AXES[axis] ?? "")}
      .symbol=${symbol}
      .help=${number === "" ? words.parameterHelp : ""}
      .value=${value[axis ?? 0] ?? 0}
      .min=${pushes ? -most : 0}
      .max=${most}
      .step=${most / STEPS}
      @number-change=${(event: NumberChangeEvent) =>
        set(
          (before) =>
            before.map((each, place) => (axis === null || place === axis ? event.value : each)) as unknown as Triple,
          event.gesture && `${axis}`,
        )}
      @number-done=${() => this.designer.store.endGesture()}
      @number-cancel=${() => this.designer.store.cancelGesture()}
    ></pasu-number>`;
    return html`<div class="triple">
      ${isApart ? [0, 1, 2].map((axis) => slider(axis)) : slider(null)}
      <button
        class="button lock"
        type="button"
        aria-pressed=${isApart ? "false" : "true"}
        aria-label=${words.sameOf(number === "" ? label : words.ofForce(label, number))}
        @click=${() => {
          const apart = new Set(this.apart);
          if (isApart) apart.delete(key);
          else apart.add(key);
          this.apart = apart;
          if (isApart && !same) set(([first]) => [first, first, first], false);
        }}
      >
        ${icon(isApart ? "unlocked" : "locked")}<span>${words.same}</span>
      </button>
    </div>`;
  }

  private force(network: Network, place: number, patch: Patch, force: Force, index: number) {
    const number = formatNumber(index + 1);
    const { u = UNIT, v = UNIT, falloff = "sine" } = force;
    const unit = unitOf(this.designer.store.design);
    const normal = this.normal(network, place, force);
    const edit = (next: (before: Force, of: Patch, place: number) => Force, key: string | false) =>
      this.change(
        (each, at) => withForce(each, index, (before, of) => next(before, of, at)),
        key && `force ${index} ${key}`,
      );
    const cell = (
      label: string,
      value: number,
      step: number,
      set: (value: number) => (before: Force, of: Patch, place: number) => Force,
      key: string,
      of = "",
      bad: (value: number) => string = () => "",
    ) =>
      html`<span class="cell"
        ><span aria-hidden="true">${label}</span
        ><pasu-number
          compact
          .label=${words.ofForce(label, number)}
          .unit=${of}
          .value=${value}
          .step=${step}
          .problem=${this.astray?.field === `${index} ${key}` && this.astray.of === patch ? this.astray.said : ""}
          @number-change=${(event: NumberChangeEvent) => {
            const said = bad(event.value);
            this.astray = said === "" ? null : { field: `${index} ${key}`, of: patch, said };
            if (said === "") edit(set(event.value), event.gesture && key);
          }}
          @number-done=${() => this.designer.store.endGesture()}
          @number-cancel=${() => this.designer.store.cancelGesture()}
        ></pasu-number
      ></span>`;
    const ends = (["u", "v"] as const).flatMap((axis) =>
      ([0, 1] as const).map((end) => {
        const range = axis === "u" ? u : v;
        const label = end === 0 ? words.from(axis) : words.to(axis);
        return cell(
          label,
          range[end],
          0.05,
          (value) => (before) => ({ ...before, [axis]: ranged(before[axis] ?? UNIT, end, value) }),
          `${axis}${end}`,
          "",
          (value) => this.narrowness(index, axis, end, value),
        );
      }),
    );
    return html`<div class="force" role="group" aria-label=${words.force(number)}>
      <div class="head">
        <h4>${words.force(number)}</h4>
        <button class="button bare" type="button" aria-label=${words.removeForce(number)} @click=${() => this.takeAway(index)}>
          ${icon("remove")}
        </button>
      </div>
      ${this.triple(
        `f0-${index}`,
        words.strength,
        "f_0",
        force.f0,
        networkDesk(this.designer).settings.strength,
        (next, gesture) => edit((before) => ({ ...before, f0: next(before.f0) }), gesture),
        number,
      )}
      <div class="cells">
        ${cell(
          words.height,
          Number(dot(heightOf(patch, force), normal).toPrecision(DIGITS)),
          Number((sizeOf(network) / STEPS).toPrecision(1)),
          (value) => {
            const normals = this.normals(place);
            return (before, of, at) => {
              const [x, y, z] = normals(at, before);
              return { ...before, f0: forceFor(of, [value * x, value * y, value * z]) };
            };
          },
          "height",
          unit,
        )}
        ${ends}
      </div>
      <label class="falloff">
        <span>${words.falloff}</span>
        <select
          class="field"
          aria-label=${words.ofForce(words.falloff, number)}
          .value=${falloff}
          @change=${(event: Event) => {
            const chosen = (event.target as HTMLSelectElement).value === "smooth" ? "smooth" : "sine";
            edit((before) => ({ ...before, falloff: chosen }), false);
          }}
        >
          ${(["smooth", "sine"] as const).map((each) => html`<option value=${each} .selected=${each === falloff}>${words.falloffs[each]}</option>`)}
        </select>
      </label>
    </div>`;
  }

  /** What is wrong with an end of a region, of whichever picked patch: it would pass the other end, or meet it. */
  private narrowness(index: number, axis: "u" | "v", end: 0 | 1, value: number): string {
    const { network } = this;
    const picked = network ? networkDesk(this.designer).picksOf(network).patches : [];
    const others = [...picked].flatMap((place) => {
      const force = network?.patches[place]?.forces?.[index];
      return force ? [(force[axis] ?? UNIT)[1 - end] as number] : [];
    });
    const bound = end === 0 ? Math.min(...others) : Math.max(...others);
    const long = end === 0 ? bound - value : value - bound;
    return long >= NARROWEST ? "" : words.passes[end](axis, formatNumber(bound));
  }

  private normal(network: Network, place: number, force: Force): Triple {
    const within = (value: number) => Math.min(Math.max(value, 0), 1);
    const [u, v] = crestOf(force);
    return normalOn(network, place, within(u), within(v)) ?? UP;
  }

  /** Of every patch the normal at the middle of a force on the side to which that of the first one points, whichever way frames go round. */
  private normals(first: number): (place: number, force: Force) => Triple {
    const { network } = this;
    if (!network) return () => UP;
    const sides = outsides(network);
    return (place, force) => {
      const [x, y, z] = this.normal(network, place, force);
      return sides[place]?.sign === sides[first]?.sign ? [x, y, z] : [-x, -y, -z];
    };
  }

  /** To every picked patch, as far on each along its own normal. */
  private add(first: number): void {
    const { network } = this;
    if (!network) return;
    const normals = this.normals(first);
    const far = PUSH * sizeOf(network);
    this.change((patch, place) => {
      const { forces = [] } = patch;
      if (forces.length >= MOST_FORCES) return patch;
      const whole: Force = { f0: UP, falloff: "smooth" };
      const [x, y, z] = normals(place, whole);
      return { ...patch, forces: [...forces, { ...whole, f0: forceFor(patch, [far * x, far * y, far * z]) }] };
    }, false);
  }

  /** The button that was pressed is gone with the force: the focus goes to that of the next one, or to where one is added. */
  private async takeAway(index: number): Promise<void> {
    this.change((each) => withoutForce(each, index), false);
    await this.updateComplete;
    const left = [...this.renderRoot.querySelectorAll<HTMLElement>(".force .bare")];
    (left[index] ?? left.at(-1) ?? this.renderRoot.querySelector<HTMLElement>(".add"))?.focus();
  }

  private readonly drawRegion = (): void => {
    networkDesk(this.designer).set({ touch: "region" });
    if (!this.designer.store.session.pulling) this.designer.apply(togglePulling(this.designer.state));
  };

  /** All picked patches at once. */
  private change(edit: (patch: Patch, index: number) => Patch, key: string | false): void {
    const { network, designer } = this;
    if (!network) return;
    const desk = networkDesk(designer);
    const picks = desk.picksOf(network);
    const patches = network.patches.map((patch, index) => (picks.patches.has(index) ? edit(patch, index) : patch));
    designer.apply(changeNetwork(designer.state, (now) => ({ ...now, patches }), key || undefined));
    const now = this.network;
    if (now) desk.pick(now, picks);
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    cells,
    disclosure,
    lock,
    css`
      :host {
        display: block;
      }
      details {
        border-top: 1px solid var(--line);
        padding: 4px 0 10px;
      }
      .lead {
        color: var(--soft);
      }
      .reach {
        display: flex;
        align-items: center;
        gap: 8px;
        padding: 4px 0 8px;
      }
      .reach pasu-number {
        width: 7rem;
      }
      .force {
        margin-bottom: 10px;
        padding: 8px 12px 12px;
        border: 1px solid var(--line);
        border-radius: 12px;
      }
      .head {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      h4 {
        font-size: 0.92rem;
        font-weight: 650;
      }
      .cells {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        /* What is wrong with one of them stands below it alone. */
        align-items: start;
        gap: 6px 8px;
        padding: 6px 0;
      }
      .cells .cell:first-child {
        grid-column: 1 / -1;
      }
      .falloff {
        display: flex;
        align-items: center;
        gap: 10px;
        padding-top: 6px;
      }
      .falloff .field {
        flex: 1;
        min-width: 0;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        gap: 8px;
        padding-top: 6px;
      }
    `,
  ];
}

function withForce(patch: Patch, index: number, edit: (before: Force, of: Patch) => Force): Patch {
  const { forces } = patch;
  if (!forces?.[index]) return patch;
  return { ...patch, forces: forces.map((force, each) => (each === index ? edit(force, patch) : force)) };
}

function withoutForce({ forces = [], ...patch }: Patch, index: number): Patch {
  const left = forces.filter((_, each) => each !== index);
  return left.length > 0 ? { ...patch, forces: left } : patch;
}

function ranged(before: Pair, end: 0 | 1, value: number): Pair {
  return end === 0 ? [value, before[1]] : [before[0], value];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-network-patch": PasuNetworkPatch;
  }
}
