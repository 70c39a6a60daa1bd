/** Sentences with a sign of how grave they are, which is also said. */

import { css, html } from "lit";
import { type IconName, icon } from "../ui/icons";
import { page } from "../words/english/page";
import type { Sentence, Severity } from "../words/report";

export const SIGNS: Readonly<Record<Severity, IconName>> = {
  error: "close",
  warning: "warn",
  note: "more",
  good: "check",
};

export function sentences(all: readonly Sentence[]) {
  return html`<ul class="sentences">
    ${all.map(
      ({ severity, text }) => html`<li class=${severity}>
        ${icon(SIGNS[severity])}<span><span class="spoken">${spoken(severity)}</span>${text}</span>
      </li>`,
    )}
  </ul>`;
}

/** What is said before it. */
export function spoken(severity: Severity): string {
  return severity === "error" || severity === "warning" ? page.severities[severity] : "";
}

export const sentenceStyles = css`
  .sentences {
    display: grid;
    gap: 7px;
    padding-top: 6px;
  }
  .sentences li {
    display: flex;
    gap: 9px;
    text-wrap: pretty;
  }
  .sentences li > span {
    min-width: 0;
    overflow-wrap: anywhere;
  }
  .sentences .icon {
    width: 1.125rem;
    height: 1.125rem;
    margin-top: 2px;
    color: var(--accent);
  }
  .sentences .note .icon {
    color: var(--soft);
  }
  .sentences .warning .icon,
  .sentences .error .icon,
  .sentences .error {
    color: var(--warn);
  }
`;
