/** Whether the parts of a scene fit together: one sentence for everything that is wrong, where that is, and what would mend it. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { type Mend, mendsOf, toldOf } from "../../document/breaches";
import { unitOf } from "../../document/look";
import type { Breach, Constraints, Design } from "../../document/types";
import { UnhurriedElement } from "../../element/unhurried";
import { deleteParts, glueTogether, splitOff } from "../../state/scene-actions";
import { selectParts } from "../../state/seen-actions";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";
import { breachWords, keptWords, nameAt } from "../../words/constraints";
import { constraints as words } from "../../words/english/constraints";
import { page } from "../../words/english/page";
import { lengthWords } from "../../words/quantities";
import { refusalWords } from "../../words/refusals";
import { type Mended, moveApart, moveTogether } from "../../work/mending";
import { SIGNS, sentenceStyles, sentences, spoken } from "../sentences";

/** More are listed when they are asked for. */
const FEW = 5;
/** Digits of how far something was moved. */
const DIGITS = 3;

@customElement("pasu-constraints")
export class PasuConstraints extends UnhurriedElement {
  @state() private all = false;
  /** What is being mended. */
  @state() private mending: Breach | null = null;
  @query("#fit") private readonly heading!: HTMLElement;

  /** How tall it was when it knew: while it does not, what lies below stays where it is, and is neither laid out nor painted again. */
  private tall = 0;
  private readonly sized = new ResizeObserver(() => {
    if (this.known) this.tall = this.getBoundingClientRect().height;
  });

  override connectedCallback(): void {
    super.connectedCallback();
    this.sized.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sized.disconnect();
  }

  override updated(): void {
    this.style.setProperty("min-height", this.known ? "" : `${this.tall}px`);
  }

  /** Nothing is said of the scene before this one. */
  private get known() {
    const { made } = this.designer;
    const piece = made?.constraints;
    return piece && made.isOfNow(piece) && (piece.value || piece.problem) ? piece : null;
  }

  override render() {
    const { known } = this;
    const { design } = this.designer.store;
    // Of what is no design nothing is checked, as long as it is none.
    const isRefused = this.designer.surface.status === "error";
    return html`<section aria-labelledby="fit" aria-busy=${known || isRefused ? "false" : "true"}>
      <h4 id="fit" tabindex="-1">${words.heading}</h4>
      ${
        known?.problem
          ? sentences([{ severity: "error", text: refusalWords(known.problem, design) }])
          : known?.value
            ? this.found(known.value, design)
            : isRefused
              ? nothing
              : html`<p class="wait" role="status">${page.checking}</p>`
      }
    </section>`;
  }

  private found(constraints: Constraints, design: Design) {
    const told = toldOf(constraints);
    const worst = told[0]?.severity ?? "note";
    const listed = this.all ? told : told.slice(0, FEW);
    return html`
      ${worst === "note" ? sentences([{ severity: "good", text: keptWords(design) }]) : nothing}
      <ul class="reports">${listed.map((breach) => this.report(breach, design))}</ul>
      ${
        listed.length < told.length
          ? html`<button class="button outlined" type="button" @click=${this.showAll}>${words.all(told.length)}</button>`
          : nothing
      }
      ${constraints.leftOut > 0 ? html`<p class="wait">${words.leftOut(constraints.leftOut)}</p>` : nothing}
    `;
  }

  private report(breach: Breach, design: Design) {
    const { designer, mending } = this;
    const { severity } = breach;
    const shown = designer.witness.shown?.breach === breach;
    const mends = mendsOf(breach, design);
    return html`<li class=${severity} data-code=${breach.code}>
      <button
        class="told"
        type="button"
        aria-pressed=${shown ? "true" : "false"}
        title=${words.shows}
        @click=${() => this.show(breach, design)}
      >
        ${icon(SIGNS[severity])}<span><span class="spoken">${spoken(severity)}</span>${breachWords(breach, design)}</span>
      </button>
      ${
        mends.length === 0
          ? nothing
          : html`<div class="mends">
              ${mends.map(
                (mend) => html`<button
                  class="button outlined"
                  type="button"
                  data-mend=${mend}
                  aria-disabled=${mending ? "true" : nothing}
                  @click=${() => mending || void this.mend(mend, breach, design)}
                >
                  ${mendWords(mend, breach, design)}
                </button>`,
              )}
              ${mending === breach ? html`<span class="wait" role="status">${page.checking}</span>` : nothing}
            </div>`
      }
    </li>`;
  }

  /** Selects the parts that it is about and marks the place on the stage; pressed again it is no longer marked. */
  private show(breach: Breach, design: Design): void {
    const { store, witness } = this.designer;
    const again = witness.shown?.breach === breach;
    witness.show(again ? null : { breach, of: design });
    if (again) return;
    // The one that is told of by name, or that is next to the other, comes last.
    const places = [breach.other, ...breach.group.filter((place) => place !== breach.part), breach.part];
    this.designer.apply(selectParts(...places.flatMap((place) => store.ids[place] ?? [])));
  }

  private async mend(mend: Mend, breach: Breach, design: Design): Promise<void> {
    const { designer } = this;
    const { state: now } = designer;
    const [part, other] = [breach.part, breach.other].map((place) => now.ids[place]);
    if (now.design !== design || part === undefined || other === undefined) return;
    switch (mend) {
      case "glue":
        designer.apply(glueTogether(now, [part, other]));
        return this.leave();
      case "separate":
        designer.apply(
          splitOff(
            now,
            breach.group.flatMap((place) => now.ids[place] ?? []),
          ),
        );
        return this.leave();
      case "remove":
        if (now.session.locked.includes(part))
          return designer.notices.say(words.lockedPart(nameAt(breach.part, design)));
        designer.apply(deleteParts(now, [part]));
        return this.leave();
      case "apart":
      case "together": {
        this.mending = breach;
        const mended = await (mend === "apart" ? moveApart(designer, breach) : moveTogether(designer, breach));
        this.mending = null;
        if (mended.state === "moved") this.leave();
        const said = this.becameOf(mended, mend, design);
        if (said !== "") designer.notices.say(said);
      }
    }
  }

  /** What is mended goes, or went a moment ago, and the button that was pressed with it: the focus stays in the card, unless it is elsewhere by now. */
  private leave(): void {
    const isLost = document.activeElement === document.body;
    if (isLost || this.shadowRoot?.activeElement) this.heading.focus({ preventScroll: true });
  }

  private becameOf(mended: Mended, mend: Mend, design: Design): string {
    switch (mended.state) {
      case "superseded":
        return "";
      case "locked":
        return words.locked;
      case "nowhere":
        return mend === "apart" ? words.notApart : words.notTogether;
      case "moved": {
        const names = mended.ids.map((id) => nameAt(this.designer.store.ids.indexOf(id), design));
        return words.moved(names, lengthWords(mended.by, unitOf(design), DIGITS));
      }
    }
  }

  private readonly showAll = (): void => {
    this.all = true;
    // The button goes: the first of those that were not listed is read next.
    void this.updateComplete.then(() => this.renderRoot.querySelectorAll<HTMLElement>(".told")[FEW]?.focus());
  };

  static override readonly styles = [
    base,
    buttons,
    sentenceStyles,
    css`
      :host {
        display: block;
        padding-top: 8px;
      }
      h4 {
        color: var(--soft);
        font-size: 0.9rem;
        font-weight: 600;
      }
      .wait {
        color: var(--soft);
        font-size: 0.92rem;
      }
      .reports {
        display: grid;
        gap: 4px;
        padding-top: 4px;
      }
      .told {
        display: flex;
        gap: 9px;
        width: 100%;
        min-height: var(--touch);
        padding: 7px 8px;
        border: 1px solid transparent;
        border-radius: 8px;
        background: none;
        line-height: 1.4;
        text-align: start;
        text-wrap: pretty;
        cursor: pointer;
      }
      /* Names may be long, and of one word. */
      .told > span,
      .mends .button {
        min-width: 0;
        overflow-wrap: anywhere;
      }
      .told:hover {
        background: var(--well);
      }
      .told[aria-pressed="true"] {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      .told .icon {
        width: 1.125rem;
        height: 1.125rem;
        margin-top: 2px;
        color: var(--soft);
      }
      .error .told,
      .error .told .icon,
      .warning .told .icon {
        color: var(--warn);
      }
      .mends {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 5px;
        padding: 4px 8px 6px 34px;
      }
      .mends .button {
        min-height: 34px;
        padding: 4px 11px;
        font-size: 0.88rem;
        white-space: normal;
      }
      @media (pointer: coarse) {
        .mends .button {
          min-height: var(--touch);
        }
      }
      @media (forced-colors: active) {
        .told[aria-pressed="true"] {
          outline: 2px solid Highlight;
        }
      }
    `,
  ];
}

function mendWords(mend: Mend, { group, part }: Breach, design: Design): string {
  const said = words.mends[mend];
  if (typeof said === "string") return said;
  return mend === "remove" ? words.mends.remove(nameAt(part, design)) : words.mends[mend as "together"](group.length);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-constraints": PasuConstraints;
  }
}
