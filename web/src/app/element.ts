/** The base of the page's components: given the designer, they draw themselves again when it changed. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { Designer } from "./designer";

export abstract class DesignerElement extends LitElement {
  @property({ attribute: false }) designer!: Designer;
  #leave: (() => void) | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = this.designer.subscribe(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#leave?.();
    this.#leave = null;
  }
}
