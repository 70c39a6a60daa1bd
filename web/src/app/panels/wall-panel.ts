/** The wall of the selected part: whether it is a pot at all, how thick, and what its rim and its foot are like. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { closes, isRound } from "../../document/closes";
import { unitOf } from "../../document/look";
import { pathText } from "../../document/path";
import { DEFAULTS } from "../../document/tables.gen";
import type { Shape, Wall } from "../../document/types";
import { isThickness, type WallField, wallFields, wallNumber, wallRange } from "../../document/wall";
import { DesignerElement } from "../../element/designer-element";
import { longest } from "../../solver/solved";
import { toggleExplain } from "../../state/actions";
import { setFootRing, setLining, setPot, setRim, setSide, setWallNumber } from "../../state/wall-actions";
import { checks } from "../../ui/checks";
import { choiceStyles, choices } from "../../ui/choices";
import { icon } from "../../ui/icons";
import { CommandEvent } from "../command";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";
import { base, buttons } from "../../ui/styles";
import { page } from "../../words/english/page";
import { wall as words } from "../../words/english/wall";
import { refusalWords, whyWords } from "../../words/refusals";
import { fittedWords } from "../../words/remedies";
import { explainButton } from "./explain-button";
import { isThinned, remedies, remedyStyles } from "./remedies";

/** How many waves a soft inside keeps at first, and at most by its slider. */
const SOFT = 3;
const MOST_WAVES = 12;

@customElement("pasu-wall")
export class PasuWall extends DesignerElement {
  private size = 1;
  private focused = false;

  override willUpdate(): void {
    this.focused = this.shadowRoot?.activeElement != null;
    const solved = this.designer.surface.shown?.solved;
    if (solved) this.size = longest(solved);
  }

  /** With the wall most of this comes or goes, and with it what had the focus: then the button has it that does the opposite, or what is said where there is none. */
  override updated(): void {
    if (!this.focused || this.shadowRoot?.activeElement) return;
    const find = (what: string) => this.renderRoot.querySelector<HTMLElement>(what);
    (find(".walling") ?? find(".lead"))?.focus();
  }

  override render() {
    const { designer } = this;
    const { design, part } = designer.state;
    const wall = design.parts[part]?.wall;
    const shape = design.parts[part]?.shape;
    if (!shape) return nothing;
    const isPatched = isThickness(shape.kind);
    if (closes(shape)) return this.closed(wall !== undefined);
    if (!wall) {
      // A wall takes closed sections to go round between.
      if (shape.kind === "blend" && !isRound(shape))
        return html`<p class="lead" tabindex="-1">${words.isOpenBlend}</p>`;
      const lead = isPatched ? words.isNetwork : shape.kind === "blend" ? words.isBlend : words.isSurface;
      return html`<p class="lead">${lead}</p>
        <button class="button primary walling" type="button" @click=${() => designer.apply(setPot(designer.state, true, this.size))}>
          ${isPatched ? words.thicken : words.makePot}
        </button>`;
    }
    return html`
      <div class="head">
        ${explainButton(designer.store.session.explain, () => designer.apply(toggleExplain(designer.state)))}
        <button class="button outlined walling" type="button" @click=${() => designer.apply(setPot(designer.state, false, this.size))}>
          ${words.remove}
        </button>
      </div>
      ${this.verdict(isPatched)} ${this.numbers(wall, shape.kind)}
      ${isPatched && !wall.foot && !wall.rim ? nothing : this.ends(wall)}
      ${choices(words.laid, told(isPatched ? words.sidesOfNetwork : words.sides), wall.side ?? DEFAULTS.side, (side) => designer.apply(setSide(designer.state, side)))}
      ${isPatched || (wall.side ?? DEFAULTS.side) === "outside" ? nothing : this.inside(wall)}
      <button class="button primary export" type="button" @click=${() => this.dispatchEvent(new CommandEvent("export"))}>
        ${icon("make")}<span>${words.export}</span>
      </button>
    `;
  }

  /** What goes round a body has no edge for a wall to end at. It may have got one in a file, or before it was closed. */
  private closed(isWalled: boolean) {
    const { designer } = this;
    return html`<p class="lead" tabindex="-1">${words.closed}</p>
      ${
        isWalled
          ? html`<p class="problem" role="status">${icon("warn")}<span>${words.closedWall}</span></p>
              <button class="button primary walling" type="button" @click=${() => designer.apply(setPot(designer.state, false, this.size))}>
                ${words.remove}
              </button>`
          : nothing
      }`;
  }

  /** What a wall is like below and above. */
  private ends(wall: Wall) {
    const { designer } = this;
    return html`<label class="check">
        <input
          type="checkbox"
          .checked=${wall.foot !== undefined}
          @change=${(event: Event) =>
            designer.apply(setFootRing(designer.state, (event.target as HTMLInputElement).checked))}
        />
        <span>${words.footRing}</span>
      </label>
      ${choices(words.rim, told(words.rims), wall.rim ?? DEFAULTS.rim, (rim) => designer.apply(setRim(designer.state, rim)))}
    `;
  }

  /** Whether the inside follows the outside, is round, or keeps some of its waves. */
  private inside(wall: Wall) {
    const { designer } = this;
    const waves = wall.lining ? (wall.lining.waves ?? 0) : null;
    const kind = waves === null ? "follows" : waves === 0 ? "round" : "soft";
    const kept = { follows: null, round: 0, soft: SOFT } as const;
    return html`${choices(words.inside, told(words.insides), kind, (kind) => designer.apply(setLining(designer.state, kept[kind])))}
    ${
      kind === "soft"
        ? html`<pasu-number
            data-field="lining"
            .label=${words.keptWaves.name}
            .help=${words.keptWaves.help}
            .value=${waves ?? SOFT}
            .min=${1}
            .max=${MOST_WAVES}
            .step=${1}
            .explain=${designer.store.session.explain}
            @number-change=${(event: NumberChangeEvent) =>
              designer.apply(setLining(designer.state, Math.max(1, Math.round(event.value)), event.gesture))}
            @number-done=${() => designer.store.endGesture()}
            @number-cancel=${() => designer.store.cancelGesture()}
          ></pasu-number>`
        : nothing
    }`;
  }

  /** Why it is no pot, in the solver's words; or how much it holds, and what of it was fitted. */
  private verdict(isPatched: boolean) {
    const { designer } = this;
    const { made } = designer;
    // Nothing is said of the wall before this one.
    const problem = made?.wallProblem ?? null;
    if (problem)
      return html`<p class="problem" role="status">${icon("warn")}<span>${refusalWords(problem, designer.state.design)}</span></p>
        ${remedies(designer)}`;
    // Patches hold nothing: what there is to say is that they are a body.
    if (isPatched && made?.isOfNow(made.solid) && made.solid.value)
      return html`<p class="holds" role="status">${words.thickened}</p>`;
    const measures = made?.measures;
    const unmeasured = measures && made.isOfNow(measures) && measures.problem;
    const held = unmeasured ? refusalWords(unmeasured, designer.state.design) : made?.holds;
    return html`<p class="holds" role="status">${held ?? html`<span class="wait">${page.checking}</span>`}</p>
      ${this.fitted()}`;
  }

  /** What is made otherwise than asked for, for want of room, with a button that says so in the document. */
  private fitted() {
    const { designer } = this;
    const { made, state } = designer;
    const reported = made?.report.of === state.design ? (made.report.value?.findings ?? []) : [];
    const found = reported.filter(({ part }) => part === state.part);
    const told = found.flatMap((finding) => fittedWords(finding, unitOf(state.design)) ?? []);
    if (isThinned(designer, state.part)) told.push(words.thinned);
    if (told.length === 0) return nothing;
    return html`${told.map((text) => html`<p class="problem" role="status">${icon("warn")}<span>${text}</span></p>`)}
      ${remedies(designer)}`;
  }

  private numbers(wall: Wall, kind: Shape["kind"]) {
    const { designer } = this;
    return wallFields(wall, kind).map((field) => {
      // The ranges go by the pot that was opened: no number moves the range of another.
      const { max, step } = wallRange(field, designer.origin.size ?? this.size);
      const { name, help } = words.fields[field.key];
      // Of a network nothing is thinned.
      const meant = isThickness(kind) && field.key === "thickness" ? words.thickenedHelp : help;
      return html`<pasu-number
        data-field=${field.key}
        .label=${name}
        .unit=${unitOf(designer.store.design)}
        .help=${meant}
        .problem=${this.problemOf(field)}
        .value=${wallNumber(wall, field)}
        .min=${0}
        .max=${max}
        .step=${step}
        .explain=${designer.store.session.explain}
        @number-change=${(event: NumberChangeEvent) =>
          designer.apply(setWallNumber(designer.state, field, event.value, event.gesture))}
        @number-done=${() => designer.store.endGesture()}
        @number-cancel=${() => designer.store.cancelGesture()}
      ></pasu-number>`;
    });
  }

  /** The objection of whoever objects first, when it names this number. */
  private problemOf(field: WallField): string {
    const { made, state, surface } = this.designer;
    const path = pathText(["parts", state.part, "wall", ...field.path]);
    const named = [surface.problem, made?.wallProblem, made?.solid.problem].find((each) => each?.path === path);
    return named ? whyWords(named, unitOf(state.design)) : "";
  }

  static override readonly styles = [
    base,
    buttons,
    choiceStyles,
    remedyStyles,
    checks,
    css`
      :host {
        display: block;
      }
      .lead {
        padding-bottom: 14px;
        color: var(--soft);
        text-wrap: pretty;
      }
      .head {
        display: flex;
        justify-content: space-between;
        gap: 8px;
        padding-bottom: 8px;
      }
      .holds {
        min-height: 1.5em;
        margin: 6px 0 8px;
        color: var(--soft);
      }
      .wait {
        color: var(--soft);
      }
      .problem {
        display: flex;
        gap: 8px;
        margin: 2px 0 6px;
        padding: 8px 12px;
        border-radius: 9px;
        background: var(--warn-wash);
        color: var(--warn);
        font-size: 0.92rem;
      }
      .export {
        width: 100%;
        margin-top: 18px;
      }
    `,
  ];
}

/** Each value of a choice with its words. */
function told<T extends string>(all: Readonly<Record<T, { readonly label: string; readonly note: string }>>) {
  return (Object.keys(all) as T[]).map((value) => ({ value, ...all[value] }));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-wall": PasuWall;
  }
}
