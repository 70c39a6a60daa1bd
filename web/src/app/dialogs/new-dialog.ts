/** Choosing what a new design begins as, by its picture: a form, whatever chance draws, or a family of the equations. */

import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { BEGINNINGS } from "../../document/beginnings";
import { FORMS } from "../../document/forms";
import { BLENDED } from "../../document/gallery/blends";
import { designOf, type Exhibit } from "../../document/gallery/exhibit";
import { NETWORKED } from "../../document/gallery/networks";
import { OCTANTS } from "../../document/gallery/octants";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { icon } from "../../ui/icons";
import { base, buttons } from "../../ui/styles";
import { beginnings } from "../../words/english/beginnings";
import { networks } from "../../words/english/networks";
import { exhibitWords } from "../../words/gallery";
import { addBeside } from "../../work/beside";
import { openObj } from "../../work/network-files";
import { CommandEvent } from "../command";
import "./blend-chooser";
import type { BlendChosenEvent } from "./blend-chooser";
import { exhibitIn, Pictures, tileStyles, tiles } from "./pictures";

@customElement("pasu-new")
export class PasuNew extends DesignerElement {
  /** Whether what is chosen joins what stands there. */
  @state() private beside = false;
  private pictures: Pictures | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.pictures?.end();
    this.pictures = null;
  }

  override render() {
    return html`<pasu-dialog wide heading=${beginnings.heading} @dialog-closed=${this.close}>
      <div class="lead">
        <p>${beginnings.lead}</p>
        <button class="button outlined" type="button" title=${beginnings.surpriseNote} @click=${this.surprise}>
          ${icon("chance")}<span>${beginnings.surprise}</span>
        </button>
        <button class="button outlined" type="button" @click=${this.draw}>${icon("paper")}<span>${beginnings.draw}</span></button>
        <button class="button outlined" type="button" @click=${this.scan}>${icon("layers")}<span>${beginnings.scan}</span></button>
      </div>
      <label class="beside">
        <input
          type="checkbox"
          .checked=${this.beside}
          @change=${(event: Event) => {
            this.beside = (event.target as HTMLInputElement).checked;
          }}
        />
        <span>${beginnings.beside}<span class="note">${beginnings.besideNote}</span></span>
      </label>
      ${tiles(
        FORMS,
        (id) => beginnings.forms[id],
        (form) => this.choose(form),
      )}
      <details class="blends" @toggle=${show}>
        <summary>${beginnings.blends}</summary>
        <p>${beginnings.blendsLead}</p>
        <pasu-blend-chooser @blend-chosen=${({ exhibit }: BlendChosenEvent) => this.choose(exhibit)}></pasu-blend-chooser>
        ${tiles(BLENDED, exhibitWords, (pot) => this.choose(pot))}
      </details>
      <details class="networks" @toggle=${show}>
        <summary>${beginnings.networks}</summary>
        <p>${beginnings.networksLead}</p>
        <p><button class="button outlined" type="button" @click=${this.openObj}>${icon("open")}<span>${networks.openObj}</span></button></p>
        ${tiles(NETWORKED, exhibitWords, (pot) => this.choose(pot))}
      </details>
      <details class="octants" @toggle=${show}>
        <summary>${beginnings.octants}</summary>
        <p>${beginnings.octantsLead}</p>
        ${tiles(OCTANTS, exhibitWords, (pot) => this.choose(pot))}
      </details>
      <details @toggle=${show}>
        <summary>${beginnings.equations}</summary>
        <p>${beginnings.equationsLead}</p>
        ${tiles(
          BEGINNINGS,
          (id) => beginnings.families[id],
          (beginning) => this.choose(beginning),
        )}
      </details>
    </pasu-dialog>`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.watchPictures();
  }

  override firstUpdated(): void {
    this.watchPictures();
  }

  private watchPictures(): void {
    if (this.pictures || !this.hasUpdated) return;
    this.pictures = new Pictures(
      this.designer,
      exhibitIn([...FORMS, ...BLENDED, ...NETWORKED, ...OCTANTS, ...BEGINNINGS]),
    );
    this.pictures.watch(this.renderRoot);
  }

  /** The form as a document of its own; its title is left to the person. */
  private async choose(beginning: Exhibit): Promise<void> {
    if (this.beside) {
      if (await addBeside(this.designer, designOf(beginning))) this.close();
      return;
    }
    this.designer.opening.open(designOf(beginning));
    this.close();
  }

  private readonly openObj = async (): Promise<void> => {
    if (await openObj(this.designer)) this.close();
  };

  private readonly draw = (): void => {
    this.close();
    this.dispatchEvent(new CommandEvent("draw"));
  };

  private readonly scan = (): void => {
    this.close();
    this.dispatchEvent(new CommandEvent("scan"));
  };

  private readonly surprise = (): void => {
    this.dispatchEvent(new CommandEvent("surprise"));
    this.close();
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("new-closed"));
  };

  static override readonly styles = [
    base,
    buttons,
    tileStyles,
    css`
      p {
        color: var(--soft);
      }
      .lead {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 10px 18px;
        padding-bottom: 14px;
      }
      .lead p {
        flex: 1 1 16rem;
      }
      .beside {
        display: flex;
        align-items: center;
        gap: 10px;
        width: fit-content;
        min-height: var(--touch);
        margin-bottom: 12px;
        cursor: pointer;
      }
      .beside .note {
        display: block;
        color: var(--soft);
        font-size: 0.86rem;
      }
      [type="checkbox"] {
        flex: none;
        width: 18px;
        height: 18px;
        margin: 0;
        accent-color: var(--accent);
      }
      details {
        margin-top: 18px;
        border-top: 1px solid var(--line);
      }
      summary {
        min-height: var(--touch);
        padding: 12px 0;
        font-weight: 600;
        cursor: pointer;
      }
      details p {
        padding-bottom: 12px;
      }
    `,
  ];
}

/** What is unfolded at the end of a long dialogue is below its edge. */
function show({ target }: Event): void {
  if (target instanceof HTMLDetailsElement && target.open) target.scrollIntoView({ block: "start" });
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-new": PasuNew;
  }
}
