/** The pot on the stage beside another one: whether they are the same scene, and otherwise what became of each part. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { type Group, groupsOf } from "../../document/fates";
import { unitOf } from "../../document/look";
import type { Design, Difference, Refusal } from "../../document/types";
import { DesignerElement } from "../../element/designer-element";
import { isolated } from "../../language";
import { selectParts } from "../../state/seen-actions";
import "../../ui/dialog";
import { icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { comparing } from "../../words/english/comparing";
import { page } from "../../words/english/page";
import { size } from "../../words/english/size";
import { partName } from "../../words/parts";
import { refusalWords } from "../../words/refusals";
import { Collection, type Entry } from "../../work/collection";
import { pickFile } from "../../work/files";
import { linkOf } from "../../work/link-in-text";
import { readFile } from "../../work/open-file";
import { canvasOf, Pictures, pictureOf, tileStyles } from "./pictures";

/** What came of a comparison. */
type Result =
  | { readonly state: "done"; readonly here: Design; readonly there: Design; readonly difference: Difference }
  | { readonly state: "refused"; readonly refusal: Refusal };

@customElement("pasu-compare")
export class PasuCompare extends DesignerElement {
  @state() private result: Result | null = null;
  @query("#other") private readonly other!: HTMLTextAreaElement;
  @query("#result") private readonly said!: HTMLElement;
  private collection: Collection | null = null;
  private pictures: Pictures | null = null;
  private asked = 0;

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.collection) return;
    const { solver, keeper } = this.designer;
    this.collection = new Collection(solver, keeper);
    this.requestUpdate();
    void this.collection.read();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.asked += 1;
    this.pictures?.end();
    this.pictures = null;
  }

  override render() {
    const own = this.collection?.entries?.filter(({ design }) => design);
    return html`<pasu-dialog heading=${comparing.heading} @dialog-closed=${this.close}>
      <p id="lead">${comparing.lead}</p>
      <form
        @submit=${(event: Event) => {
          event.preventDefault();
          void this.compareText(this.other.value);
        }}
      >
        <label for="other">${comparing.other}</label>
        <textarea
          id="other"
          class="field"
          rows="3"
          placeholder=${comparing.otherHelp}
          autocomplete="off"
          autocapitalize="off"
          spellcheck="false"
          @keydown=${(event: KeyboardEvent) => {
            if (event.key !== "Enter" || event.shiftKey) return;
            event.preventDefault();
            void this.compareText(this.other.value);
          }}
        ></textarea>
        <div class="tools">
          <button class="button outlined" type="button" @click=${() => void this.compareFile()}>
            ${icon("open")} ${comparing.file}
          </button>
          <button class="button primary" type="submit">${icon("compare")} ${comparing.compare}</button>
        </div>
      </form>
      <div id="result" role="status" tabindex="-1">${this.outcome()}</div>
      ${
        own && own.length > 0
          ? html`<section aria-label=${comparing.shelf}>
              <h3>${comparing.shelf}</h3>
              <ul class="tiles">${own.map((entry) => this.piece(entry))}</ul>
            </section>`
          : nothing
      }
    </pasu-dialog>`;
  }

  override updated(): void {
    const find = (id: string) => this.collection?.entries?.find((entry) => pictureOf(entry) === id)?.design ?? null;
    this.pictures ??= new Pictures(this.designer, find);
    this.pictures.watch(this.renderRoot);
  }

  private piece(entry: Entry) {
    const { design, piece } = entry;
    if (!design) return nothing;
    const picture = pictureOf(entry);
    return html`<li>
      <button type="button" @click=${() => void this.compareText(piece.text)}>
        <span class="picture" data-exhibit=${picture} aria-hidden="true">${canvasOf(picture)}</span>
        <span class="title">${design.title ?? page.untitled}</span>
      </button>
    </li>`;
  }

  private outcome() {
    const { result } = this;
    if (!result) return nothing;
    if (result.state === "refused") {
      return html`<p class="verdict problem">${comparing.refused(refusalWords(result.refusal))}</p>`;
    }
    const { here, there, difference } = result;
    const [ours, theirs] = [unitOf(here), unitOf(there)];
    return html`
      <p class="with">${comparing.with(isolated(there.title ?? page.untitled))}</p>
      <p class="verdict" data-same=${difference.isSame}>${difference.isSame ? comparing.same : comparing.different}</p>
      ${ours === theirs ? nothing : html`<p>${comparing.units(size.units[ours], size.units[theirs])}</p>`}
      ${
        difference.isSame || ours !== theirs
          ? nothing
          : html`<div class="tools start">
              <button class="button outlined" type="button" @click=${() => this.onStage(there)}>
                ${icon("seen")} ${comparing.onStage}
              </button>
            </div>`
      }
      ${difference.isSame ? nothing : html`<dl>${groupsOf(difference).map((group) => this.fate(group, here, there))}</dl>`}
    `;
  }

  private fate({ which, parts }: Group, here: Design, there: Design) {
    if (parts.length === 0) return nothing;
    return html`<div data-fate=${which}>
      <dt>${comparing[which]} <span class="count">${comparing.count(parts.length)}</span></dt>
      <dd>
        ${parts.map(({ before, after }) => {
          const theirs = before === undefined ? null : partName(before, there.parts[before]?.name);
          if (after === undefined) return html`<span class="part">${theirs}</span>`;
          const ours = partName(after, here.parts[after]?.name);
          const also =
            theirs === null || theirs === ours ? nothing : html` <small>${comparing.there(isolated(theirs))}</small>`;
          return html`<button class="part" type="button" title=${comparing.select(ours)} @click=${() => this.select(after)}>
            <span>${ours}</span>${also}
          </button>`;
        })}
      </dd>
    </div>`;
  }

  private onStage(there: Design): void {
    this.designer.contrast.show(there);
    this.close();
  }

  private select(place: number): void {
    const id = this.designer.store.ids[place];
    if (id !== undefined) this.designer.apply(selectParts(id));
    this.close();
  }

  private async compareFile(): Promise<void> {
    const file = await pickFile(".json,.stl,.3mf,.glb,.obj,.zip,.ply,.step,.svg,application/json");
    if (!file) return;
    this.begin();
    const maker = async () => (await this.designer.openMade())?.maker ?? null;
    const found = await readFile(file, { solver: this.designer.solver, maker });
    if (!found) return;
    if ("text" in found) await this.compareText(found.text);
    else this.show({ state: "refused", refusal: found.refusal });
  }

  /** A refusal is gone while something else is looked at: the same words are read aloud again. */
  private begin(): number {
    this.asked += 1;
    if (this.result?.state === "refused") this.result = null;
    return this.asked;
  }

  /** The newest question alone is answered. */
  private async compareText(text: string): Promise<void> {
    const asked = this.begin();
    const { designer } = this;
    const here = designer.store.design;
    const link = await linkOf(text, designer.solver);
    const [parsed, made] = await Promise.all([designer.solver.parse(link), designer.openMade()]);
    if (!made || asked !== this.asked || parsed.state === "superseded") return;
    if (parsed.state === "refused") {
      this.show({ state: "refused", refusal: parsed.refusal });
      return;
    }
    const there = parsed.value.design;
    const compared = await made.maker.ask({ kind: "compare", before: there, after: here });
    if (asked !== this.asked || compared.state === "superseded") return;
    if (compared.state === "refused") this.show({ state: "refused", refusal: compared.refusal });
    else this.show({ state: "done", here, there, difference: compared.value });
  }

  private show(result: Result): void {
    this.result = result;
    void this.updateComplete.then(() => this.said.scrollIntoView({ block: "nearest" }));
  }

  private readonly close = (): void => {
    this.dispatchEvent(new Event("compare-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    tileStyles,
    css`
      #lead,
      label,
      .with,
      dt {
        color: var(--soft);
      }
      form {
        display: grid;
        gap: 6px;
        padding-top: 12px;
      }
      label,
      .with,
      dt {
        font-size: 0.9rem;
      }
      textarea {
        width: 100%;
        padding: 8px 10px;
        resize: vertical;
        font: 0.86rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace;
        overflow-wrap: anywhere;
      }
      .tools {
        display: flex;
        flex-wrap: wrap;
        justify-content: flex-end;
        gap: 8px;
      }
      .start {
        justify-content: flex-start;
      }
      #result {
        display: grid;
        gap: 6px;
        overflow-wrap: anywhere;
      }
      #result:not(:empty) {
        padding-top: 12px;
      }
      .verdict {
        font: 600 1.08rem var(--font-brand);
      }
      .problem {
        color: var(--warn);
        font: inherit;
      }
      dl,
      dd {
        margin: 0;
      }
      dl {
        display: grid;
        gap: 10px;
      }
      dd {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
        padding-top: 4px;
      }
      .part {
        display: inline-flex;
        align-items: center;
        gap: 6px;
        min-height: var(--touch);
        padding: 0 10px;
        border: 1px solid var(--line);
        border-radius: 8px;
        background: transparent;
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
      .count {
        color: var(--soft);
      }
      section {
        padding-top: 16px;
      }
      h3 {
        padding-bottom: 10px;
        font: 600 1.08rem var(--font-brand);
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-compare": PasuCompare;
  }
}
