/** The parts of the pot, where there are several: which one the panels are about, what it is called, its place in the list, a copy of it, and away with it. */

import { css, html, nothing } from "lit";
import { customElement, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { Part } from "../../document/types";
import { UnhurriedElement } from "../../element/unhurried";
import { listed } from "../../language";
import { widthOf } from "../../solver/solved";
import type { PartId } from "../../state/part-ids";
import {
  deleteParts,
  duplicateParts,
  gluedTo,
  gluePart,
  glueTogether,
  isTaken,
  MAX_NAME,
  movePart,
  objectOf,
  renamePart,
  separateParts,
} from "../../state/scene-actions";
import { alsoSelect, selectedIds, selectParts, togglePart } from "../../state/seen-actions";
import type { Tab } from "../../state/session";
import { hideParts, lockParts, looseIds, selectThrough } from "../../state/several-actions";
import type { Change } from "../../state/store";
import { iconButton } from "../../ui/icon-button";
import { type IconName, icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { parts } from "../../words/english/parts";
import { partName } from "../../words/parts";
import { hiddenNote } from "../hidden-note";
import "./arrange-card";
import "./constraints-card";
import "./glue-matrix";
import "./joints-card";

/** Beside which panels it matters where the parts stand: to what is made and measured. What else is done to several is done beside their shape alone. */
const WHERE: readonly Tab[] = ["shape", "wall", "measures"];
/** How far beside a pot its copy stands, as a share of its width. */
const ASIDE = 1.1;

@customElement("pasu-parts")
export class PasuParts extends UnhurriedElement {
  @query("[role=listbox]") private readonly list!: HTMLElement;
  @query("input") private readonly name!: HTMLInputElement;
  /** The part that was brought into view last. */
  private followed: PartId | undefined;

  override render() {
    const { design, ids, part: place, session } = this.designer.store;
    const chosen = ids[place];
    if (chosen === undefined) return nothing;
    // Of hundreds of parts each is looked at once, with every movement of a hand.
    const counts = new Map<number, number>();
    for (const part of design.parts) counts.set(objectOf(part), 1 + (counts.get(objectOf(part)) ?? 0));
    const numbers = new Map([...counts.keys()].map((object, at) => [object, 1 + at]));
    const objectAt = (at: number) => objectOf(design.parts[at] as Part);
    const members = (at: number) => counts.get(objectAt(at)) ?? 1;
    const numberOf = (at: number) => numbers.get(objectAt(at)) ?? 1;
    const picked = selectedIds(this.designer.state);
    const loose = looseIds(this.designer.state);
    const stays = loose.length === 0 ? parts.lockedStays : loose.length === ids.length ? parts.oneStays : undefined;
    const [selected, hidden] = [new Set(picked), new Set(session.hidden)];
    const allHidden = picked.every((id) => hidden.has(id));
    return html`<section aria-labelledby="parts">
      <h3 id="parts">${parts.heading}</h3>
      <ul
        role="listbox"
        aria-multiselectable="true"
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
            aria-selected=${selected.has(id) ? "true" : "false"}
            ?data-chosen=${id === chosen}
            ?data-hidden=${hidden.has(id)}
            ?data-glued=${counts.size > 1 && members(at) > 1}
            @click=${(event: MouseEvent) => this.pick(event, id)}
          >
            <span
              >${partName(at, design.parts[at]?.name)}${hidden.has(id) ? html`<span class="spoken">${parts.isHidden}</span>` : nothing}${
                session.locked.includes(id)
                  ? html`<span class="lock">${icon("locked")}</span><span class="spoken">${parts.isLocked}</span>`
                  : nothing
              }</span
            >
            ${counts.size > 1 ? this.object(id, numberOf(at), members(at)) : html`<span></span>`}
            ${this.eye(id, hidden.has(id))}
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
        ${this.button(allHidden ? parts.show : parts.hide, allHidden ? "hidden" : "seen", false, () => hideParts(this.designer.state, picked, !allHidden))}
        ${
          loose.length === 0
            ? this.button(parts.unlock, "locked", false, () => lockParts(this.designer.state, picked, false))
            : this.button(parts.lock, "unlocked", false, () => lockParts(this.designer.state, picked, true))
        }
        ${this.button(parts.up, "up", place === 0, () => movePart(this.designer.state, chosen, -1))}
        ${this.button(parts.down, "down", place === ids.length - 1, () => movePart(this.designer.state, chosen, 1))}
        ${this.button(parts.duplicate, "copy", false, () => this.copy())}
        ${this.button(parts.delete, "remove", stays !== undefined, () => deleteParts(this.designer.state, loose), stays)}
      </div>
      <p class="problem" id="taken" role="status"></p>
      <div ?hidden=${!WHERE.includes(session.tab)}>
        <pasu-joints .designer=${this.designer}></pasu-joints>
        <pasu-constraints .designer=${this.designer}></pasu-constraints>
      </div>
      <div ?hidden=${session.tab !== "shape"}>
        ${picked.length > 1 ? this.several(picked) : ids.length > 1 ? this.glue(chosen) : nothing}
        ${this.arrange()}
        ${ids.length > 1 ? html`<pasu-glue-matrix .designer=${this.designer}></pasu-glue-matrix>` : nothing}
      </div>
      ${hiddenNote(this.designer)}
    </section>`;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    queueMicrotask(() => this.release());
  }

  /** What is left alone is seen and loose: without this list nobody could show or unlock it. */
  private release(): void {
    const { ids, session } = this.designer.store;
    if (ids.length > 1 || session.hidden.length + session.locked.length === 0) return;
    this.designer.apply({ undo: "none", session: { hidden: [], locked: [] } });
  }

  /** Brings the selected part into the list's view when another one was selected, without moving the panel. */
  override updated(): void {
    const { ids, part } = this.designer.store;
    const chosen = ids[part];
    const option = this.renderRoot.querySelector<HTMLElement>("[data-chosen]");
    if (chosen === this.followed || !option) return;
    this.followed = chosen;
    this.say("");
    const [top, height] = [option.offsetTop - this.list.offsetTop, this.list.clientHeight];
    const { scrollTop } = this.list;
    if (top < scrollTop) this.list.scrollTop = top;
    else if (top + option.offsetHeight > scrollTop + height) this.list.scrollTop = top + option.offsetHeight - height;
  }

  /** The object of a part, and for pointers all of it at once; the keyboard has O. */
  private object(id: PartId, number: number, members: number) {
    const press = (event: Event) => {
      if (members < 2) return;
      event.stopPropagation();
      this.designer.apply(this.wholeObject(id));
    };
    return html`<span class="object" title=${members > 1 ? parts.whole : nothing} @click=${press}
      ><span class="spoken">, </span>${parts.object(number)}</span
    >`;
  }

  private wholeObject(id: PartId): Change {
    const whole = gluedTo(this.designer.state, [id]);
    return selectParts(...whole.filter((each) => each !== id), id);
  }

  private pick(event: MouseEvent, id: PartId): void {
    const { state } = this.designer;
    if (event.shiftKey) this.designer.apply(selectThrough(state, id));
    else if (event.ctrlKey || event.metaKey) this.designer.apply(alsoSelect(state, id));
    else this.designer.apply(selectParts(id));
  }

  /** What can be done to what several have to do with each other. */
  private several(selected: readonly PartId[]) {
    const { designer } = this;
    const { design, ids } = designer.store;
    const objects = new Set(selected.map((id) => objectOf(design.parts[ids.indexOf(id)] as Part)));
    const press = (label: string, disabled: boolean, change: () => Change) =>
      html`<button
        class="button outlined"
        type="button"
        aria-disabled=${disabled ? "true" : nothing}
        @click=${() => disabled || designer.apply(change())}
      >
        ${label}
      </button>`;
    const apart = separateParts(designer.state, selected).undo === "none";
    return html`<div class="several" role="group" aria-label=${parts.selected(selected.length)}>
      <p role="status">${parts.selected(selected.length)}</p>
      ${press(parts.together, objects.size < 2, () => glueTogether(designer.state, selected))}
      ${press(parts.apart, apart, () => separateParts(designer.state, selected))}
    </div>`;
  }

  /** Fetched with the list: what brings several into order, and copies into rows. */
  private arrange() {
    return html`<pasu-arrange .designer=${this.designer}></pasu-arrange>`;
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
    const places = new Map(ids.map((id, at) => [id, at]));
    const names = (members: readonly PartId[]) =>
      listed(members.map((id) => partName(places.get(id) ?? 0, design.parts[places.get(id) ?? 0]?.name)));
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

  private button(label: string, name: IconName, disabled: boolean, change: () => Change, title = label) {
    return iconButton(name, label, title, disabled, () => this.designer.apply(change()));
  }

  /** Beside everything that stands there, so that the copy is seen. */
  private copy(): Change {
    const { state, surface } = this.designer;
    const width = widthOf(surface.shown?.solved);
    return duplicateParts(state, selectedIds(state), Number((ASIDE * width).toPrecision(2)));
  }

  private readonly typed = (): void => {
    const { ids, part } = this.designer.store;
    const id = ids[part];
    if (id === undefined) return;
    const taken = isTaken(this.designer.state, id, this.name.value);
    this.say(taken ? parts.taken : "");
    if (!taken) this.designer.apply(renamePart(this.designer.state, id, this.name.value));
  };

  /** The typing is over. Where it ended with the name of another part it never happened; why the old name is there again is read until the next is typed. */
  private readonly named = (): void => {
    const { store } = this.designer;
    if (this.name.getAttribute("aria-invalid") === "true") store.cancelGesture();
    else store.endGesture();
    this.name.value = store.design.parts[store.part]?.name ?? "";
    this.name.setAttribute("aria-invalid", "false");
  };

  private say(text: string): void {
    this.name.setAttribute("aria-invalid", text === "" ? "false" : "true");
    const place = this.renderRoot.querySelector("#taken");
    if (place) place.textContent = text;
  }

  private readonly key = (event: KeyboardEvent): void => {
    const all = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "a";
    if ((event.ctrlKey || event.metaKey) && !all) return;
    const change = all ? selectParts(...this.designer.store.ids) : this.changeBy(event);
    if (!change) return;
    event.preventDefault();
    event.stopPropagation();
    if (change === "name") {
      this.name.focus();
      this.name.select();
    } else this.designer.apply(change);
  };

  private changeBy({ altKey, shiftKey, key }: KeyboardEvent): Change | "name" | null {
    const { state } = this.designer;
    const { ids, part } = state;
    const id = ids[part];
    if (id === undefined) return null;
    const selected = selectedIds(state);
    const loose = looseIds(state);
    const select = (place: number) => {
      const to = ids[Math.max(0, Math.min(ids.length - 1, place))] ?? id;
      return shiftKey ? selectThrough(state, to) : selectParts(to);
    };
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
        return deleteParts(state, loose);
      case "d":
      case "D":
        return this.copy();
      case "h":
      case "H":
        return hideParts(state, selected, !selected.every((each) => state.session.hidden.includes(each)));
      case "l":
      case "L":
        return lockParts(state, selected, loose.length > 0);
      case "o":
      case "O":
        return this.wholeObject(id);
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
        /* Some seven parts, and on a phone, whose panel is low, four. */
        max-height: max(168px, min(252px, 28vh));
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
      li > :first-child {
        padding-right: 10px;
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
      span[title].object {
        padding: 4px 6px;
        border-radius: 6px;
      }
      span[title].object:hover {
        background: var(--sheet);
        color: var(--ink);
      }
      li[data-glued] {
        box-shadow: inset 4px 0 0 var(--line);
      }
      .lock .icon {
        width: 0.95rem;
        height: 0.95rem;
        margin-left: 6px;
        vertical-align: -2px;
      }
      .several {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 6px;
        padding-top: 6px;
      }
      .several p {
        flex: 1 1 100%;
        color: var(--soft);
        font-size: 0.9rem;
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
      }
      li[data-chosen] {
        font-weight: 550;
      }
      .tools {
        display: flex;
        flex-wrap: wrap;
        gap: 4px;
        padding-top: 6px;
      }
      .tools .field {
        flex: 1 1 100%;
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
