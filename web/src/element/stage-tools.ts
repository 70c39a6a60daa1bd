/** The tools at the foot of the stage: standard views, zoom, and what is drawn over the pot. */

import { computed } from "@preact/signals-core";
import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Stage } from "../render/stage";
import { toggleOverlay, togglePlacing, togglePulling } from "../state/actions";
import type { Overlays } from "../state/session";
import { type IconName, icon } from "../ui/icons";
import { DesignerElement } from "./designer-element";
import "../ui/menu";
import { base, buttons } from "../ui/styles";
import { page } from "../words/english/page";
import { VIEWS, ZOOM } from "./views";

const OVERLAYS: readonly (keyof Overlays)[] = ["isoU", "isoV", "wireframe", "boundary", "axes", "cut"];

/** Those of surfaces from foot to rim. */
const LINES: readonly (keyof Overlays)[] = ["isoU", "isoV", "boundary"];

const ZOOMS: readonly {
  readonly name: "zoomOut" | "zoomIn" | "fit";
  readonly key: string;
  readonly icon: IconName;
  readonly act: (stage: Stage) => void;
}[] = [
  { name: "zoomOut", key: "−", icon: "less", act: (stage) => stage.zoom(1 / ZOOM) },
  { name: "zoomIn", key: "+", icon: "add", act: (stage) => stage.zoom(ZOOM) },
  { name: "fit", key: "F", icon: "fit", act: (stage) => stage.fit() },
];

@customElement("pasu-stage-tools")
export class PasuStageTools extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  /** Whether any part is a surface from foot to rim. */
  readonly #hasLines = computed(() =>
    this.designer.store.design.parts.some(
      ({ shape: { kind }, wall }) => kind !== "octant" && kind !== "vertex-frame" && (kind !== "blend" || wall),
    ),
  );

  override render() {
    return html`<div class="tools" role="toolbar" aria-label=${page.view}>
      <button
        class="button pull"
        type="button"
        aria-pressed=${this.designer.store.session.pulling ? "true" : "false"}
        title=${page.keyed(page.pull, "P")}
        @click=${() => this.designer.apply(togglePulling(this.designer.state))}
      >
        ${icon("pull")}<span>${page.pull}</span>
      </button>
      ${this.move()}
      <div class="views">${this.views("button")}</div>
      <div class="zooms">
        ${ZOOMS.map(
          ({ name, key, icon: sign, act }) =>
            html`<button class="button bare" type="button" aria-label=${page[name]} title=${page.keyed(page[name], key)} @click=${() => this.stage && act(this.stage)}>
              ${icon(sign)}
            </button>`,
        )}
      </div>
      <pasu-menu class="small" label=${page.view} icon="view" side="up" bare>
        ${this.views("button item")}
        ${ZOOMS.map(
          ({ name, icon: sign, act }) =>
            html`<button class="button item phone" type="button" @click=${() => this.stage && act(this.stage)}>
              ${icon(sign)}<span>${page[name]}</span>
            </button>`,
        )}
      </pasu-menu>
      <pasu-menu label=${page.overlays} icon="layers" side="up" bare>${this.overlays()}</pasu-menu>
    </div>`;
  }

  /** Moves whole parts, where there are several. By its key one alone is moved too. */
  private move() {
    const { designer } = this;
    const { ids, session } = designer.store;
    if (ids.length < 2 && !session.placing) return nothing;
    return html`<button
      class="button pull"
      type="button"
      aria-pressed=${session.placing ? "true" : "false"}
      title=${page.keyed(page.moveParts, "M")}
      @click=${() => designer.apply(togglePlacing(designer.state))}
    >
      ${icon("move")}<span>${page.move}</span>
    </button>`;
  }

  private views(style: string) {
    return VIEWS.map(
      (name) =>
        html`<button class=${style} type="button" @click=${() => this.stage?.view(name)}>${page.views[name]}</button>`,
    );
  }

  private overlays() {
    const { designer } = this;
    const { overlays } = designer.store.session;
    const none = this.#hasLines.value ? [] : LINES;
    const boxes = OVERLAYS.map(
      (name) => html`<label class="check" title=${none.includes(name) ? page.noLines : nothing}>
        <input
          type="checkbox"
          .checked=${overlays[name]}
          ?disabled=${none.includes(name)}
          @change=${() => designer.apply(toggleOverlay(designer.state, name))}
        />
        <span>${page.overlayNames[name]}</span>
      </label>`,
    );
    return html`${boxes}<button class="button item" type="button" @click=${this.linkView}>
        ${icon("link")}<span>${page.linkView}</span>
      </button>`;
  }

  private readonly linkView = (): void => {
    this.dispatchEvent(new Event("link-view", { bubbles: true, composed: true }));
  };

  static override readonly styles = [
    base,
    buttons,
    css`
      :host {
        flex: none;
      }
      .tools {
        display: flex;
        align-items: center;
        padding: 4px;
        border: 1px solid var(--line);
        border-radius: 13px;
        background: var(--sheet);
        box-shadow: 0 3px 14px var(--shadow);
        pointer-events: auto;
      }
      .pull {
        padding: 0 10px;
        font-size: 0.9rem;
      }
      .views {
        display: flex;
        margin-right: 4px;
        padding-right: 4px;
        border-right: 1px solid var(--line);
      }
      .views .button {
        padding: 0 10px;
        font-size: 0.9rem;
      }
      .zooms {
        display: flex;
      }
      .small {
        display: none;
      }
      .item {
        justify-content: flex-start;
      }
      .check {
        align-items: center;
        gap: 10px;
        min-height: var(--touch);
        padding: 0 10px;
        border-radius: 8px;
        white-space: nowrap;
        cursor: pointer;
      }
      .check:has(:disabled) {
        color: var(--soft);
        cursor: default;
      }
      .check:hover {
        background: var(--well);
      }
      .check input {
        width: 1.125rem;
        height: 1.125rem;
        margin: 0;
        accent-color: var(--accent);
      }
      @media (min-width: 53.75em) {
        .phone {
          display: none !important;
        }
      }
      @media (max-width: 77.4375em) {
        .views {
          display: none;
        }
        .small {
          display: inline-block;
        }
      }
      @media (max-width: 53.6875em) {
        .tools {
          padding: 1px;
        }
        .zooms {
          display: none;
        }
        .small {
          --menu-columns: auto auto;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-stage-tools": PasuStageTools;
  }
}
