/** The gallery: every exhibit with a picture that is rendered when it comes into sight. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SHELVES } from "../../document/gallery";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import { lookOf } from "../../document/look";
import type { Thumbnails } from "../../render/thumbnail";
import { THUMBNAIL_GRID } from "../../work/grid";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { drawStill } from "../../element/still-picture";
import { base } from "../../ui/styles";

const WIDTH = 320;
const HEIGHT = 320;

/** Pictures once drawn are kept: the gallery opens at once the second time. */
const drawn = new Map<string, HTMLCanvasElement>();

@customElement("pasu-gallery")
export class PasuGallery extends DesignerElement {
  private painter: Promise<Thumbnails | null> | null = null;
  private queue: Promise<void> = Promise.resolve();
  private readonly sights = new IntersectionObserver((entries) => this.seen(entries), { rootMargin: "160px" });

  override connectedCallback(): void {
    super.connectedCallback();
    this.watchPictures();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sights.disconnect();
    void this.painter?.then((painter) => painter?.dispose());
    this.painter = null;
  }

  override render() {
    return html`<pasu-dialog wide heading="Gallery" @dialog-closed=${() => this.dispatchEvent(new Event("gallery-closed"))}>
      ${SHELVES.map(
        (shelf) => html`<section aria-label=${shelf.title}>
          <h3>${shelf.title}</h3>
          <p class="source">${shelf.source}</p>
          <ul>
            ${shelf.exhibits.map(
              (exhibit) => html`<li>
                <button type="button" data-exhibit=${exhibit.id} @click=${() => this.choose(exhibit)}>
                  <span class="picture" data-exhibit=${exhibit.id} aria-hidden="true">${canvasOf(exhibit)}</span>
                  <span class="title">${exhibit.title}</span>
                  <span class="note">${exhibit.note}</span>
                </button>
              </li>`,
            )}
          </ul>
        </section>`,
      )}
    </pasu-dialog>`;
  }

  override firstUpdated(): void {
    this.watchPictures();
  }

  private watchPictures(): void {
    for (const picture of this.renderRoot.querySelectorAll(".picture")) this.sights.observe(picture);
  }

  private choose(exhibit: Exhibit): void {
    this.designer.opening.open(designOf(exhibit));
    this.dispatchEvent(new Event("gallery-closed"));
  }

  private seen(entries: readonly IntersectionObserverEntry[]): void {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.sights.unobserve(target);
      const id = target.getAttribute("data-exhibit");
      const exhibit = SHELVES.flatMap((shelf) => shelf.exhibits).find((candidate) => candidate.id === id);
      // One after the other, so that the pot on the stage never waits for more than one of them.
      if (exhibit) this.queue = this.queue.then(() => this.draw(exhibit));
    }
  }

  private async draw(exhibit: Exhibit): Promise<void> {
    const canvas = canvasOf(exhibit);
    if (canvas.dataset.drawn === "true" || !this.isConnected) return;
    const design = designOf(exhibit);
    const { rows, columns } = THUMBNAIL_GRID;
    const outcome = await this.designer.solver.mesh(`thumbnail ${exhibit.id}`, design, rows, columns);
    if (outcome.state !== "done" || !this.isConnected) return;
    this.painter ??= import("../../render/thumbnail").then(
      ({ thumbnails }) => thumbnails(),
      () => null,
    );
    const painter = await this.painter.catch(() => null);
    try {
      if (!painter) throw new Error("no WebGL2");
      await painter.draw(outcome.value, lookOf(design.parts[0]), canvas);
    } catch {
      // Once is enough to know: the rest are drawn without trying again.
      this.painter = Promise.resolve(null);
      drawStill(outcome.value, canvas, [0.66, 0.8, 0.73]);
    }
    canvas.dataset.drawn = "true";
  }

  static override readonly styles = [
    base,
    css`
      section {
        padding: 8px 0 14px;
      }
      h3 {
        font: 600 1.08rem var(--font-brand);
      }
      .source {
        color: var(--soft);
        font-size: 0.88rem;
        padding-bottom: 10px;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(158px, 1fr));
        gap: 14px;
      }
      li {
        display: grid;
      }
      button {
        display: flex;
        flex-direction: column;
        gap: 3px;
        padding: 0 0 10px;
        border: 1px solid var(--line);
        border-radius: 14px;
        background: var(--sheet);
        text-align: left;
        cursor: pointer;
        overflow: hidden;
        transition: border-color 120ms;
      }
      button:hover {
        border-color: var(--accent);
      }
      .picture {
        display: block;
        width: 100%;
        aspect-ratio: 1;
        margin-bottom: 7px;
        background: var(--paper);
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
      }
      .title,
      .note {
        padding: 0 12px;
      }
      .title {
        font-weight: 600;
        font-size: 0.92rem;
        line-height: 1.3;
      }
      .note {
        color: var(--soft);
        font-size: 0.84rem;
        line-height: 1.35;
        text-wrap: pretty;
      }
      @media (max-width: 420px) {
        ul {
          grid-template-columns: 1fr 1fr;
          gap: 10px;
        }
      }
    `,
  ];
}

function canvasOf(exhibit: Exhibit): HTMLCanvasElement {
  const known = drawn.get(exhibit.id);
  if (known) return known;
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  drawn.set(exhibit.id, canvas);
  return canvas;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-gallery": PasuGallery;
  }
}
