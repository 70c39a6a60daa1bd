/** The base of the page's components: given the designer, they draw themselves again when it changed. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
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
    this.#leave?.();
    this.#designer = designer;
    this.#leave = this.isConnected ? designer.subscribe(() => this.told()) : null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave ??= this.#designer?.subscribe(() => this.told()) ?? null;
  }

  /** The designer changed. */
  protected told(): void {
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#leave?.();
    this.#leave = null;
  }
}
