/** The shelf: the designs saved in this browser, each with its picture, and what can be done with them. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Design } from "../../document/types";
import "../../ui/dialog";
import { labelOf } from "../../document/label";
import { DesignerElement } from "../../element/designer-element";
import { isolated, moment } from "../../language";
import { MAX_TITLE } from "../../state/actions";
import { concernsPieces } from "../../state/storage";
import { type IconName, icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { page } from "../../words/english/page";
import { shelf } from "../../words/english/shelf";
import { refusalWords } from "../../words/refusals";
import { type Change, Collection, type Entry } from "../../work/collection";
import { canvasOf, Pictures, pictureOf } from "./pictures";

interface Told {
  readonly text: string;
  readonly undo: (() => Promise<boolean>) | null;
  /** Whether something is gone that a person may miss later. */
  readonly gone?: boolean;
}

@customElement("pasu-shelf")
export class PasuShelf extends DesignerElement {
  /** What was done last, and how it is taken back. */
  @state() private told: Told | null = null;
  private collection: Collection | null = null;
  private pictures: Pictures | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("storage", this.storageChanged);
    if (!this.collection) void this.begin();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("storage", this.storageChanged);
    this.pictures?.end();
    this.pictures = null;
  }

  private async begin(): Promise<void> {
    const { solver, keeper } = this.designer;
    this.collection = new Collection(solver, keeper);
    this.requestUpdate();
    if ((await this.collection.gather()) > 0) this.told = { text: shelf.left, undo: null };
    await this.collection.read();
  }

  override render() {
    const { designer, told } = this;
    const entries = this.collection?.entries ?? null;
    const link = designer.surface.settled?.solved.link ?? "";
    const saved = link !== "" && (entries?.some((entry) => entry.link === link) ?? false);
    return html`<pasu-dialog wide heading=${shelf.heading} @dialog-closed=${this.close}>
      <p class="lead">${shelf.lead}</p>
      <div class="present">
        <button class="button primary" type="button" ?disabled=${saved || entries === null} @click=${this.save}>
          ${icon("shelf")}<span>${shelf.save}</span>
        </button>
        <p>${entries === null ? nothing : saved ? shelf.isSaved : shelf.differs}</p>
      </div>
      <div class="told" role="status">
        ${told ? html`<p>${told.text}</p>` : nothing}
        ${
          told?.undo
            ? html`<button class="button outlined" type="button" @click=${this.undo}>${icon("undo")}<span>${shelf.undo}</span></button>`
            : nothing
        }
      </div>
      ${entries?.length === 0 ? html`<p class="empty">${shelf.empty}</p>` : nothing}
      <ul class="pieces">
        ${entries?.map((entry) => (entry.design ? this.piece(entry, entry.design, entry.link === link) : this.unreadable(entry)))}
      </ul>
    </pasu-dialog>`;
  }

  override updated(_changed: PropertyValues): void {
    this.pictures ??= new Pictures(this.designer, (id) => {
      const found = this.collection?.entries?.find((entry) => pictureOf(entry) === id);
      return found?.design ?? null;
    });
    this.pictures.watch(this.renderRoot);
  }

  private piece(entry: Entry, design: Design, staged: boolean) {
    const name = nameOf(design);
    const picture = pictureOf(entry);
    return html`<li>
      <button class="open" type="button" aria-label=${shelf.open(name)} @click=${() => this.open(design)}>
        <span class="picture" data-exhibit=${picture} aria-hidden="true">${canvasOf(picture)}</span>
      </button>
      <input
        class="field"
        type="text"
        aria-label=${shelf.title}
        placeholder=${page.untitled}
        maxlength=${MAX_TITLE}
        autocomplete="off"
        .value=${design.title ?? ""}
        @change=${(event: Event) => void this.rename(entry, (event.target as HTMLInputElement).value)}
      />
      <p class="when">${time(entry.piece.at)}${staged ? html` <strong>${shelf.onStage}</strong>` : nothing}</p>
      <div class="acts">
        ${this.act("copy", shelf.duplicate(name), () => this.duplicate(design))}
        ${this.act("save", shelf.replace(name), () => this.replace(entry, design), staged)}
        ${this.act("remove", shelf.remove(name), () => this.takeAway(entry, name))}
      </div>
    </li>`;
  }

  private unreadable(entry: Entry) {
    return html`<li class="unreadable">
      <p class="reason"><strong>${shelf.unreadable}</strong> ${entry.refusal ? refusalWords(entry.refusal, null) : nothing}</p>
      <p class="when">${time(entry.piece.at)}</p>
      <div class="acts">${this.act("remove", shelf.remove(shelf.unreadable), () => this.takeAway(entry, shelf.unreadable))}</div>
    </li>`;
  }

  private act(name: IconName, label: string, act: () => Promise<void>, disabled = false) {
    return html`<button class="button bare" type="button" aria-label=${label} title=${label} ?disabled=${disabled} @click=${() => void act()}>
      ${icon(name)}
    </button>`;
  }

  private open(design: Design): void {
    this.designer.opening.open(design);
    this.close();
  }

  private readonly save = async (): Promise<void> => {
    const { store, keeper } = this.designer;
    const { design } = store;
    const done = await this.tell(this.collection?.save(design), shelf.saved(nameOf(design)));
    if (done && store.design === design) keeper.markShared();
  };

  private async replace(entry: Entry, before: Design): Promise<void> {
    const { store, keeper } = this.designer;
    const { design } = store;
    const done = await this.tell(this.collection?.replace(entry, design), shelf.replaced(nameOf(before)), true);
    if (done && store.design === design) keeper.markShared();
  }

  private async rename(entry: Entry, typed: string): Promise<void> {
    const title = labelOf(typed).trim();
    if (title === (entry.design?.title ?? "")) return;
    await this.tell(this.collection?.rename(entry, title), shelf.renamed(named(title)));
  }

  private async duplicate(design: Design): Promise<void> {
    const title = [...shelf.copyOf(design.title ?? page.untitled)].slice(0, MAX_TITLE).join("");
    await this.tell(this.collection?.save({ ...design, title }), shelf.duplicated(nameOf(design)));
  }

  private async takeAway(entry: Entry, name: string): Promise<void> {
    await this.tell(this.collection?.remove(entry), shelf.removed(name), true);
    // What had the focus is gone.
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLButtonElement>(".told button")?.focus();
  }

  /** Says what became of a change; whether there was one. */
  private async tell(change: Promise<Change> | undefined, text: string, gone = false): Promise<boolean> {
    const made = await change;
    if (!made) return false;
    if (made.state === "done") this.told = { text, undo: made.undo, gone };
    else this.told = { text: made.state === "full" ? shelf.notKept : shelf.notSolved, undo: null };
    return made.state === "done";
  }

  private readonly undo = async (): Promise<void> => {
    const undo = this.told?.undo;
    if (!undo) return;
    this.told = (await undo()) ? { text: shelf.undone, undo: null } : { text: shelf.notKept, undo };
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLButtonElement>(".pieces .open")?.focus();
  };

  private readonly storageChanged = ({ key }: StorageEvent): void => {
    if (concernsPieces(key)) void this.collection?.read();
  };

  private readonly close = (): void => {
    // What is gone from the shelf can be taken back without it too.
    const { told } = this;
    if (told?.undo && told.gone) {
      const { text, undo } = told;
      const act = async () => ((await undo()) ? shelf.undone : shelf.notKept);
      this.designer.notices.say(text, { label: shelf.undo, act });
    }
    this.dispatchEvent(new Event("shelf-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      .lead,
      .empty,
      .when,
      .present p {
        color: var(--soft);
      }
      .present,
      .told {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 8px 14px;
      }
      .present {
        padding: 12px 0;
      }
      .told:has(p) {
        padding: 6px 8px 6px 14px;
        border-radius: 10px;
        background: var(--well);
      }
      .told p {
        flex: 1 1 auto;
      }
      .empty {
        padding: 18px 0;
      }
      .pieces {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(min(11.875rem, 100%), 1fr));
        gap: 14px;
        padding-top: 14px;
      }
      .pieces li {
        display: flex;
        flex-direction: column;
        border: 1px solid var(--line);
        border-radius: 14px;
        overflow: hidden;
      }
      .open {
        padding: 0;
        border: 0;
        background: var(--paper);
        cursor: pointer;
      }
      .open:focus-visible {
        outline-offset: -4px;
      }
      .picture,
      canvas {
        display: block;
        width: 100%;
        aspect-ratio: 1;
      }
      .pieces .field {
        margin: 8px 8px 0;
        border-color: transparent;
        font-weight: 600;
      }
      .pieces .field:hover,
      .pieces .field:focus {
        border-color: var(--edge);
      }
      .when {
        padding: 2px 19px 0;
        font-size: 0.84rem;
      }
      .when strong {
        color: var(--accent-strong);
        white-space: nowrap;
      }
      .reason {
        flex: 1;
        padding: 19px 19px 8px;
        overflow-wrap: anywhere;
      }
      .acts {
        display: flex;
        flex-wrap: wrap;
        justify-content: flex-end;
        margin-top: auto;
        padding: 2px 8px 6px;
      }
      @media (max-width: 27.5em) {
        .pieces {
          grid-template-columns: 1fr 1fr;
          gap: 10px;
        }
        .pieces .field {
          margin: 6px 4px 0;
        }
        .when {
          padding-inline: 15px;
        }
      }
    `,
  ];
}

/** What a design is called in a sentence. */
function nameOf({ title }: Design): string {
  return named(title ?? "");
}

function named(title: string): string {
  return page.quoted(isolated(title === "" ? page.untitled : title));
}

function time(at: number) {
  return html`<time datetime=${new Date(at).toISOString()}>${moment(at)}</time>`;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-shelf": PasuShelf;
  }
}
