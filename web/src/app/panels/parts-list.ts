/** The parts of the pot, where there are several: which one the panels are about, what it is called, its place in the list, a copy of it, and away with it. */

import { css, html, nothing } from "lit";
import { customElement, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { DesignerElement } from "../../element/designer-element";
import { listed } from "../../language";
import type { PartId } from "../../state/part-ids";
import {
  deletePart,
  duplicatePart,
  gluePart,
  isTaken,
  MAX_NAME,
  movePart,
  objectOf,
  renamePart,
} from "../../state/scene-actions";
import { selectParts, togglePart } from "../../state/seen-actions";
import type { Change } from "../../state/store";
import { type IconName, icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { parts } from "../../words/english/parts";
import { partName } from "../../words/parts";
import { hiddenNote } from "../hidden-note";

/** How far beside a pot its copy stands, as a share of its width. */
const ASIDE = 1.1;

@customElement("pasu-parts")
export class PasuParts extends DesignerElement {
  @query("[role=listbox]") private readonly list!: HTMLElement;
  @query("input") private readonly name!: HTMLInputElement;
  /** The part that was brought into view last. */
  private followed: PartId | undefined;

  override render() {
    const { design, ids, part: place, session } = this.designer.store;
    const chosen = ids[place];
    if (chosen === undefined) return nothing;
    const objects = [...new Set(design.parts.map(objectOf))];
    const numberOf = (at: number) => 1 + objects.indexOf(design.parts.map(objectOf)[at] ?? 0);
    return html`<section aria-labelledby="parts">
      <h3 id="parts">${parts.heading}</h3>
      <ul
        role="listbox"
        tabindex="0"
        aria-labelledby="parts"
        aria-describedby="keys"
        aria-activedescendant="part-${chosen}"
        @keydown=${this.key}
      >
        ${repeat(
          ids,
          (id) => id,
          (id, at) => html`<li
            role="option"
            id="part-${id}"
            aria-selected=${id === chosen ? "true" : "false"}
            ?data-hidden=${session.hidden.includes(id)}
            @click=${() => this.designer.apply(selectParts(id))}
          >
            <span
              >${partName(at, design.parts[at]?.name)}${session.hidden.includes(id) ? html`<span class="spoken">${parts.isHidden}</span>` : nothing}</span
            >
            ${objects.length > 1 ? html`<span class="object"><span class="spoken">, </span>${parts.object(numberOf(at))}</span>` : html`<span></span>`}
            ${this.eye(id, session.hidden.includes(id))}
          </li>`,
        )}
      </ul>
      <p id="keys" class="spoken">${parts.keys}</p>
      <div class="tools">
        <input
          class="field"
          type="text"
          aria-label=${parts.name}
          aria-describedby="taken"
          autocomplete="off"
          maxlength=${MAX_NAME}
          placeholder=${partName(place, null)}
          .value=${design.parts[place]?.name ?? ""}
          @input=${this.typed}
          @change=${this.named}
          @blur=${this.named}
          @keydown=${(event: KeyboardEvent) => {
            if (event.key === "Enter") this.list.focus();
          }}
        />
        ${
          session.hidden.includes(chosen)
            ? this.button(parts.show, "hidden", false, () => togglePart(this.designer.state, chosen))
            : this.button(parts.hide, "seen", false, () => togglePart(this.designer.state, chosen))
        }
        ${this.button(parts.up, "up", place === 0, () => movePart(this.designer.state, chosen, -1))}
        ${this.button(parts.down, "down", place === ids.length - 1, () => movePart(this.designer.state, chosen, 1))}
        ${this.button(parts.duplicate, "copy", false, () => this.copy(chosen))}
        ${this.button(parts.delete, "remove", ids.length < 2, () => deletePart(this.designer.state, chosen))}
      </div>
      <p class="problem" id="taken" role="status"></p>
      ${ids.length > 1 ? this.glue(chosen) : nothing}
      ${hiddenNote(this.designer)}
    </section>`;
  }

  /** Brings the selected part into the list's view when another one was selected, without moving the panel. */
  override updated(): void {
    const { ids, part } = this.designer.store;
    const chosen = ids[part];
    const option = this.renderRoot.querySelector<HTMLElement>("[aria-selected=true]");
    if (chosen === this.followed || !option) return;
    this.followed = chosen;
    const [top, height] = [option.offsetTop - this.list.offsetTop, this.list.clientHeight];
    const { scrollTop } = this.list;
    if (top < scrollTop) this.list.scrollTop = top;
    else if (top + option.offsetHeight > scrollTop + height) this.list.scrollTop = top + option.offsetHeight - height;
  }

  /** What the part is glued to: the others of its object, those of another one, or nothing. */
  private glue(chosen: PartId) {
    const { design, ids } = this.designer.store;
    const own = design.parts[ids.indexOf(chosen)];
    const groups = new Map<number, PartId[]>();
    for (const [at, id] of ids.entries()) {
      const part = design.parts[at];
      if (!part || id === chosen) continue;
      groups.set(objectOf(part), [...(groups.get(objectOf(part)) ?? []), id]);
    }
    const names = (members: readonly PartId[]) =>
      listed(members.map((id) => partName(ids.indexOf(id), design.parts[ids.indexOf(id)]?.name)));
    return html`<label class="glue">
      <span>${parts.gluedTo}</span>
      <select
        class="field"
        @change=${(event: Event) => {
          const [other] = [...groups.values()][(event.target as HTMLSelectElement).selectedIndex - 1] ?? [];
          this.designer.apply(gluePart(this.designer.state, chosen, other ?? null));
        }}
      >
        <option .selected=${!own || !groups.has(objectOf(own))}>${parts.nothing}</option>
        ${[...groups].map(([object, members]) => html`<option .selected=${own !== undefined && objectOf(own) === object}>${names(members)}</option>`)}
      </select>
    </label>`;
  }

  /** For pointers: an option of a list can hold nothing that takes the focus, and the keyboard has H. */
  private eye(id: PartId, hidden: boolean) {
    const press = (event: Event) => {
      event.stopPropagation();
      this.designer.apply(togglePart(this.designer.state, id));
    };
    return html`<span class="eye" title=${hidden ? parts.show : parts.hide} @click=${press}>${icon(hidden ? "hidden" : "seen")}</span>`;
  }

  private button(label: string, name: IconName, disabled: boolean, change: () => Change) {
    return html`<button
      class="button bare"
      type="button"
      aria-label=${label}
      title=${label}
      ?disabled=${disabled}
      @click=${() => this.designer.apply(change())}
    >
      ${icon(name)}
    </button>`;
  }

  /** Beside everything that stands there, so that the copy is seen. */
  private copy(id: PartId): Change {
    const width = this.designer.surface.shown?.solved.facts?.width ?? 1;
    return duplicatePart(this.designer.state, id, Number((ASIDE * width).toPrecision(2)));
  }

  private readonly typed = (): void => {
    const { ids, part } = this.designer.store;
    const id = ids[part];
    if (id === undefined) return;
    const taken = isTaken(this.designer.state, id, this.name.value);
    this.say(taken ? parts.taken : "");
    if (!taken) this.designer.apply(renamePart(this.designer.state, id, this.name.value));
  };

  /** The typing is over. Where it ended with the name of another part it never happened. */
  private readonly named = (): void => {
    const { store } = this.designer;
    if (this.name.getAttribute("aria-invalid") === "true") store.cancelGesture();
    else store.endGesture();
    this.name.value = store.design.parts[store.part]?.name ?? "";
    this.say("");
  };

  private say(text: string): void {
    this.name.setAttribute("aria-invalid", text === "" ? "false" : "true");
    const place = this.renderRoot.querySelector("#taken");
    if (place) place.textContent = text;
  }

  private readonly key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey) return;
    const change = this.changeBy(event);
    if (!change) return;
    event.preventDefault();
    event.stopPropagation();
    if (change === "name") {
      this.name.focus();
      this.name.select();
    } else this.designer.apply(change);
  };

  private changeBy({ altKey, key }: KeyboardEvent): Change | "name" | null {
    const { state } = this.designer;
    const { ids, part } = state;
    const id = ids[part];
    if (id === undefined) return null;
    const select = (place: number) => selectParts(ids[Math.max(0, Math.min(ids.length - 1, place))] ?? id);
    switch (key) {
      case "ArrowUp":
        return altKey ? movePart(state, id, -1) : select(part - 1);
      case "ArrowDown":
        return altKey ? movePart(state, id, 1) : select(part + 1);
      case "Home":
        return select(0);
      case "End":
        return select(ids.length - 1);
      case "Delete":
      case "Backspace":
        return deletePart(state, id);
      case "d":
      case "D":
        return this.copy(id);
      case "h":
      case "H":
        return togglePart(state, id);
      case "F2":
        return "name";
      default:
        return null;
    }
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      :host {
        display: block;
      }
      section {
        padding-bottom: 14px;
      }
      h3 {
        padding-bottom: 4px;
        font-size: 1rem;
        font-weight: 650;
      }
      ul {
        max-height: 168px;
        overflow-y: auto;
        border: 1px solid var(--line);
        border-radius: var(--radius);
      }
      li {
        display: grid;
        grid-template-columns: 1fr auto auto;
        align-items: center;
        min-height: var(--touch);
        padding: 0 0 0 12px;
        overflow-wrap: anywhere;
        cursor: pointer;
      }
      li[data-hidden] {
        color: var(--soft);
      }
      .eye {
        display: grid;
        place-items: center;
        align-self: stretch;
        width: var(--touch);
        color: var(--soft);
      }
      .eye:hover {
        color: var(--ink);
      }
      .object {
        color: var(--soft);
        font-size: 0.86rem;
        font-weight: normal;
      }
      .glue {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr);
        align-items: center;
        gap: 10px;
        padding-top: 6px;
      }
      .glue span {
        color: var(--soft);
        font-size: 0.9rem;
      }
      .hint {
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.88rem;
      }
      li:hover {
        background: var(--well);
      }
      li[aria-selected="true"] {
        background: var(--accent-wash);
        color: var(--accent-strong);
        font-weight: 550;
      }
      .tools {
        display: flex;
        flex-wrap: wrap;
        gap: 4px;
        padding-top: 6px;
      }
      .tools .field {
        flex: 1 1 100px;
      }
      .problem {
        color: var(--warn);
        font-size: 0.88rem;
      }
      @media (max-width: 53.6875em) {
        /* Two and a half: that there are more is seen. */
        ul {
          max-height: 112px;
        }
      }
      @media (forced-colors: active) {
        li[aria-selected="true"] {
          outline: 2px solid Highlight;
          outline-offset: -2px;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-parts": PasuParts;
  }
}
