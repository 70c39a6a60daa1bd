/** How the element looks: its colours are its own, and follow the page's only as far as a page says so. */

import { css } from "lit";

export const potStyles = css`
  :host {
    position: relative;
    display: inline-block;
    width: 300px;
    height: 300px;
    overflow: hidden;
    contain: content;
    vertical-align: bottom;
    text-align: start;
    --paper: light-dark(#f7f4ef, #1a1816);
    --sheet: light-dark(#fffdfa, #232120);
    --well: light-dark(#efeae2, #2d2a28);
    --line: light-dark(#e0d9ce, #3a3633);
    --edge: light-dark(#8d8478, #8a8178);
    --ink: var(--pasu-pot-color, light-dark(#2a2521, #efeae3));
    --soft: light-dark(#645b51, #b5aba0);
    --accent: var(--pasu-pot-accent, light-dark(#2c6a5c, #8fcab6));
    --accent-strong: var(--accent);
    --on-accent: light-dark(#ffffff, #10251f);
    --accent-wash: light-dark(#e2eee9, #2b3a35);
    --warn: light-dark(#9a3412, #f2a983);
    --warn-wash: light-dark(#fbeae2, #3d2a22);
    --shadow: light-dark(rgb(60 45 30 / 0.14), rgb(0 0 0 / 0.5));
    --radius: 10px;
    --touch: 36px;
    --wheel: 32px;
    --font: var(--pasu-pot-font, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif);
    --font-brand: "Iowan Old Style", "Palatino Linotype", Palatino, "URW Palladio L", "Book Antiqua", Georgia, serif;
    color: var(--ink);
    font: 15px / 1.45 var(--font);
  }
  :host([hidden]) {
    display: none;
  }
  :host([theme="light"]) {
    color-scheme: light;
  }
  :host([theme="dark"]) {
    color-scheme: dark;
  }
  @media (pointer: coarse) {
    :host {
      --touch: 44px;
    }
  }
  /* Tells the script which colours hold here; the transition, which is over as it begins, that a page has chosen others. */
  .probe {
    position: absolute;
    visibility: hidden;
    color: light-dark(#fff, #000);
    forced-color-adjust: none;
    transition: color 1ms step-start !important;
  }
  .frame {
    position: absolute;
    inset: 0;
    display: flex;
    flex-direction: column;
  }
  .view {
    position: relative;
    flex: 1 1 0;
    min-height: 0;
    background: var(--poster-color, var(--paper));
  }
  .stage,
  .still,
  .poster,
  .printed {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
  }
  .stage {
    user-select: none;
    -webkit-user-select: none;
    cursor: grab;
  }
  .stage:active {
    cursor: grabbing;
  }
  .stage:focus-visible {
    outline: none;
  }
  .stage:focus-visible::after {
    content: "";
    position: absolute;
    inset: 0;
    border: 2.5px solid var(--accent);
    pointer-events: none;
  }
  .poster {
    display: grid;
    background: var(--poster-color, var(--paper));
    transition: opacity 200ms;
    pointer-events: none;
  }
  .poster[data-done] {
    opacity: 0;
    visibility: hidden;
    transition:
      opacity 200ms,
      visibility 0s 200ms;
  }
  .poster img,
  .poster ::slotted(*) {
    width: 100%;
    height: 100%;
    min-height: 0;
    object-fit: contain;
  }
  .message,
  .hint {
    position: absolute;
    z-index: 2;
    inset: auto 10px 10px;
    width: fit-content;
    max-width: 46ch;
    margin-inline: auto;
    padding: 5px 11px;
    border-radius: 9px;
    background: var(--sheet);
    box-shadow: 0 2px 10px var(--shadow);
    font-size: 0.86rem;
    text-align: center;
    pointer-events: none;
  }
  .hint {
    inset: 0;
    height: fit-content;
    margin: auto;
    opacity: 0;
    transition: opacity 250ms;
  }
  .hint[data-shown] {
    opacity: 1;
  }
  .over {
    position: absolute;
    z-index: 1;
    inset: 0;
    pointer-events: none;
  }
  .over ::slotted(*) {
    pointer-events: auto;
  }
  .sliders {
    flex: 0 0 auto;
    max-height: 46%;
    overflow: auto;
  }
  /* The element may have another form on paper than it had on the screen. */
  .printed {
    display: none;
    object-fit: contain;
  }
  @media print {
    .printed {
      display: block;
    }
    .stage,
    .message,
    .hint,
    .wheel {
      visibility: hidden;
    }
  }
`;
