/** Labels in which a radio button lies unseen: which of them is chosen, and which has the focus. */

import { css } from "lit";

export const radios = css`
  .radio {
    position: relative;
    cursor: pointer;
  }
  .radio:hover {
    background: var(--well);
  }
  .radio:has(:checked) {
    border-color: var(--accent);
    background: var(--accent-wash);
    box-shadow: inset 0 0 0 1px var(--accent);
  }
  @media (forced-colors: active) {
    .radio:has(:checked) {
      outline: 2px solid Highlight;
      outline-offset: -2px;
    }
  }
  .radio:has([type="radio"]:focus-visible) {
    outline: 2.5px solid var(--accent);
    outline-offset: 2px;
  }
  .radio [type="radio"] {
    position: absolute;
    inset: 0;
    margin: 0;
    opacity: 0;
    cursor: pointer;
  }
`;
