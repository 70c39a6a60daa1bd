/** What turns while something is on its way. */

import { css } from "lit";

/** `--wheel` is how wide it is. */
export const wheel = css`
  .wheel {
    position: absolute;
    inset: 0;
    margin: auto;
    width: var(--wheel, 44px);
    height: var(--wheel, 44px);
    border: 3px solid var(--line);
    border-top-color: var(--accent);
    border-radius: 50%;
    animation: turn 1s linear infinite;
  }
  @keyframes turn {
    to {
      rotate: 1turn;
    }
  }
`;
