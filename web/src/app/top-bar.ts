/** The bar across the top: the title, undo and redo, opening and saving, the link. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { DesignerElement } from "../element/designer-element";
import { MAX_TITLE, setTheme, setTitle } from "../state/actions";
import { THEMES, type ThemeChoice } from "../state/session";
import { iconButton } from "../ui/icon-button";
import { type IconName, icon } from "../ui/icons";
import { type BarCommand, CommandEvent } from "./command";
import "../ui/menu";
import { base, buttons } from "../ui/styles";
import { page } from "../words/english/page";

const ICONS: Readonly<Record<BarCommand, IconName>> = {
  new: "add",
  surprise: "chance",
  gallery: "gallery",
  mix: "mix",
  shelf: "shelf",
  open: "open",
  save: "save",
  export: "make",
  picture: "picture",
  link: "link",
  share: "share",
  embed: "embed",
  compare: "compare",
  help: "help",
};

const FILES: readonly BarCommand[] = ["gallery", "new", "open", "save", "export", "picture"];

const THEME_ICONS: Readonly<Record<ThemeChoice, IconName>> = { auto: "auto", light: "sun", dark: "moon" };

@customElement("pasu-top-bar")
export class PasuTopBar extends DesignerElement {
  override render() {
    const { designer } = this;
    const { keeper, store } = designer;
    const sharing = typeof navigator.share === "function";
    return html`
      <div class="brand">
        <h1>${page.name}</h1>
        <input
          class="title"
          type="text"
          aria-label=${page.title}
          placeholder=${page.untitled}
          maxlength=${MAX_TITLE}
          autocomplete="off"
          .value=${store.title}
          @input=${(event: Event) => designer.apply(setTitle(designer.state, (event.target as HTMLInputElement).value))}
          @change=${() => store.endGesture()}
          @blur=${() => store.endGesture()}
          @keydown=${(event: KeyboardEvent) => {
            if (event.key === "Enter") (event.target as HTMLInputElement).blur();
          }}
        />
        ${keeper.unsaved ? html`<span class="unsaved" title=${page.editedMeans}>${page.edited}</span>` : nothing}
      </div>
      <div class="history">
        ${iconButton("undo", page.undo, page.undoKey, !store.canUndo, () => designer.store.undo())}
        ${iconButton("redo", page.redo, page.redoKey, !store.canRedo, () => designer.store.redo())}
      </div>
      <div class="wide files">
        ${FILES.map((command) => this.item(command))}
      </div>
      <div class="sharing">
        <button class="button primary" type="button" aria-label=${page.commands.link} @click=${() => this.ask("link")}>
          ${icon("link")}<span class="text">${page.commands.link}</span>
        </button>
        <span class="wide">${this.bare("embed")}</span>
        ${sharing ? html`<span class="wide">${this.bare("share")}</span>` : nothing}
      </div>
      <div class="wide page">
        ${this.bare("surprise")} ${this.bare("compare")} ${this.bare("shelf")} ${this.theme(true)} ${this.bare("help")}
      </div>
      <pasu-menu class="narrow" label=${page.more} icon="more" bare once>
        ${this.item("shelf")} ${FILES.map((command) => this.item(command))}
        ${this.item("surprise")} ${this.item("compare")} ${this.item("embed")} ${sharing ? this.item("share") : nothing} ${this.theme(false)}
        ${this.item("help")}
      </pasu-menu>
    `;
  }

  private ask(command: BarCommand): void {
    this.dispatchEvent(new CommandEvent(command));
  }

  private item(command: BarCommand) {
    return html`<button class="button item" type="button" @click=${() => this.ask(command)}>
      ${icon(ICONS[command])}<span>${page.commands[command]}</span>
    </button>`;
  }

  private bare(command: BarCommand) {
    const label = page.commands[command];
    return iconButton(ICONS[command], label, label, false, () => this.ask(command));
  }

  private theme(bare: boolean) {
    const now = this.designer.store.session.theme;
    const next = THEMES[(THEMES.indexOf(now) + 1) % THEMES.length] ?? "auto";
    const act = () => this.designer.apply(setTheme(next));
    if (bare) return iconButton(THEME_ICONS[now], page.themes[now], page.pressToChange(page.themes[now]), false, act);
    return html`<button class="button item" type="button" @click=${act}>
      ${icon(THEME_ICONS[now])}<span>${page.themes[now]}</span>
    </button>`;
  }

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        display: flex;
        align-items: center;
        gap: 8px;
        padding: 0 14px 0 20px;
        background: var(--sheet);
        border-bottom: 1px solid var(--line);
        min-width: 0;
      }
      .brand {
        display: flex;
        align-items: center;
        gap: 12px;
        flex: 1 1 200px;
        min-width: 0;
      }
      h1 {
        font: italic 600 1.5rem / 1 var(--font-brand);
        color: var(--accent);
        letter-spacing: 0.01em;
      }
      .title {
        flex: 0 1 auto;
        field-sizing: content;
        min-width: 60px;
        max-width: 420px;
        min-height: var(--touch);
        padding: 0 10px;
        border: 1px solid transparent;
        border-radius: 8px;
        background: transparent;
        font-weight: 550;
        text-overflow: ellipsis;
      }
      .title:hover {
        border-color: var(--line);
      }
      .title::placeholder {
        color: var(--soft);
        opacity: 1;
      }
      .unsaved {
        flex: none;
        color: var(--soft);
        font-size: 0.86rem;
        white-space: nowrap;
      }
      .history,
      .files,
      .sharing,
      .page {
        display: flex;
        align-items: center;
        gap: 2px;
        flex: none;
      }
      .files {
        padding: 0 6px;
      }
      .item {
        padding: 0 10px;
      }
      pasu-menu .item {
        justify-content: flex-start;
        gap: 12px;
        padding: 0 10px;
      }
      .narrow {
        display: none;
      }
      /* Of a word and its picture the word: the title has the room. */
      @media (max-width: 84em) {
        .item {
          padding: 0 5px;
        }
        .files svg {
          display: none;
        }
      }
      /* Where letters are wide, as those of DejaVu Sans, there is just room for all. */
      @media (min-width: 67.5em) and (max-width: 70em) {
        :host {
          gap: 4px;
          padding: 0 8px 0 12px;
        }
      }
      @media (max-width: 67.4375em) {
        .wide {
          display: none;
        }
        .narrow {
          display: inline-block;
        }
      }
      @media (max-width: 35em) {
        :host {
          padding: 0 6px 0 12px;
          gap: 2px;
        }
        .brand {
          gap: 4px;
        }
        h1 {
          font-size: 1.3rem;
        }
        .title {
          padding: 0 6px;
        }
        .unsaved,
        .text {
          display: none;
        }
        .sharing .primary {
          padding: 0;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-top-bar": PasuTopBar;
  }
}
