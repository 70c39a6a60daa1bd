/** What is told of something that was asked: what it is for, what was found, and what went wrong. */

import { css } from "lit";

export const told = css`
  .lead,
  .hint {
    padding-bottom: 10px;
    color: var(--soft);
    text-wrap: pretty;
  }
  .hint {
    padding: 8px 0 2px;
  }
  .trouble {
    margin: 8px 0;
    padding: 8px 12px;
    border-radius: 9px;
    background: var(--warn-wash);
    color: var(--warn);
    font-size: 0.92rem;
    text-wrap: pretty;
  }
  .found {
    flex: 1;
    color: var(--ink);
    font-weight: 600;
  }
  .warn {
    color: var(--warn);
    font-weight: 400;
  }
`;
