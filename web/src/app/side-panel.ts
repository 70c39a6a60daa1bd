/** The panel beside (on a phone: below) the stage: tabs over the parameters, the profile, the equation, the look, the wall and what it measures. */

import { computed } from "@preact/signals-core";
import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { DesignerElement } from "../element/designer-element";
import { selectTab } from "../state/actions";
import { TABS, type Tab } from "../state/session";
import { icon } from "../ui/icons";
import { base, buttons } from "../ui/styles";
import { page } from "../words/english/page";
import { CommandEvent } from "./command";
import type { Other } from "./panels/mix-panel";

/** Each is fetched when it is first looked at, the one that opens the page too: the pot is drawn without waiting for it. */
const PANELS: Readonly<Record<Tab, () => Promise<unknown>>> = {
  shape: () => import("./panels/parameters"),
  profile: () => import("./panels/profile-editor"),
  equation: () => import("./panels/equation-panel"),
  look: () => import("./panels/look-panel"),
  wall: () => import("./panels/wall-panel"),
  measures: () => import("./panels/measures-panel"),
};

@customElement("pasu-panel")
export class PasuPanel extends DesignerElement {
  @query("[aria-selected=true]") private readonly selected!: HTMLButtonElement;
  @query(".body") private readonly body!: HTMLElement;

  /** What the pot is being mixed with. */
  @state() private other: Other | null = null;
  /** Apart from what else changes of the design, so that a drag does not draw the panel. */
  readonly #isOneOfRings = computed(() => {
    const { parts } = this.designer.store.design;
    return parts.length === 1 && parts[0]?.shape.kind === "rings";
  });
  /** A part among others stands somewhere, an octant is as large as its placement says, and what has sliders of the scene is moved by them. */
  readonly #isPlaced = computed(() => {
    const { parts } = this.designer.store.design;
    return parts.length > 1 || parts[0]?.shape.kind === "octant" || !!parts[0]?.joints;
  });
  private fetched: Tab | null = null;
  private listed = false;

  override focus(options?: FocusOptions): void {
    this.selected.focus(options);
  }

  /** Mixes the pot with another, until a person has had enough of it. What shows it came with the dialogue that chose. */
  mix(other: Other): void {
    this.other = other;
  }

  override willUpdate(): void {
    const held = this.shadowRoot?.activeElement;
    // With the last but one part the list goes, with its last slider the placement of what is alone, and with them what had the focus.
    if (held) void this.updateComplete.then(() => held.isConnected || this.focus());
    const { tab } = this.designer.store.session;
    if (tab === this.fetched) return;
    this.fetched = tab;
    PANELS[tab]().catch(() => {
      this.fetched = null;
      this.designer.notices.say(page.unfetched);
    });
  }

  override render() {
    const { tab } = this.designer.store.session;
    return html`
      <div class="tabs" role="tablist" aria-label=${page.panels} @keydown=${this.key}>
        ${TABS.map(
          (name) => html`<button
            type="button"
            role="tab"
            id="tab-${name}"
            aria-controls="body"
            aria-selected=${tab === name ? "true" : "false"}
            tabindex=${tab === name ? 0 : -1}
            @click=${() => this.select(name)}
          >
            ${page.tabs[name]}
          </button>`,
        )}
      </div>
      <div class="body" id="body" role="tabpanel" aria-labelledby="tab-${tab}" tabindex="-1">
        <h2 class="spoken">${page.tabs[tab]}</h2>
        ${
          this.other
            ? html`<pasu-mix .designer=${this.designer} .other=${this.other} @mix-closed=${this.unmix}></pasu-mix>`
            : nothing
        }
        ${this.parts()}
        ${tab === "shape" ? this.mixing() : nothing}
        ${this.content(tab)}
      </div>
    `;
  }

  private content(tab: Tab) {
    const { designer } = this;
    switch (tab) {
      case "shape":
        return html`<pasu-parameters .designer=${designer}></pasu-parameters>${this.placing()}`;
      case "profile":
        return html`<pasu-profile .designer=${designer}></pasu-profile>`;
      case "equation":
        return html`<pasu-equation .designer=${designer}></pasu-equation>`;
      case "look":
        return html`<pasu-look .designer=${designer}></pasu-look>`;
      case "wall":
        return html`<pasu-wall .designer=${designer}></pasu-wall>`;
      case "measures":
        return html`<pasu-measures .designer=${designer}></pasu-measures>`;
    }
  }

  private placing() {
    if (!this.#isPlaced.value) return nothing;
    this.fetch("pasu-place", () => import("./panels/place-card"));
    return html`<pasu-place .designer=${this.designer}></pasu-place>`;
  }

  /** A pot of rings can be mixed with another. */
  private mixing() {
    if (this.other || !this.#isOneOfRings.value) return nothing;
    return html`<button class="button outlined mixing" type="button" @click=${() => this.dispatchEvent(new CommandEvent("mix"))}>
      ${icon("mix")}<span>${page.commands.mix}</span>
    </button>`;
  }

  private readonly unmix = (): void => {
    const left = this.shadowRoot?.activeElement?.localName === "pasu-mix";
    this.other = null;
    if (left) void this.updateComplete.then(() => this.focus());
  };

  /** A list of one part would say nothing. */
  private parts() {
    const { designer } = this;
    if (designer.store.ids.length < 2) return nothing;
    if (!this.listed) {
      this.listed = true;
      import("./panels/parts-list").catch(() => {
        this.listed = false;
        designer.notices.say(page.unfetched);
      });
    }
    return html`<pasu-parts .designer=${designer}></pasu-parts>`;
  }

  private select(tab: Tab): void {
    this.designer.apply(selectTab(tab));
    this.body.scrollTop = 0;
  }

  private readonly key = (event: KeyboardEvent): void => {
    const now = TABS.indexOf(this.designer.store.session.tab);
    const to =
      event.key === "ArrowRight"
        ? now + 1
        : event.key === "ArrowLeft"
          ? now - 1
          : event.key === "Home"
            ? 0
            : event.key === "End"
              ? TABS.length - 1
              : null;
    const tab = to === null ? undefined : TABS[(to + TABS.length) % TABS.length];
    if (!tab) return;
    event.preventDefault();
    this.select(tab);
    this.renderRoot.querySelector<HTMLButtonElement>(`#tab-${tab}`)?.focus();
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        display: grid;
        grid-template: auto 1fr / minmax(0, 1fr);
        min-height: 0;
        min-width: 0;
        container-type: inline-size;
        background: var(--sheet);
      }
      .tabs {
        display: flex;
        overflow: auto hidden;
        padding: 0 14px;
        border-bottom: 1px solid var(--line);
      }
      [role="tab"] {
        flex: 1;
        min-height: 46px;
        padding: 0 6px;
        border: 0;
        border-bottom: 2.5px solid transparent;
        border-top: 2.5px solid transparent;
        background: none;
        color: var(--soft);
        cursor: pointer;
      }
      [role="tab"]:hover {
        color: var(--ink);
      }
      [role="tab"]:focus-visible {
        outline-offset: -4px;
      }
      [role="tab"][aria-selected="true"] {
        border-bottom-color: var(--accent);
        color: var(--ink);
        font-weight: 600;
      }
      /* What is transparent is drawn there too. */
      @media (forced-colors: active) {
        [role="tab"] {
          border-color: Canvas;
        }
        [role="tab"][aria-selected="true"] {
          border-bottom-color: Highlight;
        }
      }
      .body {
        /* What is spoken only stands where it is said, and makes no page longer. */
        position: relative;
        padding: 14px 20px 28px;
        overflow-y: auto;
        overscroll-behavior: contain;
        scrollbar-gutter: stable;
        outline-offset: -3px;
      }
      .mixing {
        margin-bottom: 8px;
      }
      @container (max-width: 23.6875rem) {
        .tabs {
          padding: 0 6px;
        }
        [role="tab"] {
          padding: 0 2px;
          font-size: 0.88rem;
        }
      }
      @media (max-width: 53.6875em) {
        .body {
          padding: 10px 16px calc(24px + env(safe-area-inset-bottom));
          scrollbar-gutter: auto;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-panel": PasuPanel;
  }
}
