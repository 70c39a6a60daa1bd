/** Handles on a drawing, which are dragged or moved by arrow keys: a knob, a ring round it where it has the focus, and as much room for a finger as its neighbours leave. */

import { css } from "lit";
import { ARROWS } from "./arrows";

/** With shift an arrow goes so many steps. */
const COARSE = 10;

/** How many steps a key goes to the right and up; null where it goes nowhere, or means something else. */
export function arrowOf({
  key,
  shiftKey,
}: Pick<KeyboardEvent, "key" | "shiftKey">): { readonly right: number; readonly up: number } | null {
  const arrow = ARROWS[key];
  const times = shiftKey ? COARSE : 1;
  return arrow ? { right: times * arrow[0], up: times * arrow[1] } : null;
}

interface Place {
  readonly x: number;
  readonly y: number;
}

/** How far round a handle a finger reaches it: half way to the nearest of the others, within bounds. */
export function reachOf({ x, y }: Place, others: readonly Place[], least: number, most: number): number {
  const nearest = Math.min(...others.map((other) => Math.hypot(other.x - x, other.y - y)));
  return Math.max(least, Math.min(most, nearest / 2));
}

export const handleStyles = css`
  .handle {
    cursor: move;
    outline: none;
  }
  .across {
    cursor: ew-resize;
  }
  .along {
    cursor: ns-resize;
  }
  .reach {
    fill: transparent;
  }
  .ring {
    fill: none;
    stroke: transparent;
    stroke-width: 2.5;
  }
  .knob {
    fill: var(--sheet);
    stroke: var(--accent);
    stroke-width: 2.4;
  }
  .handle:hover .knob {
    fill: var(--accent-wash);
  }
  .handle:active .knob {
    fill: var(--accent);
  }
  .handle:focus-visible .ring {
    stroke: var(--accent);
  }
`;
