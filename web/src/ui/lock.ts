/** The button below numbers that go together, or each by itself: small, and no colour of its own. */

import { css } from "lit";

export const lock = css`
  .lock {
    min-height: 30px;
    padding: 0 8px;
    margin-left: -8px;
    color: var(--soft);
    font-size: 0.84rem;
  }
  .lock[aria-pressed="true"] {
    background: none;
    color: var(--soft);
  }
  .lock .icon {
    width: 16px;
    height: 16px;
  }
  @media (pointer: coarse) {
    .lock {
      min-height: var(--touch);
    }
  }
`;
