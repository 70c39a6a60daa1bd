/** Something that is offered in its place in a panel: a card with a heading and what can be done about it. */

import { css } from "lit";

export const card = css`
  section {
    margin-bottom: 14px;
    padding: 12px 14px 14px;
    border-radius: 12px;
    background: var(--well);
  }
  section h3 {
    font-size: 1rem;
    font-weight: 650;
    overflow-wrap: anywhere;
  }
  .acts {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
    padding-top: 8px;
  }
`;
