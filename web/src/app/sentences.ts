/** Sentences with a sign of how grave they are, which is also said. */

import { css, html } from "lit";
import type { Sentence, Severity } from "../document/report-words";
import { type IconName, icon } from "../ui/icons";

const SIGNS: Readonly<Record<Severity, { readonly icon: IconName; readonly spoken: string }>> = {
  error: { icon: "close", spoken: "Fault: " },
  warning: { icon: "warn", spoken: "Mind: " },
  note: { icon: "more", spoken: "" },
  good: { icon: "check", spoken: "" },
};

export function sentences(all: readonly Sentence[]) {
  return html`<ul class="sentences">
    ${all.map(
      ({ severity, text }) => html`<li class=${severity}>
        ${icon(SIGNS[severity].icon)}<span><span class="spoken">${SIGNS[severity].spoken}</span>${text}</span>
      </li>`,
    )}
  </ul>`;
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
  .sentences .icon {
    width: 18px;
    height: 18px;
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
