/** What to put into a page of one's own to have the pot there, with the pot as it will be seen. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { pathText } from "../../document/path";
import { DesignerElement } from "../../element/designer-element";
import { familyIn } from "../../element/pot/controls";
import "../../element/pot/define";
import { makers } from "../../element/pot/shared-maker";
import { solvers } from "../../element/pot/shared-solver";
import "../../ui/dialog";
import { checks } from "../../ui/checks";
import { icon } from "../../ui/icons";
import { base, buttons, fields } from "../../ui/styles";
import { embed } from "../../words/english/embed";
import { fieldWords } from "../../words/parameters";
import { type Embedding, elementSnippet, frameSnippet } from "./embed-snippets";

/** Where the element is on the site; put in by the build. */
declare const __PASU_POT__: string;

type Which = "element" | "frame";

@customElement("pasu-embed")
export class PasuEmbed extends DesignerElement {
  /** The whole address of the design. */
  @property() address = "";
  @state() private alt: string | null = null;
  @state() private turns = false;
  @state() private controls: readonly string[] = [];
  @state() private said: { readonly which: Which; readonly words: string } | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    // The page has a solver, and perhaps a maker: a second one would wait for the same cores.
    solvers.lend(this.designer.solver);
    makers.lend(this.designer.made?.maker ?? null);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    solvers.lend(null);
    makers.lend(null);
  }

  private get embedding(): Embedding {
    const address = new URL(this.address);
    return {
      site: new URL(".", address).href.replace(/[?#].*$/s, ""),
      folder: __PASU_POT__,
      link: address.hash,
      alt: this.alt ?? this.designer.description,
      controls: this.controls,
      turns: this.turns,
    };
  }

  override render() {
    const { embedding } = this;
    const { alt, link } = embedding;
    return html`<pasu-dialog wide heading=${embed.heading} @dialog-closed=${() => this.dispatchEvent(new Event("embed-closed"))}>
      <div class="columns">
        <figure>
          <figcaption>${embed.preview}</figcaption>
          <pasu-pot
            loading="eager"
            src=${link}
            alt=${alt}
            controls=${this.controls.join(",")}
            theme=${this.scheme}
            ?auto-rotate=${this.turns}
          ></pasu-pot>
        </figure>
        <div class="choices">
          <label class="own">
            <span>${embed.alt}</span>
            <input
              class="field"
              autocomplete="off"
              .value=${alt}
              @input=${(event: Event) => {
                this.alt = (event.target as HTMLInputElement).value;
              }}
            />
          </label>
          <label class="check">
            <input
              type="checkbox"
              .checked=${this.turns}
              @change=${() => {
                this.turns = !this.turns;
              }}
            />
            <span>${embed.turns}</span>
          </label>
          ${this.parameters()} ${this.snippet("element", elementSnippet(embedding))}
          ${this.snippet("frame", frameSnippet(embedding))}
        </div>
      </div>
    </pasu-dialog>`;
  }

  private get scheme() {
    const { theme } = this.designer.store.session;
    return theme === "auto" ? nothing : theme;
  }

  private parameters() {
    const family = familyIn(this.designer.store.design);
    if (!family) return nothing;
    return html`<details>
      <summary>${embed.parameters}</summary>
      <ul>
        ${family.fields.map(({ key: field, path }) => {
          const key = pathText(path);
          return html`<li>
            <label class="check">
              <input type="checkbox" .checked=${this.controls.includes(key)} @change=${() => this.toggle(key)} />
              <span>${fieldWords(family.kind, field).name} <code>${key}</code></span>
            </label>
          </li>`;
        })}
      </ul>
    </details>`;
  }

  /** What was chosen last comes last. */
  private toggle(key: string): void {
    const others = this.controls.filter((each) => each !== key);
    this.controls = others.length < this.controls.length ? others : [...others, key];
  }

  private snippet(which: Which, text: string) {
    return html`<div class="snippet">
      <label for=${which}>${embed[which]}</label>
      <textarea id=${which} class="field" readonly rows="4" spellcheck="false" .value=${text}></textarea>
      <div class="copy">
        <span role="status">${this.said?.which === which ? this.said.words : ""}</span>
        <button class="button outlined" type="button" aria-label=${embed.copyWhat(embed[which])} @click=${() => void this.copy(which, text)}>
          ${icon("copy")} ${embed.copy}
        </button>
      </div>
    </div>`;
  }

  private async copy(which: Which, text: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      this.said = { which, words: embed.copied };
    } catch {
      this.renderRoot.querySelector<HTMLTextAreaElement>(`#${which}`)?.select();
      this.said = { which, words: embed.byHand };
    }
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    checks,
    css`
      .columns {
        display: grid;
        grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
        gap: 24px;
      }
      figure {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        align-self: start;
        position: sticky;
        top: 0;
      }
      figcaption,
      .own span,
      .snippet label,
      summary {
        padding-bottom: 4px;
        color: var(--soft);
        font-size: 0.9rem;
      }
      pasu-pot {
        width: 100%;
        height: min(440px, 50dvh);
        border: 1px solid var(--line);
        border-radius: 12px;
      }
      .choices {
        display: grid;
        align-content: start;
        gap: 10px;
      }
      .own {
        display: grid;
      }
      summary {
        display: list-item;
        min-height: 30px;
        cursor: pointer;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(min(13.125rem, 100%), 1fr));
      }
      code {
        color: var(--soft);
        font-size: 0.86em;
      }
      textarea {
        display: block;
        width: 100%;
        padding: 8px 10px;
        resize: vertical;
        font: 0.82rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace;
        overflow-wrap: anywhere;
      }
      .snippet label {
        display: block;
      }
      .copy {
        display: flex;
        align-items: center;
        justify-content: flex-end;
        gap: 12px;
        padding-top: 6px;
        color: var(--soft);
        font-size: 0.9rem;
      }
      @media (max-width: 44.9375em) {
        .columns {
          grid-template-columns: minmax(0, 1fr);
        }
        figure {
          position: static;
        }
        pasu-pot {
          height: 36dvh;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-embed": PasuEmbed;
  }
}
