/** A bar over the upper edge of the stage. */

import { css } from "lit";

export const barStyles = css`
  :host {
    position: absolute;
    z-index: 3;
    inset: 12px 12px auto;
    display: grid;
    justify-items: center;
    gap: 6px;
    pointer-events: none;
  }
  .bar {
    display: flex;
    align-items: center;
    justify-content: center;
    gap: 4px 10px;
    padding: 4px 8px;
    border: 1px solid var(--line);
    border-radius: 13px;
    background: var(--sheet);
    box-shadow: 0 3px 14px var(--shadow);
    font-size: 0.9rem;
    pointer-events: auto;
  }
`;
