/** What a panel begins with: what the shape is, and a button beside that. Where that leaves the words less than half a line the button comes below. */

import { css } from "lit";

export const intro = css`
  .intro {
    display: flex;
    flex-wrap: wrap;
    align-items: flex-start;
    justify-content: space-between;
    gap: 8px 10px;
    padding-bottom: 10px;
    color: var(--soft);
  }
  .intro p {
    flex: 1 1 14rem;
    text-wrap: pretty;
  }
  .intro .button {
    flex: none;
  }
  .intro strong {
    color: var(--ink);
  }
`;
