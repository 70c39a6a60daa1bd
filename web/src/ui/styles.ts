/** Styles that every component shares, as constructed style sheets. */

import { css } from "lit";

export const base = css`
  :host {
    box-sizing: border-box;
  }
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  [hidden] {
    display: none !important;
  }
  h1,
  h2,
  h3,
  h4,
  p,
  ul,
  figure {
    margin: 0;
    padding: 0;
  }
  ul {
    list-style: none;
  }
  button,
  input,
  select {
    font: inherit;
    color: inherit;
  }
  :focus-visible {
    outline: 2.5px solid var(--accent);
    outline-offset: 2px;
  }
  .icon {
    width: 1.25rem;
    height: 1.25rem;
    flex: none;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.7;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .spoken {
    position: absolute;
    width: 1px;
    height: 1px;
    margin: -1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  @media (prefers-reduced-motion: reduce) {
    *,
    *::before,
    *::after {
      animation: none !important;
      transition: none !important;
      scroll-behavior: auto !important;
    }
  }
`;

export const buttons = css`
  .button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: 7px;
    min-width: var(--touch);
    min-height: var(--touch);
    padding: 0 12px;
    border: 1px solid transparent;
    border-radius: var(--radius);
    background: transparent;
    color: var(--ink);
    text-decoration: none;
    white-space: nowrap;
    cursor: pointer;
    transition: background-color 120ms;
  }
  .button.bare {
    padding: 0;
  }
  .button:hover:not(:disabled, [aria-disabled="true"]) {
    background: var(--well);
  }
  .button:is(:disabled, [aria-disabled="true"]) {
    color: var(--edge);
    cursor: default;
  }
  .button.outlined {
    border-color: var(--line);
    background: var(--sheet);
  }
  .button.primary {
    background: var(--accent);
    color: var(--on-accent);
    font-weight: 550;
  }
  .button.primary:is(:disabled, [aria-disabled="true"]) {
    background: var(--well);
    color: var(--soft);
  }
  .button.primary:hover:not(:disabled, [aria-disabled="true"]) {
    background: var(--accent-strong);
  }
  .button[aria-pressed="true"],
  .button[aria-checked="true"] {
    background: var(--accent-wash);
    color: var(--accent-strong);
  }
  @media (forced-colors: active) {
    .button {
      border-color: ButtonText;
    }
    .button[aria-pressed="true"],
    .button[aria-checked="true"] {
      outline: 2px solid Highlight;
    }
    .button[aria-disabled="true"] {
      border-color: GrayText;
      color: GrayText;
    }
  }
`;

export const fields = css`
  .field {
    min-height: var(--touch);
    padding: 0 10px;
    border: 1px solid var(--edge);
    border-radius: 8px;
    background: var(--sheet);
    color: var(--ink);
    min-width: 0;
  }
  .field[aria-invalid="true"] {
    border-color: var(--warn);
    background: var(--warn-wash);
  }
  select.field {
    padding-right: 6px;
  }
`;

/** What unfolds: a heading with a word about it, and an arrow that says whether it is open. */
export const disclosure = css`
  summary {
    display: flex;
    align-items: center;
    gap: 10px;
    min-height: var(--touch);
    border-radius: 8px;
    cursor: pointer;
    list-style: none;
  }
  summary::-webkit-details-marker {
    display: none;
  }
  summary::after {
    content: "";
    flex: none;
    width: 7px;
    height: 7px;
    margin-left: auto;
    margin-right: 6px;
    border: solid var(--soft);
    border-width: 0 1.6px 1.6px 0;
    rotate: 45deg;
    translate: 0 -2px;
  }
  details:not([open]) > summary::after {
    rotate: -45deg;
    translate: 0;
  }
  h3 {
    font-size: 0.95rem;
    font-weight: 650;
  }
  summary span {
    color: var(--soft);
    font-size: 0.84rem;
  }
`;

/** A number that somebody points at elsewhere. */
export const pointed = css`
  pasu-number[data-pointed] {
    border-radius: 8px;
    background: var(--accent-wash);
    box-shadow: 0 0 0 4px var(--accent-wash);
    outline: 2px solid var(--accent);
    outline-offset: 4px;
  }
`;
