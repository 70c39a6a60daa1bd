/** The small bar over the stage while whole parts are moved: what a hand does with them, and whether in steps. */

import { computed } from "@preact/signals-core";
import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { motionsBetween } from "../../document/carried";
import { unitOf } from "../../document/look";
import { moved } from "../../document/moving";
import { setHandling, toggleSnapping } from "../../state/actions";
import { placeParts, standingOf } from "../../state/place-actions";
import { HANDLINGS } from "../../state/session";
import { looseIds } from "../../state/several-actions";
import { barStyles } from "../../ui/bar";
import { segmented, segments } from "../../ui/segments";
import { base, buttons } from "../../ui/styles";
import { handling as words } from "../../words/english/handling";
import { degreesWords, lengthWords } from "../../words/quantities";
import { boxesOf, mannerOf } from "../../work/held";
import { DesignerElement } from "../designer-element";
import { toTable } from "./motion";

@customElement("pasu-place-bar")
export class PasuPlaceBar extends DesignerElement {
  // Apart from where parts are, so that a drag does not draw the bar, nor has the page laid out to know what is under it.
  readonly #unit = computed(() => unitOf(this.designer.store.design));
  readonly #loose = computed(() => looseIds(this.designer.store).length);
  /** Why nothing of it moves, or is not seen to. */
  readonly #note = computed(() => {
    const { store } = this.designer;
    const ids = looseIds(store);
    if (ids.length === 0) return words.locked;
    return ids.every((id) => store.session.hidden.includes(id)) ? words.unseen : "";
  });
  readonly #step = computed(() => mannerOf(this.designer)?.step ?? null);

  override render() {
    const { designer } = this;
    const { session } = designer.store;
    const loose = this.#loose.value;
    const note = this.#note.value;
    const step = lengthWords(this.#step.value ?? 1, this.#unit.value);
    return html`
      <div class="bar" role="group" aria-label=${words.tool}>
        ${segments(words.way, "way", HANDLINGS, session.handling, words.ways, null, (way) => designer.apply(setHandling(way)))}
        <label class="steps" title=${words.stepsHelp(step, degreesWords(15))}>
          <input
            type="checkbox"
            .checked=${session.snapping}
            @change=${() => designer.apply(toggleSnapping(designer.state))}
          />
          ${words.steps}
        </label>
        <button
          class="button"
          type="button"
          title=${words.toTableHelp}
          ?disabled=${loose === 0 || this.#step.value === null}
          @click=${this.toTable}
        >
          ${words.toTable}
        </button>
      </div>
      <p class="note" role="status" ?hidden=${note === ""}>${note}</p>
    `;
  }

  /** The pot under the bar stays clear of it. */
  override updated(): void {
    this.dispatchEvent(new Event("bar-shown"));
  }

  private readonly toTable = (): void => {
    const { designer } = this;
    const { state } = designer;
    const boxes = boxesOf(designer);
    const table = mannerOf(designer)?.table ?? 0;
    // What is shown may still follow the document.
    const { shown } = designer.surface;
    const since = shown ? motionsBetween(shown.design.parts, state.design.parts) : [];
    const places = looseIds(state).flatMap((id) => {
      const box = boxes.get(id);
      if (!box) return [];
      const size = box.max[2] - box.min[2];
      const low = box.min[2] + (since[state.ids.indexOf(id)]?.[14] ?? 0);
      return [[id, moved(standingOf(state, id), [0, 0, toTable(low, table, size)])] as const];
    });
    designer.apply(placeParts(state, new Map(places)));
  };

  static override readonly styles = [
    base,
    buttons,
    segmented,
    barStyles,
    css`
      .bar {
        flex-wrap: wrap;
      }
      .steps {
        display: flex;
        align-items: center;
        gap: 6px;
        min-height: 34px;
        cursor: pointer;
      }
      .steps input {
        width: 1.05rem;
        height: 1.05rem;
        margin: 0;
        accent-color: var(--accent);
      }
      .button {
        min-height: 34px;
        padding: 0 10px;
        font-size: 0.9rem;
        white-space: nowrap;
      }
      .note[hidden] {
        display: none;
      }
      .note {
        padding: 5px 11px;
        border-radius: 9px;
        background: var(--sheet);
        font-size: 0.88rem;
      }
      @media (pointer: coarse) {
        .steps,
        .button {
          min-height: var(--touch);
        }
      }
      @media (max-width: 53.6875em) {
        :host {
          inset: 4px 6px auto;
        }
        .bar {
          gap: 4px;
          padding: 3px 5px;
        }
        .button,
        fieldset label {
          padding: 0 6px;
        }
      }
      /* In one row on the smallest phones: what is moved lies below it. */
      @media (max-width: 22.5em) {
        .bar {
          gap: 2px;
        }
        .button,
        .steps,
        fieldset label {
          padding: 0 4px;
          font-size: 0.8rem;
        }
        .steps {
          gap: 3px;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-place-bar": PasuPlaceBar;
  }
}
