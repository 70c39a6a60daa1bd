/** Boxes and knobs with their words beside them: what may be ticked. */

import { css } from "lit";

export const checks = css`
  .check {
    display: flex;
    align-items: center;
    gap: 10px;
    min-height: var(--touch);
    cursor: pointer;
  }
  .check input {
    flex: none;
    width: 1.125rem;
    height: 1.125rem;
    margin: 0;
    accent-color: var(--accent);
  }
`;
