/** Colours that stand for numbers, with the numbers below them. */

import { css, html } from "lit";

type Rgb = readonly [number, number, number];

/** `ends` are those of the colours and what is in the middle, in words; `label` says all of it. */
export function rampLegend(label: string, [low, middle, high]: readonly [string, string, string]) {
  return html`
    <div class="ramp" role="img" aria-label=${label}></div>
    <p class="ends" aria-hidden="true"><span>${low}</span><span>${middle}</span><span>${high}</span></p>
  `;
}

/** Gives the legends in `host` their colours, from the least to the greatest. */
export function colourRamp(host: HTMLElement, ramp: readonly Rgb[]): void {
  const stops = ramp.map((rgb) => `rgb(${rgb.join(" ")})`);
  host.style.setProperty("--ramp", `linear-gradient(to right, ${stops.join(", ")})`);
}

export const rampStyles = css`
  .ramp {
    height: 16px;
    border: 1px solid var(--line);
    border-radius: 8px;
    background: var(--ramp);
    forced-color-adjust: none;
  }
  .ends {
    display: flex;
    justify-content: space-between;
    padding-top: 3px;
    font-size: 0.84rem;
    font-variant-numeric: tabular-nums;
  }
`;
