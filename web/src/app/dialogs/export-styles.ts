/** The looks of the export dialogue. */

import { css } from "lit";

export const exportStyles = css`
  .formats .choices {
    margin-top: 0;
  }
  .formats .choices div {
    grid-template-columns: repeat(auto-fill, minmax(min(5rem, 100%), 1fr));
    gap: 6px;
  }
  .formats .choices label {
    justify-items: center;
    padding: 4px 2px;
  }
  .hint {
    padding-top: 5px;
    color: var(--soft);
    font-size: 0.9rem;
    text-wrap: pretty;
  }
  .row {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(min(8.125rem, 100%), 1fr));
    gap: 4px 12px;
    padding-top: 14px;
  }
  /* Fields side by side stand on one line, where the name of one takes two. */
  .row label {
    display: grid;
    grid-row: span 3;
    grid-template-rows: subgrid;
    align-content: start;
    padding-bottom: 2px;
    font-size: 0.92rem;
  }
  .row .field {
    width: 100%;
  }
  .typed {
    position: relative;
    display: grid;
  }
  .typed .field {
    padding-right: 40px;
    font-variant-numeric: tabular-nums;
  }
  .typed.long .field {
    padding-right: 76px;
  }
  .unit {
    position: absolute;
    right: 11px;
    top: 50%;
    translate: 0 -50%;
    color: var(--soft);
    pointer-events: none;
  }
  ::placeholder {
    color: var(--soft);
    opacity: 1;
  }
  .wrong,
  .problem {
    color: var(--warn);
    font-size: 0.88rem;
  }
  .outcome {
    margin-top: 16px;
    padding: 10px 14px 12px;
    border-radius: 12px;
    background: var(--well);
  }
  dl {
    margin: 0;
  }
  dl div {
    display: flex;
    justify-content: space-between;
    gap: 14px;
    padding: 3px 0;
  }
  dt {
    color: var(--soft);
    white-space: nowrap;
  }
  dd {
    margin: 0;
    text-align: right;
    font-variant-numeric: tabular-nums;
  }
  .wait {
    color: var(--soft);
    animation: appear 0s 0.5s both;
  }
  .progress {
    flex: 1;
    font-size: 0.9rem;
  }
  .brief .sentences {
    padding: 0;
  }
  .progress span {
    display: block;
    animation: appear 0s 0.5s both;
  }
  .track {
    display: block;
    width: 100%;
    appearance: none;
    margin-top: 4px;
    height: 4px;
    border: none;
    border-radius: 2px;
    overflow: hidden;
    background: var(--line);
    animation: appear 0s 0.5s both;
  }
  .track:indeterminate {
    background: linear-gradient(90deg, var(--line) 40%, var(--accent) 50%, var(--line) 60%) 0 0 / 250% 100%;
    animation:
      appear 0s 0.5s both,
      flow 1.4s linear infinite;
  }
  .track::-webkit-progress-bar {
    background: transparent;
  }
  .track::-webkit-progress-value {
    background: var(--accent);
  }
  .track::-moz-progress-bar {
    background: var(--accent);
  }
  .track:indeterminate::-moz-progress-bar {
    background: transparent;
  }
  @keyframes flow {
    from {
      background-position: 100% 0;
    }
    to {
      background-position: 0 0;
    }
  }
  @keyframes appear {
    from {
      visibility: hidden;
    }
  }
`;
