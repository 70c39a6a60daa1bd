/** A few choices beside each other in one piece. */

import { css, html, nothing, type TemplateResult } from "lit";

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
      (value) => html`<label title=${help?.[value] ?? nothing}>
        <input type="radio" name=${name} .checked=${value === chosen} @change=${() => choose(value)} />
        <span>${labels[value]}</span>
      </label>`,
    )}
  </fieldset>`;
}

export const segmented = css`
  fieldset {
    display: flex;
    margin: 0;
    padding: 0;
    border: 0;
    border-radius: 9px;
    background: var(--well);
  }
  fieldset label {
    position: relative;
    display: grid;
    place-items: center;
    min-width: 40px;
    min-height: 34px;
    padding: 0 10px;
    border-radius: 9px;
    white-space: nowrap;
    cursor: pointer;
  }
  fieldset label:has(:checked) {
    background: var(--accent-wash);
    color: var(--accent-strong);
    box-shadow: inset 0 0 0 1px var(--accent);
  }
  @media (forced-colors: active) {
    fieldset label:has(:checked) {
      outline: 2px solid Highlight;
      outline-offset: -2px;
    }
  }
  fieldset label:has(:focus-visible) {
    outline: 2.5px solid var(--accent);
    outline-offset: 2px;
  }
  fieldset input {
    position: absolute;
    inset: 0;
    margin: 0;
    opacity: 0;
    cursor: pointer;
  }
  @media (pointer: coarse) {
    fieldset label {
      min-height: var(--touch);
    }
  }
`;
