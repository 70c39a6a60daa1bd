/** Where the selected part stands, by numbers: its scale, its turn and its shift. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { longestOf, roundStep } from "../../document/boxes";
import { type JointName, jointValue, limitsAbout, UPRIGHT } from "../../document/joints";
import { unitOf } from "../../document/look";
import { round } from "../../document/moving";
import { pathText } from "../../document/path";
import { UNMOVED, type WholePlacement } from "../../document/placement";
import type { Triple } from "../../document/types";
import { UnhurriedElement } from "../../element/unhurried";
import { widthOf } from "../../solver/solved";
import { changeJoint } from "../../state/joint-actions";
import { changePlace } from "../../state/place-actions";
import { objectOf } from "../../state/scene-actions";
import { cells } from "../../ui/cells";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import "./joints-card";
import type { NumberChangeEvent, NumberResetEvent } from "../../ui/number-field";
import { base, buttons, disclosure } from "../../ui/styles";
import { joints } from "../../words/english/joints";
import { placing as words } from "../../words/english/placing";
import { whyWords } from "../../words/refusals";

const HALF_TURN = 180;
const AXES = [0, 1, 2] as const;
const SHIFTS = ["x", "y", "z"] as const;
/** How far beyond what was opened a slider goes. */
const BEYOND = 2;
/** The steps of keys: so many of them are a part, or its scale, and none is longer. */
const STEPS = 100;
const MOST_STEP = 0.1;
const MOST_GROWTH = 0.01;

type Triples = "scale" | "axis" | "shift";

interface Ask {
  readonly key: string;
  readonly path: readonly (string | number)[];
  readonly label: string;
  readonly help: string;
  readonly unit: string;
  readonly value: number;
  readonly opened: number;
  readonly range: readonly [number, number];
  readonly step: number;
  readonly with: (place: WholePlacement, value: number) => WholePlacement;
  /** The joint by which it can be a slider of the scene. */
  readonly joint?: JointName;
}

@customElement("pasu-place")
export class PasuPlace extends UnhurriedElement {
  override render() {
    const { design, ids, part: at } = this.designer.state;
    const part = design.parts[at];
    if (!part) return html``;
    const place: WholePlacement = { ...UNMOVED, ...part.place };
    const before: WholePlacement = { ...UNMOVED, ...this.designer.origin.design.parts[at]?.place };
    const unit = unitOf(this.designer.store.design);
    // An octant has no length of its own: its scale is how far it reaches.
    const isLength = part.shape.kind === "octant";
    const solved = this.designer.surface.shown?.solved;
    const width = widthOf(solved);
    const far = rounded(BEYOND * Math.max(width, ...before.shift.map(Math.abs)));
    const largest = Math.max(...before.scale.map(Math.abs));
    const size = rounded(BEYOND * Math.max(isLength ? 0 : 1, largest));
    // Keys move what is tiny by as little: it is not gone at once.
    const box = solved?.parts[at]?.box;
    const step = stepUnder(MOST_STEP, (box ? longestOf(box) : width) / STEPS);
    const grows = stepUnder(MOST_GROWTH, largest / STEPS);
    const locked = this.designer.store.session.locked.includes(ids[at] ?? -1);
    // Of one part alone it is there for the sake of its size or of its sliders.
    return html`<details ?open=${isLength || ids.length === 1}>
      <summary><h3>${words.heading}</h3><span>${words.about}</span></summary>
      ${locked ? html`<p class="locked">${icon("locked")}${words.locked}</p>` : nothing}
      <div ?inert=${locked}>
      ${AXES.map((axis) =>
        this.number({
          key: `scale-${axis}`,
          path: ["scale", axis],
          label: (isLength ? words.edges[axis] : words.factors[axis]) ?? "",
          help: isLength ? words.edgeHelp : words.factorHelp,
          unit: isLength ? unit : "",
          value: place.scale[axis],
          opened: before.scale[axis],
          range: [0.05 * size, size],
          step: grows,
          with: (now, value) => withTriple(now, "scale", axis, value),
        }),
      )}
      ${this.number({
        key: "turn",
        path: ["angle"],
        label: words.turn,
        help: words.turnHelp,
        unit: words.degree,
        value: rounded((place.angle / Math.PI) * HALF_TURN),
        opened: rounded((before.angle / Math.PI) * HALF_TURN),
        range: [-HALF_TURN, HALF_TURN],
        step: 1,
        with: (now, value) => ({ ...now, angle: (value / HALF_TURN) * Math.PI }),
        joint: "turn",
      })}
      <div class="axis">
        ${AXES.map(
          (axis) => html`<div class="cell">
            <span aria-hidden="true">${words.axis[axis]}</span>
            ${this.number(
              {
                key: `axis-${axis}`,
                path: ["axis"],
                label: words.axis[axis] ?? "",
                help: "",
                unit: "",
                value: place.axis[axis],
                opened: before.axis[axis],
                range: [-1, 1],
                step: 0.01,
                with: (now, value) => withTriple(now, "axis", axis, value),
              },
              true,
            )}
          </div>`,
        )}
      </div>
      ${AXES.map((axis) =>
        this.number({
          key: `shift-${axis}`,
          path: ["shift", axis],
          label: words.shifts[axis] ?? "",
          help: words.shiftHelp,
          unit,
          value: place.shift[axis],
          opened: before.shift[axis],
          range: [-far, far],
          step,
          with: (now, value) => withTriple(now, "shift", axis, value),
          joint: SHIFTS[axis],
        }),
      )}
      <button
        class="button outlined"
        type="button"
        title=${words.resetNote}
        aria-disabled=${part.place === undefined ? "true" : nothing}
        @click=${() => part.place && this.designer.apply(changePlace(this.designer.state, (now) => (isLength ? { ...UNMOVED, scale: now.scale } : UNMOVED)))}
      >
        ${words.reset}
      </button>
      </div>
      ${design.parts.length === 1 ? html`<pasu-joints .designer=${this.designer}></pasu-joints>` : nothing}
    </details>`;
  }

  private number(ask: Ask, compact = false) {
    const { designer } = this;
    const set = (value: number, gesture: boolean) =>
      designer.apply(changePlace(designer.state, (now) => ask.with(now, value), gesture ? ask.key : undefined));
    const number = html`<pasu-number
      data-field="place-${ask.key}"
      .label=${ask.label}
      .help=${ask.help}
      .unit=${ask.unit}
      .explain=${designer.store.session.explain}
      .problem=${this.refusal(ask.path)}
      .compact=${compact}
      .value=${ask.value}
      .opened=${ask.opened}
      .min=${ask.range[0]}
      .max=${ask.range[1]}
      .step=${ask.step}
      @number-change=${({ value, gesture }: NumberChangeEvent) => set(value, gesture)}
      @number-done=${() => designer.store.endGesture()}
      @number-cancel=${() => designer.store.cancelGesture()}
      @number-reset=${(_: NumberResetEvent) => set(ask.opened, false)}
    ></pasu-number>`;
    return ask.joint === undefined
      ? number
      : html`<div class="jointed">${number}${this.joint(ask.joint, ask.label)}</div>`;
  }

  /** Makes the number a slider of the scene, or no longer. */
  private joint(name: JointName, label: string) {
    const { designer } = this;
    const { design, ids, part: at } = designer.state;
    const [part, id] = [design.parts[at], ids[at]];
    if (!part || id === undefined) return nothing;
    const has = part.joints?.[name] !== undefined;
    const toggle = () => {
      if (has) return designer.apply(changeJoint(designer.state, id, name, null));
      const place: WholePlacement = { ...UNMOVED, ...part.place };
      const axis = place.angle === 0 ? UPRIGHT : place.axis;
      const turn = { axis, limits: [0, 0] as const };
      const now = jointValue(part, name, turn);
      const members = design.parts.filter((one) => objectOf(one) === objectOf(part)).length;
      // What is glued goes along where that is not simply everything.
      const glued = members > 1 && members < design.parts.length;
      const width = widthOf(designer.surface.shown?.solved);
      const limits = limitsAbout(name, round(now), Number(width.toPrecision(1)));
      const joint = { ...(name === "turn" && { axis }), limits, ...(glued && { glued }) };
      return designer.apply(changeJoint(designer.state, id, name, joint));
    };
    return html`<button
      class="button bare toggle"
      type="button"
      data-joint=${name}
      aria-pressed=${has ? "true" : "false"}
      aria-label=${joints.toggle(label)}
      title=${joints.toggle(label)}
      @click=${toggle}
    >
      ${icon("slider")}
    </button>`;
  }

  /** The solver's objection to this very number. */
  private refusal(path: Ask["path"]): string {
    const { state, surface } = this.designer;
    const { problem } = surface;
    if (!problem) return "";
    return pathText(["parts", state.part, "place", ...path]) === problem.path ? whyWords(problem) : "";
  }

  static override readonly styles = [
    base,
    buttons,
    disclosure,
    cells,
    css`
      :host {
        display: block;
      }
      details {
        border-top: 1px solid var(--line);
        padding: 4px 0 12px;
      }
      pasu-joints {
        display: block;
        margin-top: 16px;
      }
      .locked {
        display: flex;
        align-items: center;
        gap: 6px;
        color: var(--soft);
        font-size: 0.84rem;
      }
      [inert] {
        opacity: 0.5;
      }
      .jointed {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        align-items: start;
        gap: 4px;
      }
      .toggle[aria-pressed="true"] {
        color: var(--accent);
      }
      .axis {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
        padding: 4px 0 10px;
      }
    `,
  ];
}

function withTriple(place: WholePlacement, key: Triples, axis: 0 | 1 | 2, value: number): WholePlacement {
  const next = [...place[key]] as [number, number, number];
  next[axis] = value;
  return { ...place, [key]: next satisfies Triple };
}

function stepUnder(most: number, step: number): number {
  return step > 0 && step < most ? roundStep(step) : most;
}

/** What a person reads: degrees and ends of sliders have no digits of rounding. */
function rounded(value: number): number {
  return Number(value.toPrecision(9));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-place": PasuPlace;
  }
}
