/** The keys, and what Pasu is. */

import { css, html, LitElement } from "lit";
import { customElement } from "lit/decorators.js";
import "../../ui/dialog";
import { base } from "../../ui/styles";
import { help } from "../../words/english/help";
import { filled } from "../../words/filled";

const APPLE = /Mac|iPhone|iPad/.test(navigator.userAgent);

@customElement("pasu-help")
export class PasuHelp extends LitElement {
  override render() {
    return html`<pasu-dialog reading heading=${help.heading} @dialog-closed=${() => this.dispatchEvent(new Event("help-closed"))}>
      ${help.about.map((text) => html`<p>${text}</p>`)}
      ${help.keys.map(
        ({ title, keys }) => html`<section>
          <h3>${title}</h3>
          <dl>
            ${keys.map(([key, what]) => html`<div><dt><kbd>${APPLE ? key.replaceAll("Ctrl", "⌘") : key}</kbd></dt><dd>${what}</dd></div>`)}
          </dl>
        </section>`,
      )}
      <p class="sources">
        ${filled(
          help.sources,
          help.papers.map((title) => html`<cite>${title}</cite>`),
        )}
      </p>
    </pasu-dialog>`;
  }

  static override readonly styles = [
    base,
    css`
      p {
        padding-bottom: 10px;
        text-wrap: pretty;
      }
      h3 {
        padding: 8px 0 4px;
        font-size: 0.95rem;
      }
      dl {
        display: grid;
        gap: 5px;
        margin: 0;
      }
      dl div {
        display: grid;
        grid-template-columns: 168px 1fr;
        gap: 12px;
      }
      dd {
        margin: 0;
      }
      kbd {
        padding: 1px 7px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--well);
        font: inherit;
        font-size: 0.88em;
      }
      .sources {
        padding-top: 16px;
        color: var(--soft);
        font-size: 0.88rem;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-help": PasuHelp;
  }
}
