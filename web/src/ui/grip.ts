/** A place of the stage that a hand takes hold of: a ring on it, with as much room as a finger needs. */

import { css } from "lit";

export const gripStyles = css`
  .grip {
    position: absolute;
    top: -14px;
    left: -14px;
    width: 28px;
    height: 28px;
    padding: 0;
    border: 0;
    border-radius: 50%;
    background: none;
    cursor: grab;
    touch-action: none;
    pointer-events: auto;
  }
  .grip::before {
    content: "";
    position: absolute;
    inset: 8px;
    border: 2.5px solid var(--accent);
    border-radius: 50%;
    background: var(--sheet);
    box-shadow: 0 1px 4px var(--shadow);
  }
  @media (pointer: coarse) {
    .grip {
      top: -20px;
      left: -20px;
      width: 40px;
      height: 40px;
    }
    .grip::before {
      inset: 13px;
    }
  }
  .grip:hover::before {
    background: var(--accent-wash);
  }
  .grip:active::before {
    background: var(--accent);
  }
  .grip:focus-visible {
    outline-offset: -3px;
  }
`;
