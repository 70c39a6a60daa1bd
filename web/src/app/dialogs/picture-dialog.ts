/** Saving the picture on the stage as a PNG of a chosen size. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { parseNumber } from "../../number";
import "../../ui/dialog";
import { checks } from "../../ui/checks";
import { base, buttons, fields } from "../../ui/styles";
import { picture } from "../../words/english/picture";

export interface PictureSize {
  readonly width: number;
  readonly height: number;
  readonly transparent: boolean;
}

const SIZES = [
  { name: "square", width: 1600, height: 1600 },
  { name: "wide", width: 1920, height: 1080 },
  { name: "tall", width: 1200, height: 1600 },
  { name: "large", width: 3000, height: 3000 },
] as const;
const LEAST = 16;
const MOST = 8192;

@customElement("pasu-picture")
export class PasuPicture extends LitElement {
  /** Draws and saves; resolves to a sentence when that did not work. */
  @property({ attribute: false }) save: (size: PictureSize) => Promise<string | null> = async () => null;
  @state() private chosen = 0;
  @state() private width = "1600";
  @state() private height = "1600";
  @state() private transparent = false;
  @state() private problem = "";
  @state() private busy = false;

  override render() {
    const own = this.chosen === SIZES.length;
    return html`<pasu-dialog ruled heading=${picture.heading} @dialog-closed=${this.close}>
      <p class="lead">${picture.lead}</p>
      <fieldset>
        <legend>${picture.size}</legend>
        ${SIZES.map(({ name, width, height }, index) => this.choice(index, picture.sizes[name], picture.pixels(width, height)))}
        ${this.choice(SIZES.length, picture.own, "")}
      </fieldset>
      ${
        own
          ? html`<div class="own">
              ${this.side(picture.width, this.width, (text) => {
                this.width = text;
              })}
              ${this.side(picture.height, this.height, (text) => {
                this.height = text;
              })}
            </div>`
          : nothing
      }
      <label class="check">
        <input
          type="checkbox"
          .checked=${this.transparent}
          @change=${(event: Event) => {
            this.transparent = (event.target as HTMLInputElement).checked;
          }}
        />
        <span>${picture.transparent}</span>
      </label>
      <p class="problem" role="alert">${this.problem}</p>
      <button slot="actions" class="button" type="button" @click=${this.close}>${picture.cancel}</button>
      <button slot="actions" class="button primary" type="button" ?disabled=${this.busy} @click=${this.go}>${picture.save}</button>
    </pasu-dialog>`;
  }

  private choice(index: number, name: string, size: string) {
    return html`<label class="check">
      <input
        type="radio"
        name="size"
        .checked=${this.chosen === index}
        @change=${() => {
          this.chosen = index;
        }}
      />
      <span>${name}</span><span class="size">${size}</span>
    </label>`;
  }

  private side(label: string, value: string, set: (text: string) => void) {
    return html`<label>
      <span>${label}</span>
      <input class="field" inputmode="numeric" autocomplete="off" .value=${value} @input=${(event: Event) => set((event.target as HTMLInputElement).value)} />
    </label>`;
  }

  private readonly close = (): void => {
    this.dispatchEvent(new Event("picture-closed"));
  };

  private readonly go = async (): Promise<void> => {
    const preset = SIZES[this.chosen];
    const width = preset?.width ?? sideOf(this.width);
    const height = preset?.height ?? sideOf(this.height);
    if (width === null || height === null) {
      this.problem = picture.wrongSize(LEAST, MOST);
      return;
    }
    this.problem = "";
    this.busy = true;
    const problem = await this.save({ width, height, transparent: this.transparent });
    this.busy = false;
    if (problem === null) this.close();
    else this.problem = problem;
  };

  static override readonly styles = [
    base,
    buttons,
    fields,
    checks,
    css`
      .lead {
        color: var(--soft);
        padding-bottom: 10px;
      }
      fieldset {
        margin: 0;
        padding: 0;
        border: 0;
      }
      legend {
        padding: 0;
        font-weight: 650;
      }
      .size {
        margin-left: auto;
        color: var(--soft);
        font-variant-numeric: tabular-nums;
      }
      .own {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 12px;
        padding-bottom: 8px;
      }
      .own label {
        display: grid;
        gap: 4px;
        color: var(--soft);
        font-size: 0.9rem;
      }
      .problem {
        color: var(--warn);
      }
    `,
  ];
}

function sideOf(text: string): number | null {
  const typed = parseNumber(text);
  if (!("value" in typed) || !Number.isInteger(typed.value)) return null;
  return typed.value >= LEAST && typed.value <= MOST ? typed.value : null;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-picture": PasuPicture;
  }
}
