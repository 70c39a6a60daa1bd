/** Pictures of exhibits, drawn one after the other when they come into sight, and the tiles that they are shown on. */

import { css, html } from "lit";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import { stageModel } from "../../element/stage-model";
import { drawStill } from "../../element/still-picture";
import type { Thumbnails } from "../../render/thumbnail";
import type { Designer } from "../../work/designer";
import { THUMBNAIL_GRID } from "../../work/grid";

const WIDTH = 320;
const HEIGHT = 320;

/** Pictures once drawn are kept: a dialogue opens at once the second time. */
const drawn = new Map<string, HTMLCanvasElement>();

export class Pictures {
  readonly #designer: Designer;
  readonly #exhibits: readonly Exhibit[];
  readonly #sights: IntersectionObserver;
  #painter: Promise<Thumbnails | null> | null = null;
  #queue: Promise<void> = Promise.resolve();
  #ended = false;

  /** Draws those of `exhibits` whose place is within `root` when it comes into sight. */
  constructor(designer: Designer, exhibits: readonly Exhibit[], root: ParentNode) {
    this.#designer = designer;
    this.#exhibits = exhibits;
    this.#sights = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: "160px" });
    for (const picture of root.querySelectorAll(".picture")) this.#sights.observe(picture);
  }

  /** Gives up what draws. */
  end(): void {
    this.#ended = true;
    this.#sights.disconnect();
    void this.#painter?.then((painter) => painter?.dispose());
    this.#painter = null;
  }

  #seen(entries: readonly IntersectionObserverEntry[]): void {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.#sights.unobserve(target);
      const id = target.getAttribute("data-exhibit");
      const exhibit = this.#exhibits.find((candidate) => candidate.id === id);
      // One after the other, so that the pot on the stage never waits for more than one of them.
      if (exhibit) this.#queue = this.#queue.then(() => this.#draw(exhibit));
    }
  }

  async #draw(exhibit: Exhibit): Promise<void> {
    const canvas = canvasOf(exhibit);
    if (canvas.dataset.drawn === "true" || this.#ended) return;
    const design = designOf(exhibit);
    const { rows, columns } = THUMBNAIL_GRID;
    const outcome = await this.#designer.solver.mesh(`thumbnail ${exhibit.id}`, design, rows, columns);
    if (outcome.state !== "done" || this.#ended) return;
    this.#painter ??= import("../../render/thumbnail").then(
      ({ thumbnails }) => thumbnails(),
      () => null,
    );
    const painter = await this.#painter.catch(() => null);
    try {
      if (!painter) throw new Error("no WebGL2");
      await painter.draw(stageModel(design, outcome.value), canvas);
    } catch {
      // Once is enough to know: the rest are drawn without trying again.
      this.#painter = Promise.resolve(null);
      drawStill(outcome.value.parts, canvas, [0.66, 0.8, 0.73]);
    }
    // What draws gives up without a word once it is at its end: the picture is drawn the next time.
    if (!this.#ended) canvas.dataset.drawn = "true";
  }
}

/** A list of exhibits to choose from. */
export function tiles<Id extends string>(
  exhibits: readonly Exhibit<Id>[],
  words: (id: Id) => { readonly title: string; readonly note: string },
  choose: (exhibit: Exhibit<Id>) => void,
) {
  return html`<ul class="tiles">
    ${exhibits.map((exhibit) => {
      const { title, note } = words(exhibit.id);
      return html`<li>
        <button type="button" data-exhibit=${exhibit.id} @click=${() => choose(exhibit)}>
          <span class="picture" data-exhibit=${exhibit.id} aria-hidden="true">${canvasOf(exhibit)}</span>
          <span class="title">${title}</span>
          <span class="note">${note}</span>
        </button>
      </li>`;
    })}
  </ul>`;
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

export const tileStyles = css`
  .tiles {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(158px, 1fr));
    gap: 14px;
  }
  .tiles li {
    display: grid;
  }
  .tiles button {
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
  .tiles button:hover {
    border-color: var(--accent);
  }
  .tiles .picture {
    display: block;
    width: 100%;
    aspect-ratio: 1;
    margin-bottom: 7px;
    background: var(--paper);
  }
  .tiles canvas {
    display: block;
    width: 100%;
    height: 100%;
  }
  .tiles .title,
  .tiles .note {
    padding: 0 12px;
  }
  .tiles .title {
    font-weight: 600;
    font-size: 0.92rem;
    line-height: 1.3;
  }
  .tiles .note {
    color: var(--soft);
    font-size: 0.84rem;
    line-height: 1.35;
    text-wrap: pretty;
  }
  @media (max-width: 420px) {
    .tiles {
      grid-template-columns: 1fr 1fr;
      gap: 10px;
    }
  }
`;
