/** The keys, and what Pasu is. */

import { css, html, LitElement } from "lit";
import { customElement } from "lit/decorators.js";
import "../../ui/dialog";
import { base } from "../../ui/styles";

const APPLE = /Mac|iPhone|iPad/.test(navigator.userAgent);

const KEYS: readonly (readonly [string, readonly (readonly [string, string])[]])[] = [
  [
    "Anywhere",
    [
      ["Ctrl Z", "Undo"],
      ["Ctrl Shift Z, Ctrl Y", "Redo"],
      ["Ctrl S", "Save as a file"],
      ["Ctrl O", "Open a file"],
      ["?", "This list"],
    ],
  ],
  [
    "On the pot",
    [
      ["Arrows", "Turn"],
      ["Shift arrows", "Move"],
      ["+ −", "Zoom"],
      ["F", "Fit to view"],
      ["1 to 5", "Three-quarter, front, side, top, below"],
    ],
  ],
  [
    "On the water",
    [
      ["Arrows", "Up and down by a hundredth"],
      ["Shift arrows", "By a tenth"],
      ["Home, End", "Empty, full to the brim"],
    ],
  ],
  [
    "In the list of parts",
    [
      ["Arrows", "Select"],
      ["Alt arrows", "Move the part up or down the list"],
      ["H", "Hide the part, or show it"],
      ["D", "Make a copy beside it"],
      ["F2", "Name it"],
      ["Delete", "Take it away; undo brings it back"],
    ],
  ],
  [
    "On a number",
    [
      ["Arrows", "One step"],
      ["Shift arrows", "Ten steps"],
      ["Delete on a slider", "Reset; so does a double click"],
      ["Escape", "Forget what was typed"],
    ],
  ],
];

@customElement("pasu-help")
export class PasuHelp extends LitElement {
  override render() {
    return html`<pasu-dialog reading heading="Help" @dialog-closed=${() => this.dispatchEvent(new Event("help-closed"))}>
      <p>
        Pasu makes pots from partial differential equations: you choose the edges of a pot, and how the wall runs between them follows from an
        equation, exactly. The whole pot is in its link: whoever opens it sees the same pot.
      </p>
      <p>
        A wall makes a surface a pot, which has a capacity, a weight and a foot to stand on: under Measures they are told, and Export saves a file
        for a printer, a CAD program or a potter's wheel. Every such file holds its link: dropped on this page, it opens again.
      </p>
      <p>
        With a mouse: drag to turn, drag with the right button to move, roll the wheel to zoom. With fingers: one turns, two move and zoom.
        Files and links can be dropped on the page.
      </p>
      ${KEYS.map(
        ([title, keys]) => html`<section>
          <h3>${title}</h3>
          <dl>
            ${keys.map(([key, what]) => html`<div><dt><kbd>${APPLE ? key.replaceAll("Ctrl", "⌘") : key}</kbd></dt><dd>${what}</dd></div>`)}
          </dl>
        </section>`,
      )}
      <p class="sources">
        After J. J. Zhang and L. You, <cite>Surface representation using second, fourth and mixed order partial differential equations</cite> (2001),
        and S. N. Ishak and J. M. Ali, <cite>Parametric surface generation using partial differential equation based approach</cite>.
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
