/** A section from above, small, with the other one behind it as large as it is beside it. */

import { css, nothing, svg } from "lit";
import { borderOf } from "../../document/blend/section";
import type { Pair, Section } from "../../document/types";

/** The side of the drawing, in its own units. */
const SIDE = 100;
const MARGIN = 8;

/** Both go by one scale: `reach` is the edge of the drawing. */
export function sectionDrawing(section: Section, other: Section | null, reach: number, name: string) {
  const scale = (SIDE / 2 - MARGIN) / Math.max(reach, Number.MIN_VALUE);
  const border = borderOf(section);
  const [first] = border;
  const at = ([x, y]: Pair): Pair => [SIDE / 2 + scale * x, SIDE / 2 - scale * y];
  const begin = first ? at(first) : null;
  return svg`<svg class="section" viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label=${name}>
    <path class="border" d=${pathOf(border.map(at))} />
    ${other ? svg`<path class="other" d=${pathOf(borderOf(other).map(at))} />` : nothing}
    <path class="middle" d="M${SIDE / 2 - 3} ${SIDE / 2}h6M${SIDE / 2} ${SIDE / 2 - 3}v6" />
    ${begin ? svg`<circle class="seam" cx=${begin[0].toFixed(2)} cy=${begin[1].toFixed(2)} r="2.6" />` : nothing}
  </svg>`;
}

function pathOf(points: readonly Pair[]): string {
  return `${points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("")}Z`;
}

export const drawingStyles = css`
  .section {
    display: block;
    width: 100%;
    aspect-ratio: 1;
  }
  .section path {
    fill: none;
    stroke-linejoin: round;
    vector-effect: non-scaling-stroke;
  }
  .section .border {
    fill: var(--accent-wash);
    stroke: var(--accent);
    stroke-width: 2;
  }
  .section .other {
    stroke: var(--edge);
    stroke-width: 1;
    stroke-dasharray: 3 3;
  }
  .section .middle {
    stroke: var(--soft);
    stroke-width: 1;
  }
  .section .seam {
    fill: var(--sheet);
    stroke: var(--accent);
    stroke-width: 1.6;
  }
`;
