/** The gallery: every exhibit with its picture, and how large the figures of the papers are opened. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { type ExhibitId, SHELVES, type Shelf } from "../../document/gallery";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import { scaled } from "../../document/scaled";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { choiceStyles, choices } from "../../ui/choices";
import { base } from "../../ui/styles";
import { gallery } from "../../words/english/gallery";
import { exhibitWords } from "../../words/gallery";
import { lengthWords } from "../../words/quantities";
import { gridFor } from "../../work/grid";
import { exhibitIn, Pictures, tileStyles, tiles } from "./pictures";

const SIZES = ["hand", "printed"] as const;

type Size = (typeof SIZES)[number];

/** So many centimetres high is a figure of a paper that a person can use. */
const USABLE = 20;

@customElement("pasu-gallery")
export class PasuGallery extends DesignerElement {
  @state() private size: Size = "hand";
  private pictures: Pictures | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.watchPictures();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.pictures?.end();
    this.pictures = null;
  }

  override render() {
    const first = SHELVES.find(({ printed }) => printed);
    return html`<pasu-dialog wide heading=${gallery.heading} @dialog-closed=${() => this.dispatchEvent(new Event("gallery-closed"))}>
      ${SHELVES.map(
        (shelf) => html`<section aria-label=${gallery.shelves[shelf.id].title}>
          ${
            shelf === first
              ? choices(gallery.openPapers, sizes(), this.size, (size) => {
                  this.size = size;
                })
              : nothing
          }
          <h3>${gallery.shelves[shelf.id].title}</h3>
          <p class="source">${gallery.shelves[shelf.id].source}</p>
          ${tiles(shelf.exhibits, exhibitWords, (exhibit) => void this.choose(exhibit, shelf))}
        </section>`,
      )}
    </pasu-dialog>`;
  }

  override firstUpdated(): void {
    this.watchPictures();
  }

  private watchPictures(): void {
    if (this.pictures || !this.hasUpdated) return;
    const exhibits = SHELVES.flatMap((shelf) => shelf.exhibits);
    this.pictures = new Pictures(this.designer, exhibitIn(exhibits));
    this.pictures.watch(this.renderRoot);
  }

  private async choose(exhibit: Exhibit<ExhibitId>, { printed }: Shelf): Promise<void> {
    const { designer } = this;
    const { title, parts } = exhibitWords(exhibit.id);
    const design = designOf(exhibit, title, parts);
    const height = printed && this.size === "hand" ? await this.heightOf(exhibit) : null;
    designer.opening.open(height === null ? design : scaled(design, USABLE / height, "scale"));
    this.dispatchEvent(new Event("gallery-closed"));
  }

  /** Of the surface as it is drawn; null where it cannot be. */
  private async heightOf(exhibit: Exhibit): Promise<number | null> {
    const design = designOf(exhibit);
    const { rows, columns } = gridFor(design, 0);
    const outcome = await this.designer.solver.mesh(`height ${exhibit.id}`, design, rows, columns);
    const bounds = outcome.state === "done" ? outcome.value.bounds : null;
    const height = bounds ? bounds.max[2] - bounds.min[2] : 0;
    return height > 0 ? height : null;
  }

  static override readonly styles = [
    base,
    choiceStyles,
    tileStyles,
    css`
      section {
        padding: 8px 0 14px;
      }
      .choices {
        padding-bottom: 16px;
      }
      h3 {
        font: 600 1.08rem var(--font-brand);
      }
      .source {
        color: var(--soft);
        font-size: 0.88rem;
        padding-bottom: 10px;
      }
    `,
  ];
}

/** How large the figures of the papers may be opened, in words. */
function sizes() {
  const height = lengthWords(USABLE, "cm");
  return SIZES.map((value) => ({
    value,
    label: gallery.sizes[value].label(height),
    note: gallery.sizes[value].note,
  }));
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-gallery": PasuGallery;
  }
}
