/** Several parts brought into order, one put onto another, and copies in rows and rings. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { longestOf, middleOf, roundStep, roundTo } from "../../document/boxes";
import { unitOf } from "../../document/look";
import { AXES, type Axis } from "../../document/moving";
import { LIMITS } from "../../document/tables.gen";
import type { Design, Triple } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import {
  alignOnAxis,
  alignParts,
  distributeParts,
  mirrorParts,
  putOnTable,
  ringOfParts,
  rowOfParts,
  type Side,
} from "../../state/arrange-actions";
import { selectedIds } from "../../state/seen-actions";
import { looseIds } from "../../state/several-actions";
import { standOn } from "../../state/stand-actions";
import type { Change } from "../../state/store";
import { icon } from "../../ui/icons";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons, disclosure } from "../../ui/styles";
import { arranging as words } from "../../words/english/arranging";
import { handling } from "../../words/english/handling";
import { parts as partWords } from "../../words/english/parts";
import { boxesOf, middlesOf, onceKnown } from "../../work/held";
import { type Course, pushOnto } from "../../work/pushing";
import { rimsOf } from "../../work/rims";

const SIDES: readonly Side[] = ["low", "middle", "high"];
/** A row's usual step, as a share of what stands in it. */
const BESIDE = 1.2;
/** So far the slider goes; more are typed. */
const MOST_COPIES = 60;
const ALL_ROUND = 360;

@customElement("pasu-arrange")
export class PasuArrange extends DesignerElement {
  @state() private isOpen = false;
  @state() private count = 6;
  /** What was chosen of the rest; what follows from the selection where nothing was. */
  @state() private step: Triple | null = null;
  @state() private centre: readonly [number, number] | null = null;
  @state() private angle = ALL_ROUND;
  @state() private turning = true;
  /** So many copies of what was selected were more than there may be. */
  @state() private refused: { readonly count: number; readonly of: Design; readonly selected: string } | null = null;
  /** Whether something is being pushed, and what is to be said of the last time, as long as nothing else has been done since. */
  @state() private pushing = false;
  @state() private pushed: { readonly said: string; readonly of: Design; readonly selected: string } | null = null;

  /** Which scene that was chosen in, and in which unit: in another these lengths mean nothing. */
  private chosenIn = "";

  override willUpdate(): void {
    const { store, surface } = this.designer;
    const now = `${surface.shown?.framing} ${unitOf(store.design)}`;
    if (now === this.chosenIn) return;
    this.chosenIn = now;
    this.step = null;
    this.centre = null;
  }

  override render() {
    return html`<details ?open=${this.isOpen} @toggle=${this.toggled}>
      <summary><h3>${words.heading}</h3><span>${words.about}</span></summary>
      ${this.isOpen ? this.content() : nothing}
    </details>`;
  }

  private content() {
    const { designer } = this;
    const selected = selectedIds(designer.state);
    const several = selected.length > 1;
    return html`
      ${this.isLocked ? html`<p class="locked">${icon("locked")}${handling.locked}</p>` : nothing}
      ${
        several
          ? this.order(selected.length)
          : this.group("", [this.press(words.onTable, () => putOnTable(designer.state, this.boxes))])
      }
      ${this.group(
        words.mirror,
        AXES.map((axis) => this.press(words.ways[axis] ?? "", () => mirrorParts(designer.state, this.boxes, axis))),
      )}
      ${this.copies()}
    `;
  }

  private order(count: number) {
    const { designer } = this;
    const align = (axis: Axis) =>
      SIDES.map((side) =>
        this.press(words.sides[axis]?.[side] ?? "", () => alignParts(designer.state, this.boxes, axis, side)),
      );
    return html`
      <div role="group" aria-labelledby="align">
        <h4 id="align">${words.align}</h4>
        ${AXES.map((axis) => html`<div class="row">${align(axis)}</div>`)}
        <div class="row">
          ${this.press(words.onAxis, () => alignOnAxis(designer.state, middlesOf(designer)))}
          ${this.press(words.onTable, () => putOnTable(designer.state, this.boxes))}
        </div>
        <div class="row">
          ${this.press(words.onRim, () => standOn(designer.state, this.boxes, this.rims, false), words.onRimNote)}
          ${this.press(words.onRimFitted, () => standOn(designer.state, this.boxes, this.rims, true), words.onRimNote)}
        </div>
        <div class="row">${this.push("sideways")}${this.push("upright")}</div>
        <p class="problem" role="status">${this.saidOfPush()}</p>
      </div>
      ${this.group(
        words.distribute,
        AXES.map((axis) =>
          this.press(
            words.ways[axis] ?? "",
            () => distributeParts(designer.state, this.boxes, axis),
            words.distributeNote,
            count < 3 || this.isLocked,
          ),
        ),
      )}
    `;
  }

  private push(course: Course) {
    const cannot = looseIds(this.designer.state).length < 1 || this.pushing;
    return html`<button
      class="button outlined"
      type="button"
      title=${words.onWallNote}
      data-push=${course}
      aria-disabled=${cannot ? "true" : nothing}
      @click=${() => cannot || void this.pushOnto(course)}
    >
      ${course === "sideways" ? words.onWall : words.onWallUpright}
    </button>`;
  }

  private async pushOnto(course: Course): Promise<void> {
    const { designer } = this;
    this.pushing = true;
    this.pushed = null;
    const became = await onceKnown(designer, () => pushOnto(designer, course));
    this.pushing = false;
    if (became !== "partly" && became !== "nowhere") return;
    const selected = selectedIds(designer.state).join();
    this.pushed = { said: words.pushed[became], of: designer.state.design, selected };
  }

  private saidOfPush(): string {
    const { pushed } = this;
    const { state: now } = this.designer;
    return pushed?.of === now.design && pushed.selected === selectedIds(now).join() ? pushed.said : "";
  }

  private copies() {
    const { designer } = this;
    const unit = unitOf(designer.store.design);
    const { step, centre, wide } = this.proposed();
    const far = (point: readonly number[]) => 10 * Math.max(...point.map(Math.abs), wide);
    const by = roundStep(wide) / 10;
    const number = (
      key: string,
      label: string,
      value: number,
      range: readonly [number, number, number],
      set: (value: number) => void,
      of = unit as string,
      help = "",
      counts?: readonly [least: number, most: number],
    ) =>
      html`<pasu-number
        data-field="arrange-${key}"
        .label=${label}
        .help=${help}
        .within=${counts}
        .counted=${counts !== undefined}
        .unit=${of}
        .value=${value}
        .min=${range[0]}
        .max=${range[1]}
        .step=${range[2]}
        @number-change=${({ value: now }: NumberChangeEvent) => set(now)}
      ></pasu-number>`;
    return html`<div role="group" aria-labelledby="copies">
        <h4 id="copies">${words.copies}</h4>
        ${number(
          "count",
          words.count,
          this.count,
          [2, MOST_COPIES, 1],
          (value) => {
            this.count = value;
          },
          "",
          words.countHelp,
          [2, LIMITS.parts],
        )}
      </div>
      <div role="group" aria-labelledby="row">
        <h5 id="row">${words.row}</h5>
        ${AXES.map((axis) =>
          number(`step-${axis}`, words.steps[axis] ?? "", step[axis], [-far(step), far(step), by], (value) => {
            this.step = step.map((each, i) => (i === axis ? value : each)) as unknown as Triple;
          }),
        )}
        <div class="row">${this.press(words.makeRow, () => this.checked(rowOfParts(designer.state, this.count, step)), "", false)}</div>
      </div>
      <div role="group" aria-labelledby="ring">
        <h5 id="ring">${words.ring}</h5>
        ${number(
          "angle",
          words.angle,
          this.angle,
          [-ALL_ROUND, ALL_ROUND, 1],
          (value) => {
            this.angle = value;
          },
          words.degree,
          words.angleHelp,
        )}
        ${([0, 1] as const).map((axis) =>
          number(
            `centre-${axis}`,
            words.centres[axis] ?? "",
            centre[axis],
            [-far(centre), far(centre), by],
            (value) => {
              this.centre = axis === 0 ? [value, centre[1]] : [centre[0], value];
            },
          ),
        )}
        <label class="check">
          <input
            type="checkbox"
            .checked=${this.turning}
            @change=${(event: Event) => {
              this.turning = (event.target as HTMLInputElement).checked;
            }}
          />
          ${words.turning}
        </label>
        <div class="row">
          ${this.press(
            words.makeRing,
            () =>
              this.checked(ringOfParts(designer.state, this.count, (this.angle / 180) * Math.PI, centre, this.turning)),
            "",
            false,
          )}
        </div>
      </div>
      <p class="problem" role="status">${this.saidOfCopies()}</p>`;
  }

  /** Beside each other with a gap; round the middle of the others, or where there are none beside the part. */
  private proposed(): { readonly step: Triple; readonly centre: readonly [number, number]; readonly wide: number } {
    const selected = selectedIds(this.designer.state);
    const all = [...this.boxes];
    const own = all.filter(([id]) => selected.includes(id)).map(([, box]) => box);
    const wide = Math.max(...own.map((box) => box.max[0] - box.min[0]), 0) || 1;
    const last = roundStep(wide) / 10;
    const rounded = (value: number) => roundTo(value, last);
    const others = all.filter(([id]) => !selected.includes(id)).map(([, box]) => box);
    const around = others.sort((a, b) => longestOf(b) - longestOf(a))[0];
    const [x, y] = around ? middleOf(around) : [BESIDE * wide, 0];
    return {
      step: this.step ?? [rounded(BESIDE * wide), 0, 0],
      centre: this.centre ?? [rounded(x), rounded(y)],
      wide,
    };
  }

  private get boxes() {
    return boxesOf(this.designer);
  }

  private get rims() {
    const { shown } = this.designer.surface;
    const found = (shown?.solved.parts ?? []).flatMap((part, place) => {
      const kind = shown?.design.parts[place]?.shape.kind;
      const rims = kind && rimsOf(part, kind);
      return rims ? [[part.id, rims] as const] : [];
    });
    return new Map(found);
  }

  private checked(change: Change): Change {
    const { state: now } = this.designer;
    const asked = { count: this.count, of: now.design, selected: selectedIds(now).join() };
    this.refused = change.undo === "none" ? asked : null;
    return change;
  }

  private saidOfCopies(): string {
    const { refused, count } = this;
    const { state: now } = this.designer;
    const isSame = refused?.of === now.design && refused.selected === selectedIds(now).join();
    return isSame && refused.count === count ? partWords.tooMany(LIMITS.parts) : "";
  }

  private group(heading: string, content: readonly unknown[]) {
    return html`<div role="group" aria-label=${heading === "" ? words.heading : heading}>
      ${heading === "" ? nothing : html`<h4>${heading}</h4>`}
      <div class="row">${content}</div>
    </div>`;
  }

  /** What is locked stays; copies of it move nothing. */
  private get isLocked(): boolean {
    return looseIds(this.designer.state).length === 0;
  }

  private press(label: string, change: () => Change, note = "", disabled = this.isLocked) {
    return html`<button
      class="button outlined"
      type="button"
      title=${note === "" ? nothing : note}
      ?disabled=${disabled}
      @click=${() => void onceKnown(this.designer, () => this.designer.apply(change()))}
    >
      ${label}
    </button>`;
  }

  private readonly toggled = (event: Event): void => {
    this.isOpen = (event.target as HTMLDetailsElement).open;
  };

  static override readonly styles = [
    base,
    buttons,
    disclosure,
    css`
      :host {
        display: block;
      }
      h4 {
        padding: 10px 0 4px;
        font-size: 0.9rem;
        font-weight: 600;
      }
      h5 {
        margin: 0;
        padding: 10px 0 2px;
        color: var(--soft);
        font-size: 0.86rem;
        font-weight: 600;
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        gap: 5px;
        padding: 2px 0 3px;
      }
      .row .button {
        min-height: 34px;
        padding: 0 11px;
        font-size: 0.88rem;
      }
      .check {
        display: flex;
        align-items: center;
        gap: 9px;
        min-height: 34px;
        cursor: pointer;
      }
      .check input {
        width: 1.05rem;
        height: 1.05rem;
        margin: 0;
        accent-color: var(--accent);
      }
      .locked {
        display: flex;
        align-items: center;
        gap: 6px;
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.88rem;
      }
      .problem {
        color: var(--warn);
        font-size: 0.88rem;
      }
      @media (pointer: coarse) {
        .row .button,
        .check {
          min-height: var(--touch);
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-arrange": PasuArrange;
  }
}
