/** Sliders of the scene: each moves its part, or all that is glued to it, within its limits. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { alongOf, isWithin, JOINT_NAMES, type JointName, jointValue, UPRIGHT } from "../../document/joints";
import { labelOf } from "../../document/label";
import { unitOf } from "../../document/look";
import { ownAxis, round } from "../../document/moving";
import { pathText } from "../../document/path";
import { UNMOVED } from "../../document/placement";
import type { Joint, Refusal, Triple } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { formatNumber } from "../../number";
import { changeJoint, type Jointed, movedBy, moveJoint } from "../../state/joint-actions";
import { MAX_NAME, objectOf } from "../../state/scene-actions";
import { cells } from "../../ui/cells";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure, fields } from "../../ui/styles";
import { joints as words } from "../../words/english/joints";
import { placing } from "../../words/english/placing";
import { quantities } from "../../words/english/quantities";
import { partName } from "../../words/parts";
import { whyWords } from "../../words/refusals";

const DEGREE = Math.PI / 180;
/** How many steps a slider has, at least. */
const STEPS = 100;
const AXES: readonly (readonly [keyof typeof words.axes, Triple])[] = [
  ["x", [1, 0, 0]],
  ["y", [0, 1, 0]],
  ["z", UPRIGHT],
];

@customElement("pasu-joints")
export class PasuJoints extends DesignerElement {
  override render() {
    const all = this.jointed();
    if (all.length === 0) return nothing;
    return html`<section aria-labelledby="joints">
      <h3 id="joints" tabindex="-1">${words.heading}</h3>
      <p class="note">${words.about}</p>
      ${repeat(
        all,
        ({ id, name }) => `${id}-${name}`,
        (each) => this.slider(each, all),
      )}
    </section>`;
  }

  private jointed(): readonly Jointed[] {
    const { design, ids } = this.designer.store;
    return design.parts.flatMap((part, place) =>
      JOINT_NAMES.flatMap((name) => {
        const [joint, id] = [part.joints?.[name], ids[place]];
        return joint && id !== undefined ? [{ id, place, part, name, joint }] : [];
      }),
    );
  }

  private slider(each: Jointed, all: readonly Jointed[]) {
    const { designer } = this;
    const { id, name, joint, part } = each;
    const [called, shown, unit] = [this.nameOf(each, all), scaleOf(name), this.unitOf(name)];
    const value = jointValue(part, name, joint);
    const [from, to] = joint.limits.map(shown.out) as [number, number];
    const locked = movedBy(designer.state, id, joint).some((one) => designer.store.session.locked.includes(one));
    const move = ({ value: given }: NumberChangeEvent) =>
      designer.apply(moveJoint(designer.state, this.now(each), shown.in(given)));
    const told = (limit: number) => quantities.spoken(formatNumber(limit), signOf(unit));
    return html`<div class="joint" role="group" aria-label=${called} data-joint=${`${each.place}-${name}`}>
      <div ?inert=${locked}>
        <pasu-number
          data-field="joint"
          .label=${called}
          .unit=${unit}
          .value=${shown.out(value)}
          .min=${Math.min(from, to)}
          .max=${Math.max(from, to)}
          .step=${stepOf(name, Math.abs(to - from))}
          @number-change=${move}
          @number-done=${() => designer.store.endGesture()}
          @number-cancel=${() => designer.store.cancelGesture()}
        ></pasu-number>
      </div>
      ${locked ? html`<p class="note">${icon("locked")} ${words.locked}</p>` : nothing}
      ${
        isWithin(joint, value) || from >= to
          ? nothing
          : html`<p class="outside" role="status">${icon("warn")}<span>${words.outside(told(from), told(to))}</span></p>`
      }
      ${this.settings(each, called)}
    </div>`;
  }

  private settings(each: Jointed, called: string) {
    const { designer } = this;
    const { id, name, joint, part } = each;
    const others = designer.store.design.parts.some((one) => one !== part && objectOf(one) === objectOf(part));
    const set = (change: Partial<Joint>, key?: string) =>
      designer.apply(changeJoint(designer.state, id, name, { ...this.now(each).joint, ...change }, key));
    return html`<details>
      <summary><span>${words.settings(called)}</span></summary>
      <label class="cell"
        ><span>${words.label}</span
        ><input
          class="field"
          type="text"
          autocomplete="off"
          maxlength=${MAX_NAME}
          placeholder=${this.plainName(each)}
          .value=${joint.label ?? ""}
          @input=${(event: Event) => set({ label: labelOf((event.target as HTMLInputElement).value.trim(), MAX_NAME) }, "label")}
          @blur=${() => designer.store.endGesture()}
      /></label>
      <div class="ends">${this.end(each, 0, set)} ${this.end(each, 1, set)}</div>
      ${name === "turn" ? this.axis(each, set) : nothing}
      ${
        others || joint.glued
          ? html`<label class="check"
              ><input
                type="checkbox"
                .checked=${joint.glued ?? false}
                @change=${(event: Event) => set({ glued: (event.target as HTMLInputElement).checked })}
              /><span>${words.glued}</span></label
            >`
          : nothing
      }
      <button class="button outlined" type="button" @click=${() => void this.takeAway(each)}>
        ${icon("remove")}<span>${words.remove}</span>
      </button>
    </details>`;
  }

  private end(each: Jointed, at: 0 | 1, set: (change: Partial<Joint>, key?: string) => void) {
    const { designer } = this;
    const shown = scaleOf(each.name);
    const word = at === 0 ? words.from : words.to;
    const { limits } = each.joint;
    return html`<div class="cell">
      <span aria-hidden="true">${word}</span>
      <pasu-number
        data-field=${`limit-${at}`}
        .label=${word}
        .unit=${this.unitOf(each.name)}
        .problem=${this.problem(each, at)}
        .compact=${true}
        .value=${shown.out(limits[at])}
        .min=${Math.min(...limits.map(shown.out))}
        .max=${Math.max(...limits.map(shown.out))}
        .step=${stepOf(each.name, Math.abs(shown.out(limits[1]) - shown.out(limits[0])))}
        @number-change=${({ value }: NumberChangeEvent) => {
          const now = this.now(each).joint.limits;
          const given = shown.in(value);
          set({ limits: at === 0 ? [given, now[1]] : [now[0], given] }, `limit-${at}`);
        }}
        @number-done=${() => designer.store.endGesture()}
        @number-cancel=${() => designer.store.cancelGesture()}
      ></pasu-number>
    </div>`;
  }

  /** The axes of the scene, that which the joint has, and where it is none of these, the part's own upright one. */
  private axis({ joint, part }: Jointed, set: (change: Partial<Joint>) => void) {
    const now = joint.axis ?? UPRIGHT;
    const own = ownAxis({ ...UNMOVED, ...part.place }, 2).map((x) => round(x)) as unknown as Triple;
    const known = AXES.some(([, axis]) => same(axis, now));
    const all = known ? AXES : [...AXES, ["own", now] as const];
    const more = known && !AXES.some(([, axis]) => same(axis, own) || same(axis, reversed(own)));
    const listed = more ? [...all, ["own", own] as const] : all;
    return html`<label class="cell"
      ><span>${words.axis}</span
      ><select
        class="field"
        @change=${(event: Event) => {
          const [, axis] = listed[(event.target as HTMLSelectElement).selectedIndex] ?? [];
          if (axis) set({ axis });
        }}
      >
        ${listed.map(([name, axis]) => html`<option .selected=${same(axis, now)}>${words.axes[name]}</option>`)}
      </select></label
    >`;
  }

  /** The focus stays among the sliders, or where there are no others in what these stood in. */
  private async takeAway({ id, name }: Jointed): Promise<void> {
    const { designer } = this;
    designer.apply(changeJoint(designer.state, id, name, null));
    await this.updateComplete;
    const around = this.getRootNode() as ShadowRoot;
    const heading = this.renderRoot.querySelector<HTMLElement>("#joints");
    (heading ?? around.querySelector<HTMLElement>("[role=listbox], summary"))?.focus({ preventScroll: true });
  }

  /** The joint as it is when something happens to it. */
  private now(each: Jointed): Jointed {
    return this.jointed().find(({ id, name }) => id === each.id && name === each.name) ?? each;
  }

  /** By its label; where another has the same, as that of a copy, by its part as well. */
  private nameOf(each: Jointed, all: readonly Jointed[]): string {
    const { label } = each.joint;
    if (label === undefined || label === null) return this.plainName(each);
    const alike = all.filter(({ joint }) => joint.label === label).length > 1;
    return alike ? words.labelOf(label, this.plainName(each)) : label;
  }

  private plainName({ part, place, name }: Jointed): string {
    const whole = partName(place, part.name);
    const along = alongOf(name);
    return along === null ? words.turns(whole) : words.along(whole, name);
  }

  private unitOf(name: JointName): string {
    return name === "turn" ? placing.degree : unitOf(this.designer.store.design);
  }

  private problem({ place, name }: Jointed, at: 0 | 1): string {
    const { problem } = this.designer.surface;
    if (!problem) return "";
    if (pathText(["parts", place, "joints", name, "limits", at]) !== problem.path) return "";
    return whyWords(name === "turn" ? inDegrees(problem) : problem);
  }

  static override readonly styles = [
    base,
    buttons,
    cells,
    disclosure,
    fields,
    css`
      :host {
        display: block;
      }
      section {
        border-top: 1px solid var(--line);
        padding: 10px 0 6px;
      }
      .note {
        color: var(--soft);
        font-size: 0.84rem;
      }
      .joint + .joint {
        border-top: 1px solid var(--line);
      }
      .joint > [inert] {
        opacity: 0.5;
      }
      .outside {
        display: flex;
        gap: 6px;
        color: var(--warn, var(--soft));
        font-size: 0.84rem;
      }
      details {
        padding-bottom: 6px;
      }
      summary span {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      details[open] {
        display: grid;
        /* A long label is cut off as it is while this is closed. */
        grid-template-columns: minmax(0, 1fr);
      }
      .ends {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        /* What is wrong with one of them stands below it alone. */
        align-items: start;
        gap: 8px;
      }
      details > .cell,
      .ends,
      .check,
      details > .button {
        margin: 4px 0;
      }
      .cell .field {
        width: 100%;
      }
      .check {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: var(--touch);
      }
    `,
  ];
}

/** Between what a document has and what a person reads: turns are in degrees. */
export function scaleOf(name: JointName) {
  const factor = name === "turn" ? DEGREE : 1;
  return { out: (value: number) => Number((value / factor).toPrecision(9)), in: (value: number) => value * factor };
}

/** What is wrong with an angle, as a person reads it. */
function inDegrees(problem: Refusal): Refusal {
  const { out } = scaleOf("turn");
  const told = ([key, value]: readonly [string, unknown]) => [key, typeof value === "number" ? out(value) : value];
  return { ...problem, args: Object.fromEntries(Object.entries(problem.args ?? {}).map(told)) };
}

function stepOf(name: JointName, range: number): number {
  if (name === "turn") return 1;
  const step = 10 ** Math.floor(Math.log10(range / STEPS));
  return Number.isFinite(step) && step > 0 ? Number(step.toPrecision(1)) : 0.01;
}

function signOf(unit: string): string {
  return quantities.units[unit as keyof typeof quantities.units] ?? unit;
}

function same(one: Triple, other: Triple): boolean {
  return one.every((x, at) => Math.abs(x - (other[at] as number)) < 1e-9);
}

function reversed([x, y, z]: Triple): Triple {
  return [-x, -y, -z];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-joints": PasuJoints;
  }
}
