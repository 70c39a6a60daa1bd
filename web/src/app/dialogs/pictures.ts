/** Pictures of designs, drawn one after the other when they come into sight, and the tiles that they are shown on. */

import { css, html } from "lit";
import { floored } from "../../document/floored";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import type { Design } from "../../document/types";
import { stageModel } from "../../element/stage-model";
import { drawStill } from "../../element/still-picture";
import type { Thumbnails } from "../../render/thumbnail";
import type { Entry } from "../../work/collection";
import type { Designer } from "../../work/designer";
import { thumbnailGrid } from "../../work/grid";

const WIDTH = 320;
const HEIGHT = 320;

/** Pictures once drawn are kept: a dialogue opens at once the second time. */
const drawn = new Map<string, HTMLCanvasElement>();

/** The name of the picture of one piece as it is now: no two share one, and one that is changed has another. */
export function pictureOf({ piece, link }: Entry): string {
  return `${piece.id} ${link}`;
}

export class Pictures {
  readonly #designer: Designer;
  readonly #find: (id: string) => Design | null;
  readonly #sights: IntersectionObserver;
  #painter: Promise<Thumbnails | null> | null = null;
  #queue: Promise<void> = Promise.resolve();
  #ended = false;

  /** Draws what `find` has under the name of a picture's place. */
  constructor(designer: Designer, find: (id: string) => Design | null) {
    this.#designer = designer;
    this.#find = find;
    this.#sights = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: "160px" });
  }

  /** Draws what has its place within `root` when it comes into sight; once more when there are other places. */
  watch(root: ParentNode): void {
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
      // One after the other, so that the pot on the stage never waits for more than one of them.
      if (id !== null) this.#queue = this.#queue.then(() => this.#draw(id));
    }
  }

  async #draw(id: string): Promise<void> {
    const canvas = canvasOf(id);
    const found = this.#find(id);
    if (canvas.dataset.drawn === "true" || this.#ended || !found) return;
    const design = floored(found);
    const { rows, columns } = thumbnailGrid(design.parts.length);
    const outcome = await this.#designer.solver.mesh(`thumbnail ${id}`, design, rows, columns);
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
      drawStill(stageModel(design, outcome.value).parts, canvas);
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
          <span class="picture" data-exhibit=${exhibit.id} aria-hidden="true">${canvasOf(exhibit.id)}</span>
          <span class="title">${title}</span>
          <span class="note">${note}</span>
        </button>
      </li>`;
    })}
  </ul>`;
}

/** How {@link Pictures} finds one of these. */
export function exhibitIn(exhibits: readonly Exhibit[]): (id: string) => Design | null {
  return (id) => {
    const found = exhibits.find((exhibit) => exhibit.id === id);
    return found ? designOf(found) : null;
  };
}

/** Where the picture of this name is drawn. */
export function canvasOf(id: string): HTMLCanvasElement {
  const known = drawn.get(id);
  if (known) return known;
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  drawn.set(id, canvas);
  return canvas;
}

export const tileStyles = css`
  .tiles {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(9.875rem, 100%), 1fr));
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
  @media (max-width: 26.25em) {
    .tiles {
      grid-template-columns: 1fr 1fr;
      gap: 10px;
    }
  }
`;
