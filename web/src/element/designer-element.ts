/** The base of the page's components: given the designer, they draw themselves again when what they looked at while drawing has changed. */

import { effect } from "@preact/signals-core";
import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import { type Path, pathText } from "../document/path";
import { page } from "../words/english/page";
import { whyWords } from "../words/refusals";
import type { Designer } from "../work/designer";

export abstract class DesignerElement extends LitElement {
  #designer: Designer | null = null;
  #leave: (() => void) | null = null;

  @property({ attribute: false })
  get designer(): Designer {
    // Every template gives the designer before the first drawing; Lit alone asks for the value before that.
    return this.#designer as Designer;
  }

  /** May come before or after the element is on the page: a component that is fetched late is upgraded in its place. */
  set designer(designer: Designer) {
    this.#designer = designer;
  }

  /**
   * What is looked at from here on, in `willUpdate`, `render` and `updated`, is watched. An update that ends only after the element was
   * removed watches nothing, or what left the page would be held by what it looked at.
   */
  protected override performUpdate(): void {
    if (!this.isUpdatePending) return;
    this.#unwatch();
    let drawn = false;
    const leave = effect(() => {
      if (drawn) {
        this.requestUpdate();
        return;
      }
      drawn = true;
      super.performUpdate();
    });
    if (this.isConnected) this.#leave = leave;
    else leave();
  }

  /** Fetches what draws an element, unless it is there: asking for a module again walks through all that this one takes. */
  protected fetch(element: string, module: () => Promise<unknown>): void {
    if (!customElements.get(element)) module().catch(() => this.designer.notices.say(page.unfetched));
  }

  /** The solver's objection, where it names one of these places in the selected part's shape. */
  protected problemAt(...paths: readonly Path[]): string {
    const { store, surface } = this.designer;
    const { problem } = surface;
    if (!problem) return "";
    const named = paths.some((path) => pathText(["parts", store.part, "shape", ...path]) === problem.path);
    return named ? whyWords(problem) : "";
  }

  /** Draws again what may have changed while the element was not on the page, and watches it. */
  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#unwatch();
  }

  #unwatch(): void {
    this.#leave?.();
    this.#leave = null;
  }
}
