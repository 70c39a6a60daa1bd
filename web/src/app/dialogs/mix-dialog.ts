/** Choosing what to mix the pot on the stage with: a form, a pot of the gallery, or a design of one's own. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { FORMS } from "../../document/forms";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import { RINGED } from "../../document/gallery/rings";
import { mixable } from "../../document/mixing";
import type { Design } from "../../document/types";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { base } from "../../ui/styles";
import { beginnings } from "../../words/english/beginnings";
import { mix } from "../../words/english/mix";
import { page } from "../../words/english/page";
import { exhibitWords } from "../../words/gallery";
import { Collection, type Entry } from "../../work/collection";
import "../panels/mix-panel";
import type { Other } from "../panels/mix-panel";
import { canvasOf, Pictures, pictureOf, tileStyles, tiles } from "./pictures";

/** The person chose what to mix with. */
export class MixEvent extends Event {
  readonly other: Other;
  constructor(other: Other) {
    super("mix-chosen");
    this.other = other;
  }
}

@customElement("pasu-mix-dialog")
export class PasuMixDialog extends DesignerElement {
  private collection: Collection | null = null;
  private pictures: Pictures | null = null;

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
    this.pictures?.end();
    this.pictures = null;
  }

  override render() {
    const own = this.collection?.entries?.filter(({ design }) => design && mixable(design));
    return html`<pasu-dialog wide heading=${mix.heading} @dialog-closed=${this.close}>
      <p>${mix.lead}</p>
      ${own && own.length > 0 ? html`<section aria-label=${mix.shelf}><h3>${mix.shelf}</h3><ul class="tiles">${own.map((entry) => this.piece(entry))}</ul></section>` : ""}
      <section aria-label=${mix.forms}>
        <h3>${mix.forms}</h3>
        ${tiles(
          FORMS,
          (id) => beginnings.forms[id],
          (form) => this.choose(designOf(form), beginnings.forms[form.id].title),
        )}
      </section>
      <section aria-label=${mix.gallery}>
        <h3>${mix.gallery}</h3>
        ${tiles(RINGED, exhibitWords, (exhibit) => this.choose(designOf(exhibit), exhibitWords(exhibit.id).title))}
      </section>
    </pasu-dialog>`;
  }

  override updated(): void {
    this.pictures ??= new Pictures(this.designer, (id) => this.find(id));
    this.pictures.watch(this.renderRoot);
  }

  private piece(entry: Entry) {
    const { design } = entry;
    if (!design) return "";
    const [picture, title] = [pictureOf(entry), design.title ?? page.untitled];
    return html`<li>
      <button type="button" @click=${() => this.choose(design, title)}>
        <span class="picture" data-exhibit=${picture} aria-hidden="true">${canvasOf(picture)}</span>
        <span class="title">${title}</span>
      </button>
    </li>`;
  }

  private find(id: string): Design | null {
    const exhibit = [...FORMS, ...RINGED].find((each: Exhibit) => each.id === id);
    if (exhibit) return designOf(exhibit);
    return this.collection?.entries?.find((entry) => pictureOf(entry) === id)?.design ?? null;
  }

  private choose(design: Design, title: string): void {
    this.dispatchEvent(new MixEvent({ design, title }));
    this.close();
  }

  private readonly close = (): void => {
    this.dispatchEvent(new Event("mix-closed"));
  };

  static override readonly styles = [
    base,
    tileStyles,
    css`
      p {
        color: var(--soft);
      }
      section {
        padding: 14px 0 6px;
      }
      h3 {
        padding-bottom: 10px;
        font: 600 1.08rem var(--font-brand);
      }
    `,
  ];
}

/** As the shelf calls it: what it has drawn already is there. */
declare global {
  interface HTMLElementTagNameMap {
    "pasu-mix-dialog": PasuMixDialog;
  }
}
