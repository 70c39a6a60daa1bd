/** The design on the stage held against another scene: its parts in the colours of what became of them, those of the other hatched in their places, and a list of all. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { type Fate, fatesOf, type Group, groupsOf } from "../../document/fates";
import { isolated } from "../../language";
import { type Colour, Tints } from "../../render/contrast/tints";
import type { Stage } from "../../render/stage";
import { selectParts } from "../../state/seen-actions";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";
import { comparing as words } from "../../words/english/comparing";
import { page } from "../../words/english/page";
import { partName } from "../../words/parts";
import { refusalWords } from "../../words/refusals";
import { contrastDesk, type Told } from "../../work/contrast-desk";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";
import { stageModel } from "../stage-model";
import { colourOf, cssOf } from "./colours";

/** Of the other scene, what is shown besides: what is as it was needs no second picture. */
const SHOWN: readonly Fate[] = ["changed", "moved", "gone"];
/** Where there is room for a list that is open from the first. */
const WIDE = "(min-width: 53.7em)";

@customElement("pasu-contrast")
export class PasuContrast extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @state() private isOpen = matchMedia(WIDE).matches;
  private readonly lent = new Lent(this, (bench) => new Tints(bench));
  /** The other scene that was brought into the picture last. */
  private framed: unknown = null;
  /** What the colours are of. */
  private drawn: readonly unknown[] = [];

  override render() {
    const { designer } = this;
    const { there } = designer.contrast;
    const desk = contrastDesk(designer);
    const { told } = desk;
    const title = words.with(isolated(there?.title ?? page.untitled));
    return html`<section aria-label=${title}>
      <div class="bar">
        <button
          class="button"
          type="button"
          aria-expanded=${this.isOpen ? "true" : "false"}
          aria-controls="list"
          @click=${this.toggle}
        >
          ${icon("compare")}<span>${title}</span>
        </button>
        <button class="button bare" type="button" aria-label=${words.close} title=${words.close} @click=${this.close}>
          ${icon("close")}
        </button>
      </div>
      <div id="list" ?hidden=${!this.isOpen}>
        ${
          desk.problem
            ? html`<p role="status">${words.refused(refusalWords(desk.problem))}</p>`
            : told
              ? this.list(told)
              : html`<p role="status">${page.checking}</p>`
        }
      </div>
    </section>`;
  }

  override updated(): void {
    const { designer } = this;
    const { tool: tints } = this.lent;
    const desk = contrastDesk(designer);
    desk.follow();
    const { shown } = designer.surface;
    // Of another design than the one that is drawn there are no colours.
    const told = desk.told?.here === shown?.design ? desk.told : null;
    const { seen } = desk;
    const now = [tints, told, seen, shown];
    if (!tints || now.every((each, at) => each === this.drawn[at])) return;
    this.drawn = now;
    const own = new Map<number, Colour>();
    for (const [place, fate] of told ? fatesOf(told.difference, "after") : []) {
      const colour = colourOf(fate);
      if (colour) own.set(place, colour);
    }
    const others = [...(told && seen ? fatesOf(told.difference, "before") : [])].filter(([, fate]) =>
      SHOWN.includes(fate),
    );
    const model = seen ? stageModel(seen.there, seen.solved) : { parts: [], bounds: null };
    const parts = others.flatMap(([place]) => model.parts[place] ?? []);
    const colours = others.map(([, fate]) => colourOf(fate) ?? ([1, 1, 1] as const));
    tints.show(own, { parts, bounds: parts.length > 0 ? model.bounds : null }, colours);
    if (told && seen && this.framed !== seen) {
      this.framed = seen;
      this.frame(tints);
    }
    for (const swatch of this.renderRoot.querySelectorAll<HTMLElement>("[data-swatch]")) {
      const colour = colourOf(swatch.dataset.swatch as Fate);
      if (colour) swatch.style.setProperty("--of", cssOf(colour));
    }
  }

  /** Once for each other scene: all of both is seen, beside the list where that is open. */
  private frame(tints: Tints): void {
    const taken = this.isOpen ? this.getBoundingClientRect().width : 0;
    tints.frame(taken);
    // As by a hand: nothing fits the view again by itself.
    this.stage?.pan(taken / 2, 0);
  }

  private list({ difference, here, there }: Told) {
    if (difference.isSame) return html`<p role="status" class="verdict">${words.same}</p>`;
    const groups = groupsOf(difference).filter(({ parts }) => parts.length > 0);
    const hatched = groups.some(({ which }) => SHOWN.includes(which));
    return html`<div class="groups">
        ${groups.map(
          (group) => html`<div role="group" aria-label=${words[group.which]} data-fate=${group.which}>
            <p class="fate"><span class="swatch" data-swatch=${group.which} aria-hidden="true"></span>${words[group.which]}</p>
            <div class="parts">${group.parts.map((part) => this.entry(part, here.parts, there.parts))}</div>
          </div>`,
        )}
      </div>
      ${hatched ? html`<p class="hint">${words.hatched}</p>` : nothing}`;
  }

  private entry({ before, after }: Group["parts"][number], here: Told["here"]["parts"], there: Told["there"]["parts"]) {
    if (after === undefined)
      return html`<span class="part">${before === undefined ? "" : partName(before, there[before]?.name)}</span>`;
    const name = partName(after, here[after]?.name);
    const other = before === undefined ? name : partName(before, there[before]?.name);
    return html`<button class="part" type="button" title=${words.select(name)} @click=${() => this.select(after)}>
      <span>${name}</span>${other === name ? nothing : html` <small>${words.there(isolated(other))}</small>`}
    </button>`;
  }

  private select(place: number): void {
    const id = this.designer.store.ids[place];
    if (id !== undefined) this.designer.apply(selectParts(id));
  }

  private readonly toggle = (): void => {
    this.isOpen = !this.isOpen;
  };

  /** The focus goes back to the stage that this lies on. */
  private readonly close = (): void => {
    const { host } = this.getRootNode() as ShadowRoot;
    this.designer.contrast.close();
    (host as HTMLElement).focus({ preventScroll: true });
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        position: absolute;
        z-index: 5;
        inset: 14px auto auto 14px;
        display: grid;
        grid-template-rows: minmax(0, 1fr);
        max-width: min(300px, calc(100% - 28px));
        max-height: calc(100% - 120px);
        pointer-events: none;
      }
      section {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        min-height: 0;
        border: 1px solid var(--line);
        border-radius: 12px;
        background: var(--sheet);
        box-shadow: 0 8px 26px var(--shadow);
        pointer-events: auto;
      }
      .bar {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      .bar .button:first-child {
        min-width: 0;
        justify-content: start;
        overflow-wrap: anywhere;
        text-align: start;
        white-space: normal;
      }
      #list {
        padding: 0 12px 10px;
        overflow-y: auto;
        overscroll-behavior: contain;
        font-size: 0.92rem;
      }
      .groups {
        display: grid;
        gap: 9px;
      }
      .fate {
        display: flex;
        align-items: center;
        gap: 8px;
        color: var(--soft);
        font-size: 0.86rem;
      }
      .swatch {
        flex: none;
        width: 14px;
        height: 14px;
        border: 1px solid var(--edge);
        border-radius: 4px;
        background: var(--of, transparent);
      }
      .parts {
        display: flex;
        flex-wrap: wrap;
        gap: 5px;
        padding-top: 4px;
      }
      .part {
        display: inline-flex;
        align-items: center;
        gap: 6px;
        min-height: 32px;
        padding: 0 9px;
        border: 1px solid var(--line);
        border-radius: 8px;
        background: transparent;
        overflow-wrap: anywhere;
      }
      span.part {
        border-style: dashed;
      }
      button.part {
        cursor: pointer;
      }
      button.part:hover {
        border-color: var(--edge);
      }
      small,
      .hint,
      #list > p[role="status"]:not(.verdict) {
        color: var(--soft);
      }
      .hint {
        padding-top: 8px;
        font-size: 0.86rem;
      }
      @media (pointer: coarse) {
        .part {
          min-height: var(--touch);
        }
      }
      @media (max-width: 53.6875em) {
        :host {
          inset: 8px auto auto 8px;
          max-width: 68%;
          max-height: calc(100% - 100px);
        }
      }
      @media (forced-colors: active) {
        .swatch {
          forced-color-adjust: none;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-contrast": PasuContrast;
  }
}
