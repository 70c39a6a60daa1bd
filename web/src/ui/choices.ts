/** A few choices beside each other, one of which holds: radio buttons that look like cards. */

import { type CSSResultGroup, css, html, nothing } from "lit";
import { radios } from "./radios";

export interface Choice<T extends string> {
  readonly value: T;
  readonly label: string;
  readonly note?: string;
}

export function choices<T extends string>(
  legend: string,
  all: readonly Choice<T>[],
  chosen: T | null,
  choose: (value: T) => void,
) {
  return html`<fieldset class="choices">
    <legend>${legend}</legend>
    <div>
      ${all.map(
        ({ value, label, note }) => html`<label class="radio">
          <input type="radio" name=${legend} .checked=${value === chosen} @change=${() => choose(value)} />
          <span class="name">${label}</span>${note === undefined ? nothing : html`<span class="note">${note}</span>`}
        </label>`,
      )}
    </div>
  </fieldset>`;
}

export const choiceStyles: CSSResultGroup = [
  radios,
  css`
    .choices {
      margin: 12px 0 0;
      padding: 0;
      border: 0;
    }
    .choices legend {
      padding: 0 0 6px;
      font-weight: 600;
    }
    .choices div {
      display: grid;
      grid-template-columns: repeat(auto-fit, minmax(min(9.375rem, 100%), 1fr));
      gap: 8px;
    }
    .choices label {
      display: grid;
      align-content: center;
      min-height: var(--touch);
      padding: 7px 12px;
      border: 1px solid var(--line);
      border-radius: 10px;
    }
    .choices .note {
      color: var(--soft);
      font-size: 0.84rem;
      line-height: 1.3;
    }
  `,
];
