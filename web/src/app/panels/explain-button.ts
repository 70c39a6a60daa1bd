/** The button that shows what every number of a panel does, and hides it. */

import { html, type TemplateResult } from "lit";
import { toggleExplain } from "../../state/actions";
import { parameters } from "../../words/english/parameters";
import type { Designer } from "../../work/designer";

export function explainButton(designer: Designer): TemplateResult {
  return html`<button
    class="button outlined"
    type="button"
    aria-pressed=${designer.state.session.explain ? "true" : "false"}
    @click=${() => designer.apply(toggleExplain(designer.state))}
  >
    ${parameters.explain}
  </button>`;
}
