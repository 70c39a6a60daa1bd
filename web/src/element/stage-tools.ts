/** The tools at the foot of the stage: standard views, zoom, and what is drawn over the pot. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Stage } from "../render/stage";
import { toggleOverlay } from "../state/actions";
import type { Overlays } from "../state/session";
import { type IconName, icon } from "../ui/icons";
import { DesignerElement } from "./designer-element";
import "../ui/menu";
import { base, buttons } from "../ui/styles";
import { VIEWS, ZOOM } from "./views";

const OVERLAYS: readonly { readonly name: keyof Overlays; readonly label: string }[] = [
  { name: "isoU", label: "Lines round the pot (u)" },
  { name: "isoV", label: "Lines up the wall (v)" },
  { name: "wireframe", label: "Wireframe" },
  { name: "boundary", label: "Rim, foot and tangents" },
  { name: "axes", label: "Axes and dimensions" },
  { name: "cut", label: "Cut open" },
];

const ZOOMS: readonly {
  readonly label: string;
  readonly key: string;
  readonly icon: IconName;
  readonly act: (stage: Stage) => void;
}[] = [
  { label: "Zoom out", key: "−", icon: "less", act: (stage) => stage.zoom(1 / ZOOM) },
  { label: "Zoom in", key: "+", icon: "add", act: (stage) => stage.zoom(ZOOM) },
  { label: "Fit to view", key: "F", icon: "fit", act: (stage) => stage.fit() },
];

@customElement("pasu-stage-tools")
export class PasuStageTools extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;

  override render() {
    return html`<div class="tools" role="toolbar" aria-label="View">
      <div class="views">${this.views("button")}</div>
      <div class="zooms">
        ${ZOOMS.map(
          ({ label, key, icon: name, act }) =>
            html`<button class="button bare" type="button" aria-label=${label} title="${label} (${key})" @click=${() => this.stage && act(this.stage)}>
              ${icon(name)}
            </button>`,
        )}
      </div>
      <pasu-menu class="small" label="View" icon="view" side="up" bare>
        ${this.views("button item")}
        ${ZOOMS.map(
          ({ label, icon: name, act }) =>
            html`<button class="button item phone" type="button" @click=${() => this.stage && act(this.stage)}>
              ${icon(name)}<span>${label}</span>
            </button>`,
        )}
      </pasu-menu>
      <pasu-menu label="Overlays" icon="layers" side="up" bare>${this.overlays()}</pasu-menu>
    </div>`;
  }

  private views(style: string) {
    return VIEWS.map(
      ({ name, label }) =>
        html`<button class=${style} type="button" @click=${() => this.stage?.view(name)}>${label}</button>`,
    );
  }

  private overlays() {
    const { designer } = this;
    const { overlays } = designer.store.session;
    return OVERLAYS.map(
      ({ name, label }) => html`<label class="check">
        <input
          type="checkbox"
          .checked=${overlays[name]}
          @change=${() => designer.apply(toggleOverlay(designer.state, name))}
        />
        <span>${label}</span>
      </label>`,
    );
  }

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
      .check:hover {
        background: var(--well);
      }
      .check input {
        width: 18px;
        height: 18px;
        margin: 0;
        accent-color: var(--accent);
      }
      @media (min-width: 860px) {
        .phone {
          display: none !important;
        }
      }
      @media (max-width: 1239px) {
        .views {
          display: none;
        }
        .small {
          display: inline-block;
        }
      }
      @media (max-width: 859px) {
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
