/** A few choices beside each other, one of which holds: radio buttons that look like cards. */

import { css, html, nothing } from "lit";

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
        ({ value, label, note }) => html`<label>
          <input type="radio" name=${legend} .checked=${value === chosen} @change=${() => choose(value)} />
          <span class="name">${label}</span>${note === undefined ? nothing : html`<span class="note">${note}</span>`}
        </label>`,
      )}
    </div>
  </fieldset>`;
}

export const choiceStyles = css`
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
    position: relative;
    display: grid;
    align-content: center;
    min-height: var(--touch);
    padding: 7px 12px;
    border: 1px solid var(--line);
    border-radius: 10px;
    cursor: pointer;
  }
  .choices label:hover {
    background: var(--well);
  }
  .choices label:has(:checked) {
    border-color: var(--accent);
    background: var(--accent-wash);
    box-shadow: inset 0 0 0 1px var(--accent);
  }
  @media (forced-colors: active) {
    .choices label:has(:checked) {
      outline: 2px solid Highlight;
      outline-offset: -2px;
    }
  }
  .choices label:has(:focus-visible) {
    outline: 2.5px solid var(--accent);
    outline-offset: 2px;
  }
  .choices input {
    position: absolute;
    inset: 0;
    margin: 0;
    opacity: 0;
    cursor: pointer;
  }
  .choices .note {
    color: var(--soft);
    font-size: 0.84rem;
    line-height: 1.3;
  }
`;
