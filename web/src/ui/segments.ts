/** A few choices beside each other in one piece. */

import { type CSSResultGroup, css, html, nothing, type TemplateResult } from "lit";
import { radios } from "./radios";

export function segments<T extends string>(
  legend: string,
  name: string,
  all: readonly T[],
  chosen: T,
  labels: Readonly<Record<T, string>>,
  help: Readonly<Record<T, string>> | null,
  choose: (value: T) => void,
): TemplateResult {
  return html`<fieldset>
    <legend class="spoken">${legend}</legend>
    ${all.map(
      (value) => html`<label class="radio" title=${help?.[value] ?? nothing}>
        <input type="radio" name=${name} .checked=${value === chosen} @change=${() => choose(value)} />
        <span>${labels[value]}</span>
      </label>`,
    )}
  </fieldset>`;
}

export const segmented: CSSResultGroup = [
  radios,
  css`
    fieldset {
      display: flex;
      margin: 0;
      padding: 0;
      border: 0;
      border-radius: 9px;
      background: var(--well);
    }
    fieldset label {
      display: grid;
      place-items: center;
      min-width: 40px;
      min-height: 34px;
      padding: 0 10px;
      border-radius: 9px;
      white-space: nowrap;
    }
    fieldset label:has(:checked) {
      color: var(--accent-strong);
    }
    @media (pointer: coarse) {
      fieldset label {
        min-height: var(--touch);
      }
    }
  `,
];
