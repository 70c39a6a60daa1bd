/** A button that opens a small panel of controls above or below itself. Escape, a press elsewhere and a focus that goes elsewhere close it. */

import { css, html, LitElement, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { type IconName, icon } from "./icons";
import { base, buttons } from "./styles";

/** Between the button and its panel, and between that and the edge, in pixels. */
const GAP = 14;
/** However little room there is, one of its lines is seen. */
const LEAST_ROOM = 60;

@customElement("pasu-menu")
export class PasuMenu extends LitElement {
  @property() label = "";
  @property() icon: IconName = "more";
  /** Show the icon alone; the label is then spoken only. */
  @property({ type: Boolean }) bare = false;
  /** Which way the panel opens. */
  @property({ reflect: true }) side: "up" | "down" = "down";
  /** Whether a choice inside closes the panel. */
  @property({ type: Boolean }) once = false;
  @state() private open = false;
  @query("#panel") private readonly panel!: HTMLElement;
  @query("button") private readonly button!: HTMLButtonElement;

  override connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("pointerdown", this.pressed, true);
    this.addEventListener("focusout", this.left);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("pointerdown", this.pressed, true);
  }

  override focus(options?: FocusOptions): void {
    this.button.focus(options);
  }

  override render() {
    return html`
      <button
        class="button ${this.bare ? "bare" : ""}"
        type="button"
        aria-expanded=${this.open ? "true" : "false"}
        aria-controls="panel"
        aria-label=${this.bare ? this.label : nothing}
        title=${this.bare ? this.label : nothing}
        @click=${() => {
          this.open = !this.open;
        }}
        @keydown=${this.key}
      >
        ${icon(this.icon)}${this.bare ? nothing : html`<span>${this.label}</span>`}
      </button>
      <div id="panel" ?hidden=${!this.open} @click=${this.chosen} @keydown=${this.key}><slot></slot></div>
    `;
  }

  override updated(changed: PropertyValues): void {
    if (changed.has("open") && this.open) this.keepInside();
  }

  /** What has no room between the button and the edge of what it stands in scrolls. */
  private keepInside(): void {
    const { top, bottom } = this.button.getBoundingClientRect();
    let [from, to] = [0, innerHeight];
    for (let node: Node | null = this; node; node = node instanceof ShadowRoot ? node.host : node.parentNode) {
      if (!(node instanceof Element) || getComputedStyle(node).overflowY === "visible") continue;
      const box = node.getBoundingClientRect();
      from = Math.max(from, box.top);
      to = Math.min(to, box.bottom);
    }
    const room = (this.side === "up" ? top - from : to - bottom) - GAP;
    this.panel.style.maxHeight = `${Math.max(room, LEAST_ROOM)}px`;
  }

  private readonly pressed = (event: Event): void => {
    if (this.open && !event.composedPath().includes(this)) this.open = false;
  };

  /** To nowhere it goes when the window is left, or what has it is pressed or taken away. */
  private readonly left = ({ relatedTarget }: FocusEvent): void => {
    if (relatedTarget instanceof Node && !this.contains(relatedTarget)) this.open = false;
  };

  private readonly chosen = (): void => {
    if (!this.once) return;
    this.open = false;
    this.button.focus();
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.open) return;
    event.stopPropagation();
    this.open = false;
    this.button.focus();
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        position: relative;
        display: inline-block;
      }
      #panel:not([hidden]) {
        display: grid;
      }
      #panel {
        position: absolute;
        z-index: 30;
        right: 0;
        top: calc(100% + 6px);
        grid-template-columns: var(--menu-columns, 1fr);
        width: max-content;
        min-width: 210px;
        max-width: calc(100vw - 16px);
        padding: 6px;
        overflow-y: auto;
        overscroll-behavior: contain;
        border: 1px solid var(--line);
        border-radius: 12px;
        background: var(--sheet);
        box-shadow: 0 12px 40px var(--shadow);
      }
      :host([side="up"]) #panel {
        top: auto;
        bottom: calc(100% + 6px);
      }
      ::slotted(*) {
        display: flex;
        width: 100%;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-menu": PasuMenu;
  }
}
