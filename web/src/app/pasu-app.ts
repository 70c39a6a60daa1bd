/** The page: bar, stage and panel, the keys that work everywhere, what is dropped on it, and its dialogues. */

import { effect } from "@preact/signals-core";
import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { Design, Refusal } from "../document/types";
import { DesignerElement } from "../element/designer-element";
import { saysView } from "../state/view-keys";
import { icon } from "../ui/icons";
import { fileName, pickFile, saveBlob } from "../work/files";
import type { Surprises } from "../work/surprises";
import type { Command, CommandEvent } from "./command";
import type { MixEvent } from "./dialogs/mix-dialog";
import type { PictureSize } from "./dialogs/picture-dialog";
import "./side-panel";
import "../element/stage-view";
import type { PasuStage } from "../element/stage-view";
import { base, buttons } from "../ui/styles";
import { outward } from "./outward";
import type { PasuPanel } from "./side-panel";
import "./top-bar";
import { isolated } from "../language";
import { page } from "../words/english/page";
import { refusalWords } from "../words/refusals";
import { fetchMadeWhenWanted } from "./wanted-making";

const NOTICE_MS = 6000;
/** What can be taken back stays long enough to be thought about, and to be reached by keys. */
const OFFER_MS = 30_000;

/** Dialogues are fetched when they are first opened: the first picture does not wait for them. */
const DIALOGUES = {
  new: () => import("./dialogs/new-dialog"),
  draw: () => import("./dialogs/draw-dialog"),
  scan: () => import("./dialogs/scan-dialog"),
  gallery: () => import("./dialogs/gallery-dialog"),
  mix: () => import("./dialogs/mix-dialog"),
  shelf: () => import("./dialogs/shelf-dialog"),
  help: () => import("./dialogs/help-dialog"),
  picture: () => import("./dialogs/picture-dialog"),
  export: () => import("./dialogs/export-dialog"),
  link: () => import("./dialogs/link-dialog"),
  embed: () => import("./dialogs/embed-dialog"),
  compare: () => import("./dialogs/compare-dialog"),
  patches: () => import("./dialogs/patches-dialog"),
} as const;

/** A link as this or an older version writes it, wherever in a text. */
const LINK = /#1[/~]/;
/** The query of a link, and the design behind it. */
const VIEWED_LINK = /(\?[^#\s]*)(#\S+)/;

/** So long nothing changes before a design is spoken of, and so long its wall is waited for. */
const TELL_MS = 400;
const WALL_MS = 5000;

/** A file of so many bytes is there before anybody could read that it is being opened. */
const LONG = 200_000;

@customElement("pasu-app")
export class PasuApp extends DesignerElement {
  @state() private dialog: "none" | keyof typeof DIALOGUES = "none";
  /** Whether what is drawn takes the place of the selected part's shape. */
  @state() private redraws = false;
  /** The scan that was dropped. */
  @state() private scan: File | null = null;
  @state() private address = "";
  @state() private viewed = "";
  @state() private dropping = false;
  @state() private spoken = "";
  /** The design that was spoken of last. */
  private told: Design | null = null;
  @query("pasu-stage") readonly stage!: PasuStage;
  @query("pasu-panel") private readonly panel!: PasuPanel;
  private leave: readonly (() => void)[] = [];
  private surprises: Surprises | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    const { designer } = this;
    const listening = new AbortController();
    this.leave = [
      () => listening.abort(),
      outward(designer, this),
      fetchMadeWhenWanted(designer),
      effect(() => {
        const { made, surface, description } = designer;
        const design = surface.shown?.design;
        if (surface.status !== "ready" || !surface.settled || !design) return;
        const waits = design.parts.some(({ wall }) => wall) && !made?.isOfNow(made.solid);
        // Once of a design, and not again when a digit more is known or its title is another one.
        const timer = setTimeout(
          () => {
            const { told } = this;
            this.told = design;
            if (told?.parts !== design.parts || told.unit !== design.unit) this.spoken = description;
          },
          waits ? WALL_MS : TELL_MS,
        );
        return () => clearTimeout(timer);
      }),
      effect(() => {
        const { notice } = designer.notices;
        const stays = notice?.undo ? OFFER_MS : NOTICE_MS;
        const timer = notice && setTimeout(() => designer.notices.dismiss(notice.id), stays);
        return () => clearTimeout(timer ?? undefined);
      }),
    ];
    const until = { signal: listening.signal };
    window.addEventListener("keydown", this.key, until);
    window.addEventListener("dragover", this.dragOver, until);
    window.addEventListener("dragleave", this.dragLeave, until);
    window.addEventListener("drop", this.drop, until);
    window.addEventListener("paste", this.paste, until);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.leave) leave();
  }

  override render() {
    const { designer } = this;
    return html`
      <button class="skip" type="button" @click=${() => this.panel.focus()}>${page.skip}</button>
      <header>
        <pasu-top-bar .designer=${designer} @command-chosen=${this.commanded}></pasu-top-bar>
      </header>
      <main aria-label=${page.thePot}>
        <pasu-stage .designer=${designer} @link-view=${this.linkView}></pasu-stage>
        <div class="banners">${this.banners()}</div>
        ${this.dropping ? html`<div class="drop"><p>${page.drop}</p></div>` : nothing}
      </main>
      <aside aria-label=${page.parameters}>
        <pasu-panel .designer=${designer} @command-chosen=${this.commanded}></pasu-panel>
      </aside>
      <p class="spoken" role="status">${this.spoken}</p>
      <div class="toasts" role="status">
        ${this.toast()}
      </div>
      ${this.dialogues()}
    `;
  }

  private toast() {
    const { notices } = this.designer;
    const { notice } = notices;
    if (!notice) return nothing;
    return html`<p class="toast">
      ${notice.undo?.saves ? icon("warn") : nothing}<span>${notice.text}</span>
      ${
        notice.undo
          ? html`<button class="button" type="button" @click=${() => void notices.undo()}>
              ${icon(notice.undo.saves ? "save" : "undo")}<span>${notice.undo.label}</span>
            </button>`
          : nothing
      }
    </p>`;
  }

  private banners() {
    const { designer } = this;
    const { problem } = designer.surface;
    const { problem: openProblem, underway } = designer.opening;
    if (underway && underway.bytes > LONG) import("./opening-note").catch(() => {});
    return html`
      <pasu-opening-note .designer=${designer}></pasu-opening-note>
      ${
        openProblem
          ? html`<div class="banner" role="alert">
              ${icon("warn")} ${explain(openProblem, null, page.potStays)}
              <button class="button bare" type="button" aria-label=${page.dismiss} @click=${() => designer.opening.dismissProblem()}>
                ${icon("close")}
              </button>
            </div>`
          : nothing
      }
      ${
        problem
          ? html`<div class="banner" role="alert">
              ${icon("warn")} ${explain(problem, designer.store.design, designer.surface.shown ? page.lastThatWorked : "")}
              ${
                designer.store.canUndo
                  ? html`<button class="button outlined" type="button" @click=${() => designer.store.undo()}>${page.undo}</button>`
                  : nothing
              }
            </div>`
          : nothing
      }
      ${
        designer.notices.newVersion
          ? html`<div class="banner calm" role="status">
              <p>${page.newVersion}</p>
              <button class="button outlined" type="button" @click=${() => location.reload()}>${page.reload}</button>
            </div>`
          : nothing
      }
    `;
  }

  private dialogues() {
    const { designer } = this;
    const close = () => {
      this.dialog = "none";
      this.scan = null;
    };
    if (designer.opening.conflict) {
      void import("./dialogs/conflict-dialog");
      return html`<pasu-conflict .designer=${designer}></pasu-conflict>`;
    }
    switch (this.dialog) {
      case "none":
        return nothing;
      case "new":
        return html`<pasu-new .designer=${designer} @command-chosen=${this.commanded} @new-closed=${close}></pasu-new>`;
      case "draw":
        return html`<pasu-draw .designer=${designer} ?redraws=${this.redraws} @draw-closed=${close}></pasu-draw>`;
      case "scan":
        return html`<pasu-scan .designer=${designer} .file=${this.scan} @scan-closed=${close}></pasu-scan>`;
      case "gallery":
        return html`<pasu-gallery .designer=${designer} @gallery-closed=${close}></pasu-gallery>`;
      case "mix":
        return html`<pasu-mix-dialog .designer=${designer} @mix-chosen=${this.mixed} @mix-closed=${close}></pasu-mix-dialog>`;
      case "shelf":
        return html`<pasu-shelf .designer=${designer} @shelf-closed=${close}></pasu-shelf>`;
      case "patches":
        return html`<pasu-patches .designer=${designer} @patches-closed=${close}></pasu-patches>`;
      case "help":
        return html`<pasu-help @help-closed=${close}></pasu-help>`;
      case "picture":
        return html`<pasu-picture .save=${this.savePicture} @picture-closed=${close}></pasu-picture>`;
      case "export":
        return html`<pasu-export .designer=${designer} @export-closed=${close}></pasu-export>`;
      case "link":
        return html`<pasu-link .address=${this.address} .viewed=${this.viewed} @link-copied=${() => designer.keeper.markShared()} @link-closed=${close}></pasu-link>`;
      case "embed":
        return html`<pasu-embed .designer=${designer} .address=${this.address} @embed-closed=${close}></pasu-embed>`;
      case "compare":
        return html`<pasu-compare .designer=${designer} @compare-closed=${close}></pasu-compare>`;
    }
  }

  private readonly mixed = ({ other }: MixEvent): void => this.panel.mix(other);

  private readonly commanded = (event: CommandEvent): void => void this.perform(event.command);

  private async perform(command: Command): Promise<void> {
    switch (command) {
      case "new":
      case "gallery":
      case "scan":
      case "mix":
      case "shelf":
      case "help":
      case "picture":
      case "export":
      case "compare":
      case "patches":
        await this.show(command);
        return;
      case "draw":
      case "redraw":
        this.redraws = command === "redraw";
        await this.show("draw");
        return;
      case "surprise":
        await this.surprise();
        return;
      case "open": {
        const file = await pickFile(
          ".json,.txt,.url,.website,.desktop,.webloc,.stl,.3mf,.glb,.obj,.zip,.ply,.step,.svg,application/json",
        );
        if (file) await this.openFiles([file]);
        return;
      }
      case "save":
        await this.designer.keeper.save();
        return;
      case "link":
        await this.copyLink();
        return;
      case "share":
        await this.share();
        return;
      case "embed": {
        const address = await this.linkOrSay();
        if (address === null) return;
        this.address = address;
        await this.show("embed");
        return;
      }
    }
  }

  private async show(dialogue: keyof typeof DIALOGUES): Promise<void> {
    try {
      await DIALOGUES[dialogue]();
      this.dialog = dialogue;
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  }

  /** Opens a pot that nobody has thought of. */
  private async surprise(): Promise<void> {
    try {
      const { judgedBy, Surprises } = await import("../work/surprises");
      this.surprises ??= new Surprises(judgedBy(async () => (await this.designer.openMade())?.maker ?? null));
      const design = await this.surprises.next();
      if (design) this.designer.opening.open(design);
    } catch {
      this.designer.notices.say(page.unfetched);
    }
  }

  private async copyLink(): Promise<void> {
    const address = await this.linkOrSay();
    if (address === null) return;
    try {
      await navigator.clipboard.writeText(address);
      this.designer.notices.say(page.linkCopied);
    } catch {
      this.address = address;
      this.viewed = "";
      await this.show("link");
    }
    this.designer.keeper.markShared();
  }

  /** Shows the pot of a link as the link's query says. */
  async showViewed(search: string, fragment: string): Promise<void> {
    const { showViewed } = await import("./show-viewed");
    await showViewed(this.designer, search, fragment, (camera) => this.stage.look(camera));
  }

  private readonly linkView = async (): Promise<void> => {
    const [address, { camera }] = [await this.linkOrSay(), this.stage];
    if (address === null || camera === null) return;
    const { withView } = await import("../state/viewed");
    const { overlays, map } = this.designer.store.session;
    this.address = address;
    this.viewed = withView(address, { camera, overlays, map });
    await this.show("link");
  };

  private async share(): Promise<void> {
    const url = await this.linkOrSay();
    if (url === null) return;
    try {
      await navigator.share({ title: this.designer.store.design.title ?? page.aPot, url });
      this.designer.keeper.markShared();
    } catch (error) {
      // Closing the share sheet is not a failure.
      if (!(error instanceof DOMException && error.name === "AbortError")) this.designer.notices.say(page.noSharing);
    }
  }

  private async linkOrSay(): Promise<string | null> {
    const { keeper, notices } = this.designer;
    const address = await keeper.address();
    if (address === null && keeper.tooLargeForLink) keeper.sayTooLarge();
    else if (address === null) notices.say(page.noLink);
    return address;
  }

  private readonly savePicture = async ({ width, height, transparent }: PictureSize): Promise<string | null> => {
    try {
      const blob = await this.stage.picture(width, height, transparent);
      if (!blob) return page.noPictures;
      const name = fileName(this.designer.store.design.title, "png");
      saveBlob(blob, name);
      this.designer.notices.say(page.savedAs(isolated(name)));
      return null;
    } catch {
      return page.pictureTooLarge;
    }
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || this.designer.opening.conflict || this.dialog !== "none") return;
    const typing = isText(event.composedPath()[0]);
    const command = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (command && !event.altKey) {
      if (key === "s") void this.perform("save");
      else if (key === "o") void this.perform("open");
      else if (typing) return;
      else if (key === "z" && event.shiftKey) this.designer.store.redo();
      else if (key === "z") this.designer.store.undo();
      else if (key === "y") this.designer.store.redo();
      else return;
    } else if (event.key === "?" && !typing) {
      void this.show("help");
    } else return;
    event.preventDefault();
  };

  private readonly dragOver = (event: DragEvent): void => {
    const types = event.dataTransfer?.types ?? [];
    if (!types.includes("Files") && !types.includes("text/uri-list") && !types.includes("text/plain")) return;
    if (!types.includes("Files") && isText(event.composedPath()[0])) return;
    event.preventDefault();
    this.dropping = true;
  };

  private readonly dragLeave = (event: DragEvent): void => {
    if (event.relatedTarget === null) this.dropping = false;
  };

  private readonly drop = (event: DragEvent): void => {
    this.dropping = false;
    const data = event.dataTransfer;
    const files = [...(data?.files ?? [])];
    const text = data?.getData("text/uri-list") || data?.getData("text/plain") || "";
    if (files.length === 0 && (text === "" || isText(event.composedPath()[0]))) return;
    event.preventDefault();
    void (files.length > 0 ? this.openFiles(files) : this.openText(text));
  };

  private readonly paste = (event: ClipboardEvent): void => {
    if (isText(event.composedPath()[0]) || this.dialog !== "none" || this.designer.opening.conflict) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    // Whatever else is pasted is meant for no one here.
    if (!LINK.test(text)) return;
    event.preventDefault();
    void this.openText(text);
  };

  /** Opens a document, or the link in a text. */
  private async openText(text: string): Promise<void> {
    const { opening, solver } = this.designer;
    const reader = await import("../work/link-in-text").catch(() => null);
    const link = (await reader?.linkOf(text, solver)) ?? text;
    await opening.openText(link);
    await this.showOpened(link);
  }

  /** What a link says of how its pot is looked at, as when the page is opened by it. */
  private async showOpened(text = ""): Promise<void> {
    const [, search = "", fragment = ""] = VIEWED_LINK.exec(text) ?? [];
    if (this.designer.opening.problem === null && saysView(search)) await this.showViewed(search, fragment);
  }

  private async openFiles(files: readonly File[]): Promise<void> {
    const opener = await import("./open-files").catch(() => null);
    if (!opener) this.designer.notices.say(page.unfetched);
    await opener?.openFiles(this.designer, files, {
      opened: (text) => this.showOpened(text),
      scan: async (file) => {
        this.scan = file;
        await this.show("scan");
      },
    });
  }

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        display: grid;
        grid: 60px minmax(0, 1fr) / minmax(0, 1fr) min(392px, 34vw);
        height: 100dvh;
        background: var(--paper);
      }
      header {
        grid-column: 1 / -1;
        display: grid;
        position: relative;
        z-index: 20;
      }
      main {
        position: relative;
        display: grid;
        min-width: 0;
        min-height: 0;
      }
      aside {
        display: grid;
        min-height: 0;
        border-left: 1px solid var(--line);
      }
      .skip {
        position: fixed;
        z-index: 100;
        top: 8px;
        left: 8px;
        min-height: 44px;
        padding: 0 16px;
        border: 0;
        border-radius: var(--radius);
        background: var(--accent);
        color: var(--on-accent);
        translate: 0 -80px;
      }
      .skip:focus {
        translate: 0;
      }
      .banners {
        position: absolute;
        z-index: 6;
        inset: 14px 14px auto;
        display: grid;
        justify-items: center;
        gap: 8px;
        pointer-events: none;
      }
      .banner {
        display: flex;
        align-items: center;
        gap: 12px;
        max-width: 620px;
        padding: 10px 10px 10px 16px;
        border: 1px solid var(--warn);
        border-radius: 13px;
        background: var(--warn-wash);
        box-shadow: 0 8px 26px var(--shadow);
        pointer-events: auto;
      }
      .banner > .icon {
        color: var(--warn);
      }
      .banner small {
        display: block;
        color: var(--soft);
        font-size: 0.82rem;
        overflow-wrap: anywhere;
      }
      .calm {
        border-color: var(--line);
        background: var(--sheet);
      }
      .drop {
        position: absolute;
        z-index: 8;
        inset: 12px;
        display: grid;
        place-items: center;
        border: 2px dashed var(--accent);
        border-radius: 18px;
        background: color-mix(in srgb, var(--accent-wash) 80%, transparent);
        font-size: 1.2rem;
        pointer-events: none;
      }
      .toasts {
        position: fixed;
        z-index: 60;
        inset: auto 0 76px;
        display: grid;
        justify-items: center;
        pointer-events: none;
      }
      .toast .button {
        margin: -8px -10px -8px 4px;
        color: inherit;
        text-decoration: underline;
        pointer-events: auto;
      }
      .toast .button:hover {
        color: var(--ink);
      }
      .toast {
        display: flex;
        align-items: center;
        gap: 10px;
        max-width: calc(100vw - 32px);
        padding: 11px 18px;
        border-radius: 13px;
        background: var(--ink);
        color: var(--paper);
        box-shadow: 0 10px 34px var(--shadow);
      }
      @media (max-width: 53.6875em) {
        :host {
          grid: 56px minmax(0, 46fr) minmax(0, 54fr) / minmax(0, 1fr);
        }
        aside {
          border-left: 0;
          border-top: 1px solid var(--line);
          border-radius: 18px 18px 0 0;
          overflow: hidden;
          box-shadow: 0 -6px 24px var(--shadow);
          z-index: 5;
          margin-top: -14px;
        }
      }
      @media (max-height: 32.5em) and (min-width: 30em) and (max-width: 61.1875em) and (orientation: landscape) {
        :host {
          grid: 52px minmax(0, 1fr) / minmax(0, 1fr) max(46vw, 19rem);
        }
        aside {
          margin-top: 0;
          border-radius: 0;
        }
      }
    `,
  ];
}

/** A person's sentence; in small print what it means for the stage, and where in the document that is, for whoever writes documents. */
function explain(problem: Refusal, design: Design | null, comfort: string) {
  return html`<p>
    ${refusalWords(problem, design)}<small>${comfort}${problem.path === "" ? nothing : html` <code aria-hidden="true">${problem.path}</code>`}</small>
  </p>`;
}

const TEXT_TYPES = new Set(["text", "search", "url", "email", "tel", "password", "number"]);

/** Whether keys pressed there are for the text in it. */
function isText(target: EventTarget | undefined): boolean {
  if (target instanceof HTMLInputElement) return TEXT_TYPES.has(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-app": PasuApp;
  }
}
