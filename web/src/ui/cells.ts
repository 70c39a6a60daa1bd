/** Compact numbers with a small word above each, as in a table. */

import { css } from "lit";

export const cells = css`
  .cell {
    display: grid;
    gap: 3px;
    min-width: 0;
    color: var(--soft);
    font-size: 0.82rem;
  }
  .cell pasu-number {
    padding: 0;
    color: var(--ink);
    font-size: 0.94rem;
  }
`;
