/** The button that shows what every number of a panel does, and hides it. */

import { html, type TemplateResult } from "lit";
import { parameters } from "../../words/english/parameters";

export function explainButton(isExplained: boolean, toggle: () => void): TemplateResult {
  return html`<button
    class="button outlined"
    type="button"
    aria-pressed=${isExplained ? "true" : "false"}
    @click=${toggle}
  >
    ${parameters.explain}
  </button>`;
}
